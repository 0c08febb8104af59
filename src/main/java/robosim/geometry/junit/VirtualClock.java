package robosim.geometry.junit;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * A clock that advances in steps of a fixed length, and only when told to. It begins at the epoch, and is a {@link
 * Clock} for programs that take one.
 */
public final class VirtualClock extends Clock {
    private final Duration step;
    private final List<Runnable> behaviours = new ArrayList<>();
    private @Nullable Runnable bodies;
    private long steps;

    VirtualClock(Duration step) {
        Checks.refuse(step.isNegative() || step.isZero(), "a step of the clock must be longer than nothing", step);
        this.step = step;
    }

    /** The length of a step. */
    public Duration step() {
        return step;
    }

    /** The number of steps so far. */
    public long steps() {
        return steps;
    }

    /** The time since it began. */
    public Duration elapsed() {
        return step.multipliedBy(steps);
    }

    /**
     * Makes a step: advances the time, then runs each {@linkplain Robot#follows behaviour} once, in the order of the
     * robots, then lets bodies move, if there are any.
     */
    public void advance() {
        steps++;
        for (Runnable behaviour : List.copyOf(behaviours)) {
            behaviour.run();
        }
        if (bodies != null) {
            bodies.run();
        }
    }

    /** Makes a number of steps. */
    public void advance(int count) {
        Checks.refuse(count < 0, "count must be at least 0", count);
        for (int k = 0; k < count; k++) {
            advance();
        }
    }

    void each(Runnable behaviour) {
        behaviours.add(behaviour);
    }

    /** Sets what moves bodies in each step. */
    void moving(Runnable all) {
        bodies = all;
    }

    boolean isIdle() {
        return behaviours.isEmpty() && bodies == null;
    }

    @Override
    public Instant instant() {
        return Instant.EPOCH.plus(elapsed());
    }

    @Override
    public ZoneId getZone() {
        return ZoneOffset.UTC;
    }

    /** A view of this clock in another time zone. */
    @Override
    public Clock withZone(ZoneId zone) {
        VirtualClock time = this;
        return new Clock() {
            @Override
            public Instant instant() {
                return time.instant();
            }

            @Override
            public ZoneId getZone() {
                return zone;
            }

            @Override
            public Clock withZone(ZoneId other) {
                return time.withZone(other);
            }
        };
    }
}
