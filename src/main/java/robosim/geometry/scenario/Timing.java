package robosim.geometry.scenario;

import robosim.geometry.check.Checks;

/**
 * When a request was carried out; for people and viewers, never compared.
 *
 * @param at   nanoseconds since the beginning of the recording
 * @param took nanoseconds of work, without reading and writing
 */
public record Timing(long at, long took) {
    /** The longest time, some 104 days: the largest that a double can hold to the nanosecond. */
    public static final long MOST = 1L << 53;

    /** Refuses times below 0 or above {@link #MOST}. */
    public Timing {
        check("at", at);
        check("took", took);
    }

    private static void check(String argument, long nanoseconds) {
        Checks.refuse(
                nanoseconds < 0 || nanoseconds > MOST,
                argument + " must be 0 to " + MOST + " nanoseconds",
                nanoseconds);
    }
}
