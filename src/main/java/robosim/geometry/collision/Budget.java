package robosim.geometry.collision;

import java.time.Duration;

/**
 * How much a question may cost: whichever limit is reached first ends it.
 *
 * @param steps how many steps may be taken, at least 0. A step looks at one pair: of boxes around pieces of the objects,
 *     of pieces themselves, or of a point and a solid mesh. The same number of steps always gives the same answer
 * @param time how long it may take, at least 0; looked at before the first and then after every sixteenth step. What
 *     is known when the time is up depends on the machine; it is true on all
 */
public record Budget(long steps, Duration time) {
    /** More than 292 years, which is no limit. */
    private static final Duration EVER = Duration.ofNanos(Long.MAX_VALUE);

    /** No limit: the question ends with an answer. */
    public static final Budget UNLIMITED = new Budget(Long.MAX_VALUE, EVER);

    public Budget {
        if (steps < 0) {
            throw new IllegalArgumentException("steps must be at least 0 (got: " + steps + ")");
        }
        if (time == null || time.isNegative()) {
            throw new IllegalArgumentException("time must be at least 0 (got: " + time + ")");
        }
    }

    /** So many steps, however long they take. */
    public static Budget steps(long steps) {
        return new Budget(steps, EVER);
    }

    /** So long, however many steps that makes. */
    public static Budget time(Duration time) {
        return new Budget(Long.MAX_VALUE, time);
    }

    /** In nanoseconds. */
    long nanos() {
        return time.compareTo(EVER) < 0 ? time.toNanos() : Long.MAX_VALUE;
    }
}
