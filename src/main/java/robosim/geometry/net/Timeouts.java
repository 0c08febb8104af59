package robosim.geometry.net;

import java.time.Duration;
import robosim.geometry.check.Checks;

/**
 * How long to wait for a peer; each from a millisecond to a day, {@code resume} also zero.
 *
 * @param stall   how long a message that has begun may pause, in or out, and how long dialling may take
 * @param message how long a message may take from its first byte to its last, either way
 * @param idle    how long a peer may be silent between two messages
 * @param admission how long a server waits for a new peer in all: for TLS, its secret and its first message, or the first
 *     256 kB of it
 * @param resume how long the session of a dropped connection is kept for a JSON peer that asked for that; zero for not at all
 */
record Timeouts(Duration stall, Duration message, Duration idle, Duration admission, Duration resume) {
    private static final Duration LONGEST = Duration.ofDays(1);

    /** A handshake over a slow line takes half a second; and a peer that connects has a world to send. */
    private static final Duration ADMISSION = Duration.ofSeconds(10);

    /** 10 seconds for a pause, 60 for a message, a day between two, since a simulation may be halted overnight. */
    public static final Timeouts DEFAULT = new Timeouts(Duration.ofSeconds(10), Duration.ofSeconds(60), LONGEST);

    /** Times with 10 seconds for an admission. */
    public Timeouts(Duration stall, Duration message, Duration idle) {
        this(stall, message, idle, ADMISSION);
    }

    /** Times with no session kept. */
    public Timeouts(Duration stall, Duration message, Duration idle, Duration admission) {
        this(stall, message, idle, admission, Duration.ZERO);
    }

    /** These times with sessions kept for a while, or not at all. */
    public Timeouts withResume(Duration time) {
        return new Timeouts(stall, message, idle, admission, time);
    }

    /** Refuses null and times out of range. */
    public Timeouts {
        Checks.time("stall", stall, LONGEST);
        Checks.time("message", message, LONGEST);
        Checks.time("idle", idle, LONGEST);
        Checks.time("admission", admission, LONGEST);
        if (!Checks.present("resume", resume).isZero()) {
            Checks.time("resume", resume, LONGEST);
        }
    }

    /** The shortest time that a peer is waited for. */
    Duration finest() {
        Duration within = stall.compareTo(message) < 0 ? stall : message;
        return within.compareTo(admission) < 0 ? within : admission;
    }
}
