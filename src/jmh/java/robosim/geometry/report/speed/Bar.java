package robosim.geometry.report.speed;

import java.io.Console;
import java.io.PrintStream;
import java.util.Locale;

/** How far a run is: a bar that moves on a terminal, a line for each part where nobody watches. */
final class Bar {
    private static final int WIDTH = 30;

    private final PrintStream out;
    private final boolean isWatched;
    private final double whole;
    private final long start = System.nanoTime();
    private double done;
    private String shown = "";

    /**
     * A bar for parts that weigh so much together.
     *
     * @param isWatched whether what is written last can be written over
     */
    Bar(PrintStream out, boolean isWatched, double whole) {
        this.out = out;
        this.isWatched = isWatched;
        this.whole = whole;
    }

    /** Shows how far a part of a weight is. */
    void show(String part, double weight, double share) {
        if (isWatched) {
            double now = (done + weight * share) / whole;
            int full = (int) Math.round(WIDTH * now);
            String bar = String.format(
                    Locale.ROOT, "[%s%s] %3.0f %%  %s", "#".repeat(full), ".".repeat(WIDTH - full), 100 * now, part);
            if (!bar.equals(shown)) {
                out.print("\r" + bar + " ".repeat(Math.max(0, shown.length() - bar.length())));
                out.flush();
                shown = bar;
            }
        }
    }

    /** A part is done. */
    void finish(String part, double weight) {
        done += weight;
        if (isWatched) {
            show(part, 0, 0);
        } else {
            out.println(String.format(
                    Locale.ROOT,
                    "%3.0f %%  %s, %.0f s after the start",
                    100 * done / whole,
                    part,
                    (System.nanoTime() - start) * 1e-9));
        }
    }

    /** Leaves the line. */
    void end() {
        if (isWatched) {
            out.println();
        }
    }

    /** Whether this process writes to a terminal. */
    static boolean isTerminal() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            // From Java 22 on there may be a console without a terminal, and this method tells.
            return (boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException before22) {
            return true;
        }
    }
}
