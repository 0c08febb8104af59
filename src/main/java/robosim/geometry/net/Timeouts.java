package robosim.geometry.net;

import java.time.Duration;
import robosim.geometry.exact.Checks;

/**
 * How long to wait for a peer; each from a millisecond to a day.
 *
 * @param stall   how long a message that has begun may pause, in or out, and how long dialling may take
 * @param message how long a message may take from its first byte to its last, either way
 * @param idle    how long a peer may be silent between two messages
 */
public record Timeouts(Duration stall, Duration message, Duration idle) {
    private static final Duration LONGEST = Duration.ofDays(1);

    /** 10 seconds for a pause, 60 for a message, a day between two, since a simulation may be halted overnight. */
    public static final Timeouts DEFAULT = new Timeouts(Duration.ofSeconds(10), Duration.ofSeconds(60), LONGEST);

    /** Refuses null and times out of range. */
    public Timeouts {
        Checks.time("stall", stall, LONGEST);
        Checks.time("message", message, LONGEST);
        Checks.time("idle", idle, LONGEST);
    }

    /** The shortest time within a message. */
    Duration finest() {
        return stall.compareTo(message) < 0 ? stall : message;
    }
}
