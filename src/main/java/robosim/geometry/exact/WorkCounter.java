package robosim.geometry.exact;

import org.jspecify.annotations.Nullable;

/**
 * Counts the work of one owner of queries against the limit of the call at hand. A unit is about one pair that is looked at: of
 * boxes, of pieces, of a ray and a piece; or one step of an iteration. How many a call takes depends on the world and its
 * arguments alone.
 */
public final class WorkCounter {
    /** So many units are counted between two looks at the limit. */
    private static final int STRETCH = 256;

    /** What limits a call. */
    public interface Limit {
        /** The most units that a call may take. */
        long units();

        /** Is asked often during a call; throws if that is to end. */
        void look(String call);

        /** What is thrown if a call would take more than its units. */
        RuntimeException exceeded(String call);

        /** Is told of units that were taken, each once: at every look, and of the end of a call when the next one begins. */
        default void took(long units) {}
    }

    private @Nullable Limit limit;
    private String call = "";

    /** How many calls are made of others at the moment, one within another; the outermost has the budget. */
    private int depth;

    /** What is left until the next look, and after it. */
    private long left = Long.MAX_VALUE;

    private long rest;

    /** The most units of the call, and how many of those taken the limit has been told of. */
    private long most;

    private long told;

    /** Begins a call, unless it is a part of one that has begun. */
    public void begin(@Nullable Limit of, String name) {
        if ((of != null || limit != null) && depth == 0) {
            start(of, name);
        }
    }

    /** Begins a call that is made of others, which have no budget of their own until it is closed. */
    public void open(@Nullable Limit of, String name) {
        begin(of, name);
        depth++;
    }

    /** Ends a call that was opened, whether it was made or not. */
    public void close() {
        depth--;
    }

    private void start(@Nullable Limit of, String name) {
        if (limit != null) {
            tell(limit);
        }
        limit = of;
        call = name;
        left = 0;
        rest = of == null ? 0 : of.units();
        most = rest;
        told = 0;
        next();
    }

    private void tell(Limit of) {
        long units = done() - told;
        told += units;
        of.took(units);
    }

    /** How many units the last call with a limit has taken so far. */
    public long done() {
        return limit == null ? 0 : Math.min(most, most - rest - left);
    }

    /** Counts a unit. */
    public void take() {
        if (--left < 0) {
            next();
        }
    }

    /** Counts several units. */
    public void take(long units) {
        left -= units;
        if (left < 0) {
            next();
        }
    }

    /** Looks at the limit, and takes the next units from what is left. */
    private void next() {
        Limit of = limit;
        if (of == null) {
            left = Long.MAX_VALUE;
            return;
        }
        of.look(call);
        tell(of);
        long over = -left;
        if (over > rest) {
            left = 0;
            rest = 0;
            throw of.exceeded(call);
        }
        rest -= over;
        left = Math.min(rest, STRETCH);
        rest -= left;
    }
}
