package robosim.geometry.net.session;

import java.util.function.LongSupplier;

/**
 * How many lines a log may get: so many at once, then so many a second. What is beyond is counted, and the count told with
 * the next line that is written.
 */
public final class LogBudget {
    /** Of one end, over all its connections: some 7 kB a second for ever, where peers do all they can. */
    private static final int LINES = 2000;

    private static final int LINES_A_SECOND = 10;
    private static final long SECOND = 1_000_000_000;

    private final LongSupplier clock;
    private long full;
    private long leftOut;

    /** A clock as {@link System#nanoTime}. */
    public LogBudget(LongSupplier clock) {
        this.clock = clock;
        this.full = clock.getAsLong();
    }

    /**
     * Takes a line's place.
     *
     * @return how many lines were left out before this one; -1 where this one is left out too
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

    /** Writes a line, or counts it. */
    public void log(System.Logger log, System.Logger.Level level, String words) {
        long before = take();
        if (before >= 0) {
            log.log(level, before == 0 ? words : words + " (" + before + " lines before this one were not logged)");
        }
    }
}
