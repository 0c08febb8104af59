package robosim.geometry.collision;

import java.time.Duration;

/**
 * The cost limits of a query: it ends when either limit is reached.
 *
 * @param steps maximum number of steps, at least 0. A step examines one pair: of boxes around pieces of the objects, of
 *     pieces themselves, or of a point and a solid mesh. The same number of steps always gives the same answer
 * @param time maximum duration, at least 0; checked before the first step and then after every sixteenth. How much is
 *     known when the time is up depends on the machine; that it is true does not
 */
public record Budget(long steps, Duration time) {
    /** More than 292 years: no limit in practice. */
    private static final Duration EVER = Duration.ofNanos(Long.MAX_VALUE);

    /** No limit: the query always ends with an answer. */
    public static final Budget UNLIMITED = new Budget(Long.MAX_VALUE, EVER);

    public Budget {
        if (steps < 0) {
            throw new IllegalArgumentException("steps must be at least 0 (got: " + steps + ")");
        }
        if (time == null || time.isNegative()) {
            throw new IllegalArgumentException("time must be at least 0 (got: " + time + ")");
        }
    }

    /** A limit of steps, whatever time they take. */
    public static Budget steps(long steps) {
        return new Budget(steps, EVER);
    }

    /** A limit of time, whatever the number of steps. */
    public static Budget time(Duration time) {
        return new Budget(Long.MAX_VALUE, time);
    }

    /** The time limit in nanoseconds. */
    long nanos() {
        return time.compareTo(EVER) < 0 ? time.toNanos() : Long.MAX_VALUE;
    }
}
