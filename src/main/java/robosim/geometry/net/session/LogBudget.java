package robosim.geometry.net.session;

import java.util.function.LongSupplier;

/**
 * Limits the rate of log lines: a number at once, then a number per second. Lines beyond that are only counted, and the
 * count is added to the next line written.
 */
public final class LogBudget {
    /** The limit of one server or client, over all its connections: in the worst case some 7 kB a second. */
    private static final int LINES = 2000;

    private static final int LINES_A_SECOND = 10;
    private static final long SECOND = 1_000_000_000;

    private final LongSupplier clock;
    private long full;
    private long leftOut;

    /** Takes a clock like {@link System#nanoTime}. */
    public LogBudget(LongSupplier clock) {
        this.clock = clock;
        this.full = clock.getAsLong();
    }

    /**
     * Claims the right to write one line.
     *
     * @return how many lines were left out before this one; -1 if this one must be left out too
     */
    public synchronized long take() {
        long now = clock.getAsLong();
        long line = SECOND / LINES_A_SECOND;
        if (full - now < 0) {
            full = now;
        }
        if (full - now > line * (LINES - 1L)) {
            leftOut++;
            return -1;
        }
        full += line;
        long before = leftOut;
        leftOut = 0;
        return before;
    }

    /** Writes a line, or only counts it. */
    public void log(System.Logger log, System.Logger.Level level, String words) {
        long before = take();
        if (before >= 0) {
            log.log(level, before == 0 ? words : words + " (" + before + " lines before this one were not logged)");
        }
    }
}
