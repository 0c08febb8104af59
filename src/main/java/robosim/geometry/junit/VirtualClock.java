package robosim.geometry.junit;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;

/**
 * Time that goes on in steps of a set length when it is told to, and at no other moment. It begins at the epoch, and is a
 * {@link Clock} for programs that take one.
 */
public final class VirtualClock extends Clock {
    private final Duration step;
    private final List<Runnable> behaviours = new ArrayList<>();
    private long steps;

    VirtualClock(Duration step) {
        if (step.isNegative() || step.isZero()) {
            throw new IllegalArgumentException("a step of the clock must be longer than nothing (got: " + step + ")");
        }
        this.step = step;
    }

    /** How long a step is. */
    public Duration step() {
        return step;
    }

    /** How many steps there were. */
    public long steps() {
        return steps;
    }

    /** How long it has been running. */
    public Duration elapsed() {
        return step.multipliedBy(steps);
    }

    /** A step: the time goes on, then each {@linkplain Robot#follows behaviour} acts once, in the order of their robots. */
    public void advance() {
        steps++;
        for (Runnable behaviour : List.copyOf(behaviours)) {
            behaviour.run();
        }
    }

    /** So many steps. */
    public void advance(int count) {
        if (count < 0) {
            throw new IllegalArgumentException("count must be at least 0 (got: " + count + ")");
        }
        for (int k = 0; k < count; k++) {
            advance();
        }
    }

    void each(Runnable behaviour) {
        behaviours.add(behaviour);
    }

    boolean isIdle() {
        return behaviours.isEmpty();
    }

    @Override
    public Instant instant() {
        return Instant.EPOCH.plus(elapsed());
    }

    @Override
    public ZoneId getZone() {
        return ZoneOffset.UTC;
    }

    /** A view of this clock, which goes on with it. */
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
