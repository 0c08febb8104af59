package robosim.geometry.sweep;

import java.util.Map;
import java.util.TreeMap;
import robosim.geometry.check.Checks;
import robosim.geometry.sweep.lines.Fingerprint;

/**
 * A digest of a sweep's results: the same on any machine and for any division into shards. It covers the header and
 * each outcome in the order of their indices, numbers by their bits.
 */
final class SweepDigest {
    private final Fingerprint print = new Fingerprint();
    private long last = -1;

    /** A digest of a sweep's header, without outcomes yet. */
    SweepDigest(SweepHeader header) {
        Checks.present("header", header);
        print.add(header.scenario()).add(header.print()).add(header.seed()).add(header.replicates());
        add(header.worlds());
        add(header.parameters());
    }

    private void add(Map<String, String> texts) {
        print.add(texts.size());
        texts.forEach((name, text) -> print.add(name).add(text));
    }

    /** Adds the next outcome. */
    void add(Outcome outcome) {
        Checks.present("outcome", outcome);
        if (outcome.index() <= last) {
            throw new IllegalArgumentException(
                    "outcomes must come by ascending index (got: " + outcome.index() + " after " + last + ")");
        }
        last = outcome.index();
        print.add(outcome.index()).add(outcome.world());
        add(new TreeMap<>(outcome.parameters()));
        print.add(outcome.replicate()).add(outcome.seed());
        print.add(outcome.values().size());
        outcome.values().forEach((name, value) -> print.add(name).add(value));
        String error = outcome.error();
        print.add(error == null ? "" : error);
    }

    /** The digest, 64 hexadecimal digits; nothing can be added after that. */
    String hex() {
        return print.hex();
    }
}
