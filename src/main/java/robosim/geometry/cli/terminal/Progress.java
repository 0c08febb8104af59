package robosim.geometry.cli.terminal;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.Supplier;
import picocli.CommandLine;

/**
 * Tells on the standard error how far a long work is: as a bar where its size is known, else as a count. One line that is
 * drawn over; nothing at all where nobody watches, and nothing of a work that is done in half a second.
 *
 * <pre>{@code
 * try (Progress progress = Progress.of(spec.commandLine(), "rays", count)) {
 *     for (long k = 0; k < count; k++) {
 *         progress.at(k);
 *         ...
 *     }
 * }
 * }</pre>
 *
 * May be told from any number of threads.
 */
public final class Progress implements AutoCloseable {
    private static final int CELLS = 24;
    private static final long QUIET_NANOS = 500_000_000;
    private static final long BETWEEN_NANOS = 200_000_000;
    private static final String ERASED = "\r\033[K";

    private final PrintWriter err;
    private final boolean watched;
    private final String work;
    private final long total;
    private volatile long next = System.nanoTime() + QUIET_NANOS;
    private boolean drawn;

    private Progress(PrintWriter err, boolean watched, String work, long total) {
        this.err = err;
        this.watched = watched;
        this.work = work;
        this.total = total;
    }

    /**
     * Tells nothing yet.
     *
     * @param work  what is done or counted, in a word or two
     * @param total how much there is of it; 0 where that is not known
     */
    public static Progress of(CommandLine line, String work, long total) {
        return new Progress(line.getErr(), Terminal.shows(line), work, total);
    }

    /** One that is watched, whatever the standard error is. */
    public static Progress shown(PrintWriter err, String work, long total) {
        Progress progress = new Progress(err, true, work, total);
        progress.next = System.nanoTime();
        return progress;
    }

    /** So much is done. Costs a look at the clock, and draws at most five times a second. */
    public void at(long done) {
        at(done, () -> "");
    }

    /**
     * So much is done.
     *
     * @param note what is at hand, behind the bar, asked only where it is drawn; may be empty
     */
    public void at(long done, Supplier<String> note) {
        if (watched && System.nanoTime() - next >= 0) {
            draw(done, note.get());
        }
    }

    private synchronized void draw(long done, String note) {
        next = System.nanoTime() + BETWEEN_NANOS;
        drawn = true;
        err.print(ERASED + text(done, note));
        err.flush();
    }

    private String text(long done, String note) {
        String behind = note.isEmpty() ? "" : "  " + note;
        if (total < 1) {
            return String.format(Locale.ROOT, "%s: %,d%s", work, done, behind);
        }
        double share = Math.min(1, Math.max(0, (double) done / total));
        int full = (int) (share * CELLS);
        return String.format(
                Locale.ROOT,
                "%s [%s%s] %3d %%%s",
                work,
                "#".repeat(full),
                ".".repeat(CELLS - full),
                (int) (share * 100),
                behind);
    }

    /** Takes the line away, so that something else can be written. The next {@link #at} draws it again. */
    public synchronized void clear() {
        if (drawn) {
            drawn = false;
            err.print(ERASED);
            err.flush();
        }
    }

    /** Takes the line away for good. */
    @Override
    public void close() {
        clear();
    }
}
