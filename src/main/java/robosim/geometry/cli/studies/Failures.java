package robosim.geometry.cli.studies;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import robosim.geometry.check.NumberText;
import robosim.geometry.check.Text;
import robosim.geometry.sweep.Outcome;

/** Why replicates of a sweep failed: the first few distinct errors, each with the first replicate that it came from. */
public final class Failures implements Consumer<Outcome> {
    /** How many distinct errors are listed; the rest are counted. */
    private static final int TOLD = 3;

    private final Map<String, Failure> told = new LinkedHashMap<>();
    private long all;

    /** One error: how often it occurred, and where first. */
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

    /** Whether any replicate failed. */
    boolean areThere() {
        return all > 0;
    }

    /** Prints them; prints nothing if none failed. */
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
        out.println("For the full errors, see the lines in the results whose \"type\" is \"failure\".");
    }

    /** Which replicate, by the field names of its line in the results. */
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
