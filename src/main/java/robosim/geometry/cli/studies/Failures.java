package robosim.geometry.cli.studies;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import robosim.geometry.exact.NumberText;
import robosim.geometry.protocol.Text;
import robosim.geometry.sweep.Outcome;

/** Why the replicates of a sweep failed: the first few errors that are not the same, each with who came upon it first. */
public final class Failures implements Consumer<Outcome> {
    /** Errors that are told; the rest is counted. */
    private static final int TOLD = 3;

    private final Map<String, Failure> told = new LinkedHashMap<>();
    private long all;

    /** One error: how often it came, and where first. */
    private static final class Failure {
        final Outcome first;
        long times;

        Failure(Outcome first) {
            this.first = first;
        }
    }

    @Override
    public void accept(Outcome outcome) {
        String error = outcome.error();
        if (error == null) {
            return;
        }
        all++;
        Failure failure = told.get(error);
        if (failure == null && told.size() < TOLD) {
            failure = new Failure(outcome);
            told.put(error, failure);
        }
        if (failure != null) {
            failure.times++;
        }
    }

    /** Whether any failed. */
    boolean areThere() {
        return all > 0;
    }

    /** Tells them; nothing where none failed. */
    void tell(PrintWriter out) {
        if (all == 0) {
            return;
        }
        out.println(NumberText.count(all, "replicate") + " failed:");
        long rest = all;
        for (Map.Entry<String, Failure> entry : told.entrySet()) {
            Failure failure = entry.getValue();
            rest -= failure.times;
            out.println("  " + Text.line(firstLine(entry.getKey())));
            out.println("    " + (failure.times == 1 ? "in " : NumberText.count(failure.times, "time") + ", first in ")
                    + place(failure.first));
        }
        if (rest > 0) {
            out.printf(Locale.ROOT, "  and %,d with other errors%n", rest);
        }
        out.println("The lines in the results whose \"type\" is \"failure\" tell all of it.");
    }

    /** Which replicate, in the words of its line in the results. */
    private static String place(Outcome outcome) {
        StringBuilder values = new StringBuilder();
        new TreeMap<>(outcome.parameters())
                .forEach((name, value) ->
                        values.append(", ").append(name).append('=').append(value));
        return "index " + outcome.index() + ": world " + Text.line(outcome.world() + values) + ", replicate "
                + outcome.replicate() + String.format(Locale.ROOT, ", seed 0x%016x", outcome.seed());
    }

    /** A failed assertion may have a message of many lines. */
    private static String firstLine(String error) {
        String text = error.strip();
        int end = text.indexOf('\n');
        return end < 0 ? text : text.substring(0, end).strip() + " ...";
    }
}
