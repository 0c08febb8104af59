package robosim.geometry;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.WorkCounter;

/**
 * A limit of the work of each call: {@link Geometry#limitWork} gives it to a world. A call that would exceed it throws a {@link
 * WorkLimitException}, and the world is as it was before the call, to the bit.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry(20, 5, 20);
 * geometry.addObject(new BoxObject(new Point(4, 0, 0), 0.2, 2, 6));
 * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
 * geometry.limitWork(WorkLimit.of(1_000_000));
 * geometry.move("robot", new Move(2, 0, 0, 0, 90)).allowed();  // true: it takes a few units
 * geometry.workDone() < 1000;                                  // true
 * }</pre>
 *
 * <p>Work is counted, not timed, so the same call in the same world always takes the same number of units, on every machine; other
 * versions of this module may count differently. A unit is about one pair that is looked at, of boxes, of pieces, or of a ray and
 * a piece, or one step of an iteration, as in {@link robosim.geometry.collision.Budget}: mostly 0.1 to 10 microseconds. Adding an
 * object takes one for each of its triangles, members or 64 cells, for the trees that are built of them at their first use.
 * {@link Geometry#workDone} returns the number of units that a call took. Each call starts with all units; one that is made of others, such as a step of
 * {@link robosim.geometry.dynamics.Dynamics} or a picture, has them once.
 *
 * <p>{@link #cancel} ends calls from another thread, at the same points at which units are counted. One limit may be given to any
 * number of worlds; each call counts for itself, and cancelling ends all of them.
 */
public final class WorkLimit {
    private final long units;
    private final Runnable between;
    private final WorkCounter.Limit counted = new Counted();
    private volatile boolean isCancelled;

    /** What counts the calls of all worlds together; null for a limit of each call. */
    private final @Nullable WorkCounter together;

    private WorkLimit(long units, Runnable between, @Nullable WorkCounter together) {
        this.units = units;
        this.between = between;
        this.together = together;
    }

    /**
     * A limit of units.
     *
     * @param units the most that a call may take, at least 0
     */
    public static WorkLimit of(long units) {
        if (units < 0) {
            throw new IllegalArgumentException("units must be at least 0 (got: " + units + ")");
        }
        return new WorkLimit(units, () -> {}, null);
    }

    /** No limit of units: calls are counted, and can be cancelled. */
    public static WorkLimit none() {
        return new WorkLimit(Long.MAX_VALUE, () -> {}, null);
    }

    /**
     * The same limit, not cancelled, that also runs something during calls, on their own thread: every 256 units at most, so very
     * often. It may throw, which ends the call as exceeding the limit does. It must not use the world.
     */
    public WorkLimit pausing(Runnable pause) {
        return new WorkLimit(units, Checks.present("pause", pause), together);
    }

    /**
     * Begins to count work of another kind against this limit, as that of a check, or of a loop of one's own. What is returned
     * takes units by {@link #take}, and may be given to worlds, of which all calls count together with these; they are counted a
     * little late: after every 256 units of a call, and the end of a call when the next one of its world begins. It is used by
     * one thread at a time.
     */
    public WorkLimit meter(String call) {
        WorkCounter work = new WorkCounter();
        work.begin(counted, Checks.present("call", call));
        return new WorkLimit(Long.MAX_VALUE, () -> {}, work);
    }

    /**
     * Counts units, if this is a {@link #meter}.
     *
     * @param units at least 0
     * @throws WorkLimitException if there are more than the limit allows, or it was cancelled
     * @throws IllegalStateException if this is a limit of each call, which counts nothing itself
     */
    public void take(long units) {
        if (units < 0) {
            throw new IllegalArgumentException("units must be at least 0 (got: " + units + ")");
        }
        if (together == null) {
            throw new IllegalStateException("units must be taken from what meter returns (got: a limit of each call)");
        }
        together.take(units);
    }

    /** The most units that a call may take. */
    public long units() {
        return units;
    }

    /**
     * Ends the calls that are being made, and all later ones until {@link #reset}: they throw a {@link WorkLimitException}. May be
     * called from any thread, and does not wait.
     */
    public void cancel() {
        isCancelled = true;
    }

    /** Allows calls again after {@link #cancel}. */
    public void reset() {
        isCancelled = false;
    }

    /** Whether calls are cancelled. */
    public boolean isCancelled() {
        return isCancelled;
    }

    /** What the queries of a world count against. */
    WorkCounter.Limit counted() {
        return counted;
    }

    @Override
    public String toString() {
        return units == Long.MAX_VALUE ? "no limit of work" : "at most " + units + " units of work a call";
    }

    private final class Counted implements WorkCounter.Limit {
        @Override
        public long units() {
            return units;
        }

        @Override
        public void look(String call) {
            if (isCancelled) {
                throw new WorkLimitException(
                        call + " was cancelled by WorkLimit.cancel; the world is as it was before, and"
                                + " WorkLimit.reset allows calls again",
                        true);
            }
            between.run();
        }

        @Override
        public void took(long more) {
            if (together != null) {
                together.take(more);
            }
        }

        @Override
        public RuntimeException exceeded(String call) {
            return new WorkLimitException(
                    call + " must take at most " + units + " units of work; the world is as it was before, so"
                            + " allow more by WorkLimit.of, ask for less in one call, or use simpler shapes"
                            + " (got: more)",
                    false);
        }
    }
}
