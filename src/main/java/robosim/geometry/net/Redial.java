package robosim.geometry.net;

import java.time.Duration;
import java.util.random.RandomGenerator;
import robosim.geometry.exact.Checks;

/**
 * How a client that has lost its environment, or has not found it, dials again: the pause doubles with every attempt that
 * led to no answered request, and of each pause a random share of up to a half is left out, so that many clients of one
 * environment do not come back all at once.
 *
 * @param first   the pause before the second attempt, at least a millisecond
 * @param longest where the doubling ends, from {@code first} to a day
 */
public record Redial(Duration first, Duration longest) {
    /** From half a second to half a minute. */
    public static final Redial DEFAULT = new Redial(Duration.ofMillis(500), Duration.ofSeconds(30));

    /** Refuses null and times out of range. */
    public Redial {
        Checks.time("first", first, Duration.ofDays(1));
        Checks.time("longest", longest, Duration.ofDays(1));
        if (longest.compareTo(first) < 0) {
            throw new IllegalArgumentException("longest must be at least first, " + first + " (got: " + longest + ")");
        }
    }

    /** The pause after so many attempts in a row that came to nothing. */
    Duration pause(int failures, RandomGenerator random) {
        long most = longest.toNanos();
        int doublings = Math.min(failures, Long.SIZE - 2);
        long whole =
                first.toNanos() > most >> doublings ? most : first.toNanos() << doublings; // which may not overflow
        return Duration.ofNanos((long) (whole * (1 - random.nextDouble() / 2)));
    }
}
