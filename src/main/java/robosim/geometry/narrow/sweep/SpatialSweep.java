package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.leaf.UprightLeaves;
import robosim.geometry.narrow.overlap.HeightIntervals;
import robosim.geometry.narrow.planar.DiscSweepFilter;
import robosim.geometry.narrow.sat.AxisBody;

/** The motion of one leaf against another at rest, in space. */
public final class SpatialSweep {
    private SpatialSweep() {}

    /**
     * Time of the first contact when leaf a is translated by (dx, dy, dz) during the time from 0 to 1.
     *
     * <p>If the two touch or overlap at the start there is no later contact, since convex sets that separate along a
     * line stay apart; then it is only decided whether the motion goes deeper at once, against every direction of least
     * penetration.
     *
     * @return the time of impact, from 0 to 1, rounded down; 0 if a motion from contact goes deeper; {@code +Infinity}
     *     if there is no contact up to time 1 (touching at time 1 counts), or a motion from contact goes along or away
     */
    public static double translation(Leaf a, double dx, double dy, double dz, Leaf b, SweepScratch s) {
        if (HeightIntervals.parts(a, dy, b, s.overlap)) {
            return Double.POSITIVE_INFINITY;
        }
        if (a.kind.isEnclosure() || b.kind.isEnclosure()) {
            return a.kind == b.kind
                    ? MovingPrism.time(false, a, dx, dy, dz, b)
                    : s.sweep().move.time(false, a, dx, dy, dz, b, s.overlap);
        }
        if (a.kind.isPolytope() && b.kind.isPolytope()) {
            boolean upright = a.kind.isVerticalPrism() && b.kind.isVerticalPrism();
            AxisBody.Mode mode = upright ? AxisBody.Mode.UPRIGHT : AxisBody.Mode.SPATIAL;
            return s.polytopes(mode, a, dx, dy, dz, b);
        }
        if (a.kind.isVerticalPrism() && b.kind.isVerticalPrism()) {
            return a.kind.isRound() ? cylinder(a, dx, dy, dz, b, s) : cylinder(b, -dx, -dy, -dz, a, s);
        }
        if (a.kind == LeafKind.SPHERE) {
            return sphere(a, dx, dy, dz, b, s);
        }
        if (b.kind == LeafKind.SPHERE) {
            return sphere(b, -dx, -dy, -dz, a, s);
        }
        return s.sweep().move.time(false, a, dx, dy, dz, b, s.overlap);
    }

    /**
     * A sphere against anything: unless fixed axes prove it free, the time is found in closed form, except on a rim.
     */
    private static double sphere(Leaf a, double dx, double dy, double dz, Leaf b, SweepScratch s) {
        boolean exact = switch (b.kind) {
            case UPRIGHT_BOX, SPHERE, BOX, TRIANGLE -> true;
            case UPRIGHT_CYLINDER, CYLINDER, UPRIGHT_CAPSULE, CAPSULE -> false;
            case PRISM, MESH, SOLID_MESH, GRID -> throw b.kind.refused();
        };
        if (b.kind == LeafKind.UPRIGHT_BOX && MovingBall.isAbove(a, dy, b)) {
            return Double.POSITIVE_INFINITY;
        }
        if (b.kind == LeafKind.SPHERE) {
            double qx = b.get(0) - a.get(0);
            double qy = b.get(1) - a.get(1);
            double qz = b.get(2) - a.get(2);
            double reach = a.get(3) + b.get(3);
            int sure = DiscSweepFilter.pastBall(qx, qy, qz, dx, dy, dz, reach, 0);
            if (sure == DiscSweepFilter.CLEAR) {
                return Double.POSITIVE_INFINITY;
            }
            if (sure == DiscSweepFilter.MET && qx * qx + qy * qy + qz * qz < reach * reach) {
                return 0; // they overlap, and it goes deeper
            }
        }
        TranslationAdvancement held = s.sweep().move;
        double time = exact
                ? held.roughly(false, a, dx, dy, dz, b, s.overlap)
                : held.time(false, a, dx, dy, dz, b, s.overlap);
        if (held.contact) {
            return exact ? ExactBall.time(a, dx, dy, dz, b) : time;
        }
        if (time > 1 || !(exact || b.kind == LeafKind.UPRIGHT_CYLINDER)) {
            return time;
        }
        double found = s.sweep().ball.time(a, dx, dy, dz, b, time);
        if (!Double.isNaN(found)) {
            return found;
        }
        return exact ? ExactBall.time(a, dx, dy, dz, b) : time;
    }

    /** An upright cylinder against anything upright: a disc in the plane, while the heights touch. */
    private static double cylinder(Leaf a, double dx, double dy, double dz, Leaf b, SweepScratch s) {
        double middle = UprightLeaves.middle(b);
        double top = UprightLeaves.top(b);
        double high = UprightLeaves.halfHeight(b);
        int above = Dyadic.signOfSum(a.get(1), -a.get(4), -top, -high);
        int below = Dyadic.signOfSum(middle, -high, -a.get(1), -a.get(4));
        if ((above > 0 && dy >= 0) || (below > 0 && dy <= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double time = PlanarSweep.roughly(a, dx, dz, b, s);
        MovingDisc disc = s.sweep().disc;
        if (time == Double.POSITIVE_INFINITY && !disc.contact) {
            return time;
        }
        double up = a.get(1) - a.get(4) - top - high;
        double down = middle - high - a.get(1) - a.get(4);
        double error = AxisBody.ROUNDOFF
                * (Math.abs(a.get(1)) + a.get(4) + Math.abs(top) + Math.abs(middle) + high + Math.abs(dy));
        boolean level = above <= 0
                && below <= 0
                && (dy == 0 || (up + Math.max(0, dy) < -error && down - Math.min(0, dy) < -error));
        if (level && !Double.isNaN(time)) {
            // In contact, the shorter way out decides: sideways, or up or down, and level motion is along that.
            double depth = -Math.max(up, down);
            if (!disc.contact || disc.depthHi < depth - error) {
                return time;
            }
            if (dy == 0 && disc.depthLo > depth + error) {
                return Double.POSITIVE_INFINITY;
            }
        }
        Dyadic mine = Dyadic.of(a.get(1));
        Dyadic half = Dyadic.of(a.get(4));
        ExactDisc.Heights heights = new ExactDisc.Heights(
                mine.subtract(half).subtract(Dyadic.of(top)).subtract(Dyadic.of(high)),
                Dyadic.of(middle).subtract(Dyadic.of(high)).subtract(mine).subtract(half),
                Dyadic.of(dy));
        return ExactDisc.of(a, dx, dz, b, heights).time();
    }

    /**
     * The free fraction of a turn of leaf a.
     *
     * <p>If the two touch or overlap at the start, the turn is blocked if the depth anywhere on the arc is above that
     * at the start.
     *
     * @return the free fraction, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and at
     *     its end a gap of up to 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot may
     *     remain; {@code +Infinity} if the whole turn is free
     */
    public static double turn(Leaf a, PivotTurn turn, Leaf b, SweepScratch s) {
        if (turn.degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        boolean isUpright = a.kind.isVerticalPrism() && b.kind.isVerticalPrism();
        if (turn.isLevel() && isUpright && VerticalTurn.isCovered(a.kind) && VerticalTurn.isCovered(b.kind)) {
            double mid = UprightLeaves.middle(a);
            double half = UprightLeaves.halfHeight(a);
            double top = UprightLeaves.top(a);
            double otherMid = UprightLeaves.middle(b);
            double otherHalf = UprightLeaves.halfHeight(b);
            double otherTop = UprightLeaves.top(b);
            if (Dyadic.signOfSum(mid, -half, -otherTop, -otherHalf) > 0
                    || Dyadic.signOfSum(otherMid, -otherHalf, -top, -half) > 0) {
                return Double.POSITIVE_INFINITY;
            }
            double depth = Math.min(otherTop + otherHalf - mid + half, top + half - otherMid + otherHalf);
            VerticalTurn vertical = s.sweep().vertical;
            double free = vertical.free(a, turn, b, depth);
            if (vertical.arc > 0 || !vertical.isApart) {
                return free;
            }
        }
        return s.sweep().turning.free(false, a, turn, b, s.overlap);
    }
}
