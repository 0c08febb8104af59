package robosim.geometry.sweep;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.json.JsonRecord;
import robosim.geometry.sweep.lines.ChecksummedLine;

/**
 * The header of a file of results, which identifies the sweep.
 *
 * @param scenario   the scenario's name
 * @param print      the scenario's fingerprint, which tells it from another of that name; may be empty, see {@link
 *     SweepScenario#fingerprint()}
 * @param seed       the root seed
 * @param replicates number of replicates of each cell
 * @param worlds     by name, a digest of each world's objects
 * @param parameters by name, the values with commas between them
 */
public record SweepHeader(
        String scenario,
        String print,
        long seed,
        long replicates,
        Map<String, String> worlds,
        Map<String, String> parameters) {
    /** The version of the format. */
    public static final int VERSION = 1;

    private static final long MOST = 1L << 53;

    /** The number of replicates of the whole sweep. */
    public long size() {
        long cells = worlds.size();
        for (String values : parameters.values()) {
            cells *= values.split(",", -1).length;
        }
        return cells * replicates;
    }

    /** Whether another sweep is the same except for the number of replicates of each cell. */
    public boolean isOfSame(SweepHeader other) {
        Checks.present("other", other);
        return line(0).equals(other.line(0));
    }

    /**
     * The digest of outcomes of this sweep, 64 hexadecimal digits: see {@code docs/sweep.md}.
     *
     * @param outcomes by ascending index
     */
    public String digest(Iterable<Outcome> outcomes) {
        Checks.present("outcomes", outcomes);
        SweepDigest digest = new SweepDigest(this);
        outcomes.forEach(digest::add);
        return digest.hex();
    }

    /** How another sweep differs, in words that can follow "it has". */
    String differences(SweepHeader other) {
        List<String> differences = new ArrayList<>();
        differ(differences, "scenario", scenario, other.scenario);
        differ(differences, "fingerprint", print, other.print);
        differ(differences, "seed", Outcome.hex(seed), Outcome.hex(other.seed));
        differ(
                differences,
                "worlds",
                worlds.keySet().toString(),
                other.worlds.keySet().toString());
        for (String world : worlds.keySet()) {
            String print = other.worlds.get(world);
            if (print != null && !print.equals(worlds.get(world))) {
                differences.add("another world of the name " + world);
            }
        }
        differ(differences, "parameters", parameters.toString(), other.parameters.toString());
        return String.join(", ", differences);
    }

    private static void differ(List<String> differences, String what, String own, String other) {
        if (!own.equals(other)) {
            differences.add("the " + what + " " + own + " and not " + other);
        }
    }

    /** Refuses an outcome whose index, world, values, replicate and seed do not belong together in this sweep. */
    void check(Outcome outcome) {
        long cells = size() / replicates;
        if (cells < 1) {
            throw new IllegalArgumentException("a sweep must have at least one world (got: none)");
        }
        long rest = outcome.index() % cells;
        List<String> names = List.copyOf(worlds.keySet());
        String world = names.get((int) (rest % names.size()));
        rest /= names.size();
        SortedMap<String, String> values = new TreeMap<>();
        for (Map.Entry<String, String> parameter : new TreeMap<>(parameters).entrySet()) {
            String[] all = parameter.getValue().split(",", -1);
            values.put(parameter.getKey(), all[(int) (rest % all.length)]);
            rest /= all.length;
        }
        long replicate = outcome.index() / cells;
        expect("world", world, outcome.world(), outcome);
        expect("parameters", values.toString(), new TreeMap<>(outcome.parameters()).toString(), outcome);
        expect("replicate", String.valueOf(replicate), String.valueOf(outcome.replicate()), outcome);
        String own = Outcome.hex(Seeds.of(seed, scenario, world, values, replicate));
        expect("seed", own, Outcome.hex(outcome.seed()), outcome);
    }

    private static void expect(String what, String own, String given, Outcome outcome) {
        if (!own.equals(given)) {
            throw new IllegalArgumentException(what + " of the result with index " + outcome.index() + " must be " + own
                    + " in this sweep (got: " + given + ")");
        }
    }

    /** The first line of a file of results, with its checksum. */
    public String sealed() {
        return ChecksummedLine.seal(line());
    }

    /**
     * Refuses a header that could be written but not read again: the values of a parameter may be too long together.
     */
    void check() {
        try {
            if (equals(of(JsonRecord.read(line())))) {
                return;
            }
        } catch (ProtocolException e) {
            throw new IllegalArgumentException(
                    "the header of a file of results must be readable again; " + e.getMessage(), e);
        }
        throw new IllegalArgumentException(
                "the header of a file of results must be readable again (got: " + this + ")");
    }

    /** The line of a file, without its checksum. */
    String line() {
        return line(replicates);
    }

    private String line(long number) {
        return JsonRecord.line(
                "type", "sweep",
                "version", VERSION,
                "scenario", scenario,
                "fingerprint", print,
                "seed", Outcome.hex(seed),
                "replicates", number,
                "worlds", worlds,
                "parameters", parameters);
    }

    static SweepHeader of(JsonRecord line) throws ProtocolException {
        line.only("type version scenario fingerprint seed replicates worlds parameters", "");
        if (line.number("version") != VERSION) {
            throw line.refused("version must be " + VERSION + " (got: " + line.number("version") + ")");
        }
        return new SweepHeader(
                line.text("scenario"),
                line.text("fingerprint"),
                Outcome.unhex(line, "seed"),
                line.whole("replicates", 1, MOST),
                texts(line.record("worlds")),
                texts(line.record("parameters")));
    }

    static Map<String, String> texts(JsonRecord record) throws ProtocolException {
        Map<String, String> texts = new LinkedHashMap<>();
        for (String name : record.names()) {
            texts.put(name, record.text(name));
        }
        return texts;
    }
}
