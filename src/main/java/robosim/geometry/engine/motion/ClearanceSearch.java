package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.Sweep;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * How far a leg of a motion may go so that the mover stays a clearance apart from a piece that it would meet: the part of it
 * that would meet the piece, and all others, which may pass by.
 */
final class ClearanceSearch implements Sweep.Stop {
    /** Steps are shorter by so much, so that their rounding does not take them past where the clearance ends. */
    private static final double SHORTER = 1 - 0x1p-40;

    /** Most steps of a part that passes by at nearly the clearance; then it stops where it is, which is far enough away. */
    private static final int STEPS = 1000;

    private final Leg leg;
    private final Distance distance;

    /** With a scratch of its own, as it walks meshes while the sweep does. */
    private @Nullable Distance wholeDistance;

    private final double[] box = new double[6];
    private final LeafColumn own = new LeafColumn(1);
    private final LeafColumn other = new LeafColumn(1);

    private LeafTable table;
    private int leaf;
    private int otherLeaf;
    private double clearance;

    @SuppressWarnings("NullAway.Init") // a question begins with its leaves
    ClearanceSearch(Leg leg, Scratch scratch) {
        this.leg = leg;
        distance = new Distance(scratch);
    }

    /** From now on it is about leaf i of the mover and leaf j. */
    ClearanceSearch of(LeafTable in, int i, int j, double gap) {
        table = in;
        leaf = i;
        otherLeaf = j;
        clearance = gap;
        return this;
    }

    /** The greatest share up to contact at which the two, and all other parts of the mover, are as far away as the clearance. */
    @Override
    public double share(int t, int u, double contact, double least) {
        other.setPiece(table.leaves(), otherLeaf, u);
        if (gap(0, t) < clearance) {
            return 0;
        }
        double free = leg.turns() ? ofTurn(t, contact) : ofTranslation(t, contact, least);
        for (int part = 0; part < leg.atStart.size() && free > 0; part++) {
            if (part != leaf || t >= 0) {
                free = ofPassing(part, free);
            }
        }
        return free;
    }

    /**
     * Conservative advancement (Mirtich 1996): up to a share by steps in none of which the gap can be used up. Where the
     * other parts of a mover come nearer than the clearance first, they end it.
     */
    private double ofPassing(int part, double contact) {
        double way = way();
        double free = 0;
        double gap = wholeGap(0, part);
        for (int step = 0; step < STEPS && gap >= clearance; step++) {
            double next = free + SHORTER * (gap - clearance) / way;
            if (!(next > free)) {
                return free;
            }
            if (next >= contact) {
                return contact;
            }
            gap = wholeGap(next, part);
            if (gap >= clearance) {
                free = next;
            }
        }
        return free;
    }

    /** The gap of convex pieces is a convex function of the way, so it falls all the way to contact. */
    private double ofTranslation(int t, double contact, double least) {
        double low = 0;
        double high = contact;
        if (least < contact) {
            if (gap(least, t) >= clearance) {
                return contact;
            }
            high = least;
        }
        for (int halving = 0; halving < 80 && low < Math.nextDown(high); halving++) {
            double middle = low / 2 + high / 2;
            if (gap(middle, t) >= clearance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Back from contact, each time by as little as the missing gap could be made up in. */
    private double ofTurn(int t, double contact) {
        double way = way();
        double free = contact;
        for (int step = 0; step < STEPS && free > 0; step++) {
            double missing = clearance - gap(free, t);
            if (missing <= 0) {
                return free;
            }
            free -= Math.max(missing / way, 0x1p-52);
        }
        return 0;
    }

    /** The length of the way of every point of the mover, or more. */
    private double way() {
        if (!leg.turns()) {
            double dx = leg.displacement(0);
            double dy = leg.dimension() == Dimension.PLANAR ? 0 : leg.displacement(1);
            double dz = leg.displacement(2);
            return VectorMath.anyLength(dx, dy, dz);
        }
        leg.atStart.bounds(0, leg.atStart.size(), box);
        return VectorMath.anyLength(farthest(0), farthest(1), farthest(2)) * leg.angle() * (Math.PI / 180);
    }

    /** How far the bounds extend along an axis from the centre at the start. */
    private double farthest(int axis) {
        return Math.max(Math.abs(box[axis] - leg.start[axis]), Math.abs(box[3 + axis] - leg.start[axis]));
    }

    private double wholeGap(double share, int part) {
        Distance all = wholeDistance;
        if (all == null) {
            all = new Distance(new Scratch());
            wholeDistance = all;
        }
        return all.between(leg.dimension(), leg.after(share), part, other, 0, Double.POSITIVE_INFINITY);
    }

    private double gap(double share, int t) {
        own.setPiece(leg.after(share), leaf, t);
        return distance.between(leg.dimension(), own, 0, other, 0, Double.POSITIVE_INFINITY);
    }
}
