package robosim.geometry;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Pose;
import robosim.geometry.narrow.Border;
import robosim.geometry.narrow.DiscWay;
import robosim.geometry.narrow.LeafColumn;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.SweptBounds;

/**
 * A straight move answered with yes or no and nothing else, as {@link Motion} would: most moves meet nothing, and who only
 * asks whether need not know where. Reads the world's own columns and places nothing before it is sure.
 */
final class Stride {
    /** A yes: {@link #end()} is where the object comes to stand. */
    static final int FREE = 1;

    static final int BLOCKED = -1;

    /** Not asked here: see {@link Motion}. */
    static final int UNKNOWN = 0;

    private final Bodies bodies;
    private final Border border;
    private final Scratch s;
    private final Sweep sweep;
    private final LeafColumn probe = new LeafColumn(1);
    private final double[] box = new double[6];
    private final double[] end = new double[6];

    private Level level;
    private int id;
    private double dx;
    private double dy;
    private double dz;
    private boolean hasProbe;

    @SuppressWarnings("NullAway.Init") // a question sets its level
    Stride(Bodies bodies, Border border, Scratch scratch) {
        this.bodies = bodies;
        this.border = border;
        s = scratch;
        sweep = new Sweep(scratch);
    }

    /** The centre at the end, and what it has lost; six numbers. */
    double[] end() {
        return end;
    }

    /** Whether an object may go by a displacement in the world's axes. */
    int ask(Level inLevel, int mover, double x, double y, double z) {
        level = inLevel;
        id = mover;
        if (!level.keepsShape(mover)) {
            return UNKNOWN;
        }
        double[] places = bodies.places();
        int at = bodies.place(mover);
        dx = advance(places, at, 0, x);
        dy = advance(places, at, 1, y);
        dz = advance(places, at, 2, z);
        if (dx == 0 && dy == 0 && dz == 0) {
            return UNKNOWN;
        }
        hasProbe = false;
        SweptBounds.moved(level.bounds(), 6 * mover, dx, dy, dz, box);
        if (!border.clearlyHolds(box) && !endsInside()) {
            return BLOCKED;
        }
        return passesAll() ? FREE : BLOCKED;
    }

    /** Writes a coordinate of the end; answers how far it is from the start. */
    private double advance(double[] places, int at, int along, double by) {
        double from = places[at + along];
        double to = from + by;
        double rest = DoubleDouble.sumTail(from, by, to) + places[at + Pose.LOST + along];
        double sum = to + rest;
        end[along] = sum;
        end[3 + along] = DoubleDouble.sumTail(to, rest, sum);
        return sum - from;
    }

    private boolean passesAll() {
        int near = level.cursor.gather(box[0], box[2], box[3], box[5]);
        for (int k = 0; k < near; k++) {
            if (!passes(level.cursor.gathered(k))) {
                return false;
            }
        }
        for (int k = 0; k < level.moversBesideTree(); k++) {
            if (!passes(bodies.mover(k))) {
                return false;
            }
        }
        return true;
    }

    private boolean passes(int other) {
        if (other == id) {
            return true;
        }
        int quick = quickly(other);
        return quick == DiscWay.UNSURE ? !level.meets(other, box) || passesExactly(other) : quick == DiscWay.CLEAR;
    }

    /** What doubles can tell of two discs, as seen from above. */
    private int quickly(int other) {
        LeafColumn leaves = level.leaves();
        int own = level.first(id);
        int others = level.first(other);
        boolean areDiscs = level.count(id) == 1
                && level.count(other) == 1
                && DiscWay.isDisc(leaves.kind(own))
                && DiscWay.isDisc(leaves.kind(others));
        if (!areDiscs) {
            return DiscWay.UNSURE;
        }
        int verdict = DiscWay.past(leaves, own, dx, dz, others);
        // Who meets as seen from above may be higher or lower.
        return verdict == DiscWay.MET && level.dimension == Dimension.SPATIAL ? DiscWay.UNSURE : verdict;
    }

    private boolean passesExactly(int other) {
        LeafColumn leaves = level.leaves();
        int own = level.first(id);
        int ownEnd = own + level.count(id);
        int others = level.first(other);
        int othersEnd = others + level.count(other);
        sweep.translation(level.dimension, dx, dy, dz);
        for (int j = others; j < othersEnd; j++) {
            for (int i = own; i < ownEnd; i++) {
                if (sweep.free(leaves, i, leaves, j) != Double.POSITIVE_INFINITY) {
                    return false;
                }
            }
        }
        placeProbe();
        for (int j = others; j < othersEnd; j++) {
            for (int i = own; i < ownEnd; i++) {
                if (Overlap.test(level.dimension, probe, i - own, leaves, j, s)
                        && !Overlap.test(level.dimension, leaves, i, leaves, j, s)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean endsInside() {
        placeProbe();
        return border.holds(probe, 0, probe.size());
    }

    /** Puts what stands for the object where it would end. */
    private void placeProbe() {
        if (!hasProbe) {
            hasProbe = true;
            Level.Form form = level.form(id);
            probe.clear();
            probe.append(form.size());
            level.place(form, end[0], end[1], end[2], bodies.places(), bodies.place(id) + 3, probe, 0);
        }
    }
}
