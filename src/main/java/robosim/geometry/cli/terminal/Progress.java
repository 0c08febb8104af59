package robosim.geometry.cli.terminal;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.Supplier;
import picocli.CommandLine;

/**
 * Shows on the standard error how far a long task is: as a bar if its size is known, else as a count. The one line is
 * redrawn in place. Nothing is shown if the standard error is not a terminal, or for a task that takes less than half a
 * second.
 *
 * May be updated from any number of threads.
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
     * Starts a task; shows nothing yet.
     *
     * @param work what is done or counted, in a word or two
     * @param total the size of the task; 0 if unknown
     */
    public static Progress of(CommandLine line, String work, long total) {
        return new Progress(line.getErr(), Terminal.shows(line), work, total);
    }

    /** A progress line that is shown whether or not the standard error is a terminal. */
    public static Progress shown(PrintWriter err, String work, long total) {
        Progress progress = new Progress(err, true, work, total);
        progress.next = System.nanoTime();
        return progress;
    }

    /** Reports how much is done. Reads the clock, and redraws at most five times a second. */
    public void at(long done) {
        at(done, () -> "");
    }

    /** Reports how much is done; the note, which may be empty, is made only when the line is drawn. */
    public void at(long done, Supplier<String> note) {
        if (watched && System.nanoTime() - next >= 0) {
            draw(done, note.get());
        }
    }

    private synchronized void draw(long done, String note) {
        next = System.nanoTime() + BETWEEN_NANOS;
        drawn = true;
        erase();
        err.print(text(done, note));
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

    /** Erases the line, so that something else can be written. The next {@link #at} draws it again. */
    public synchronized void clear() {
        if (drawn) {
            drawn = false;
            erase();
            err.flush();
        }
    }

    private void erase() {
        if (err instanceof PlainPrinter terminal) {
            terminal.control(ERASED);
        } else {
            err.print(ERASED);
        }
    }

    /** Erases the line for good. */
    @Override
    public void close() {
        clear();
    }
}
