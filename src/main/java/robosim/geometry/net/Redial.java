package robosim.geometry.net;

import java.time.Duration;
import java.util.random.RandomGenerator;
import robosim.geometry.check.Checks;

/**
 * How a client dials again after it has lost its environment or could not reach it. The pause doubles with every
 * attempt in which no request was answered. Each pause is shortened by a random part of up to a half, so that many
 * clients of one environment do not return all at once.
 *
 * @param first   the pause before the second attempt, at least a millisecond
 * @param longest the largest pause before it is shortened, from {@code first} to a day
 */
record Redial(Duration first, Duration longest) {
    /** Pauses from half a second to half a minute. */
    public static final Redial DEFAULT = new Redial(Duration.ofMillis(500), Duration.ofSeconds(30));

    /** Refuses null and times out of range. */
    public Redial {
        Checks.time("first", first, Duration.ofDays(1));
        Checks.time("longest", longest, Duration.ofDays(1));
        Checks.refuse(longest.compareTo(first) < 0, "longest must be at least first, " + first, longest);
    }

    /** The pause after a number of consecutive failed attempts. */
    Duration pause(int failures, RandomGenerator random) {
        long most = longest.toNanos();
        int doublings = Math.min(failures, Long.SIZE - 2);
        long whole =
                first.toNanos() > most >> doublings ? most : first.toNanos() << doublings; // which may not overflow
        return Duration.ofNanos((long) (whole * (1 - random.nextDouble() / 2)));
    }
}
