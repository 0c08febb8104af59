package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.Upright;
import robosim.geometry.narrow.overlap.HeightIntervals;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactAxes;

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
    public static double translation(
            LeafKind kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            LeafKind kindB,
            double[] b,
            int j,
            SweepScratch s) {
        if (HeightIntervals.parts(kindA, a, i, dy, kindB, b, j, s.overlap)) {
            return Double.POSITIVE_INFINITY;
        }
        if (kindA.isEnclosure() || kindB.isEnclosure()) {
            return kindA == kindB
                    ? MovingPrism.time(false, a, i, dx, dy, dz, b, j)
                    : s.sweep().move.time(false, kindA, a, i, dx, dy, dz, kindB, b, j, s);
        }
        if (kindA.isPolytope() && kindB.isPolytope()) {
            boolean upright = kindA.isVerticalPrism() && kindB.isVerticalPrism();
            AxisBody.Mode mode = upright ? AxisBody.Mode.UPRIGHT : AxisBody.Mode.SPATIAL;
            double time = s.sweep().axes.time(mode, kindA, a, i, dx, dy, dz, kindB, b, j);
            return Double.isNaN(time) ? ExactAxes.time(mode, kindA, a, i, dx, dy, dz, kindB, b, j) : time;
        }
        if (kindA.isVerticalPrism() && kindB.isVerticalPrism()) {
            return kindA.isRound()
                    ? cylinder(a, i, dx, dy, dz, kindB, b, j, s)
                    : cylinder(b, j, -dx, -dy, -dz, kindA, a, i, s);
        }
        if (kindA == LeafKind.SPHERE) {
            return sphere(a, i, dx, dy, dz, kindB, b, j, s);
        }
        if (kindB == LeafKind.SPHERE) {
            return sphere(b, j, -dx, -dy, -dz, kindA, a, i, s);
        }
        return s.sweep().move.time(false, kindA, a, i, dx, dy, dz, kindB, b, j, s);
    }

    /**
     * A sphere against anything: unless fixed axes prove it free, the time is found in closed form, except on a rim.
     */
    private static double sphere(
            double[] a, int i, double dx, double dy, double dz, LeafKind kindB, double[] b, int j, SweepScratch s) {
        boolean exact = switch (kindB) {
            case UPRIGHT_BOX, SPHERE, BOX, TRIANGLE -> true;
            case UPRIGHT_CYLINDER, CYLINDER, UPRIGHT_CAPSULE, CAPSULE -> false;
            case PRISM, MESH, SOLID_MESH, GRID -> throw kindB.refused();
        };
        if (kindB == LeafKind.UPRIGHT_BOX && MovingBall.isAbove(a, i, dy, b, j)) {
            return Double.POSITIVE_INFINITY;
        }
        TranslationAdvancement held = s.sweep().move;
        double time = exact
                ? held.roughly(false, LeafKind.SPHERE, a, i, dx, dy, dz, kindB, b, j, s)
                : held.time(false, LeafKind.SPHERE, a, i, dx, dy, dz, kindB, b, j, s);
        if (held.contact) {
            return exact ? ExactBall.time(a, i, dx, dy, dz, kindB, b, j) : time;
        }
        if (time > 1 || !(exact || kindB == LeafKind.UPRIGHT_CYLINDER)) {
            return time;
        }
        double found = s.sweep().ball.time(a, i, dx, dy, dz, kindB, b, j, time);
        if (!Double.isNaN(found)) {
            return found;
        }
        return exact ? ExactBall.time(a, i, dx, dy, dz, kindB, b, j) : time;
    }

    /** An upright cylinder against anything upright: a disc in the plane, while the heights touch. */
    private static double cylinder(
            double[] a, int i, double dx, double dy, double dz, LeafKind kindB, double[] b, int j, SweepScratch s) {
        double middle = Upright.middle(kindB, b, j);
        double top = Upright.top(kindB, b, j);
        double high = Upright.halfHeight(kindB, b, j);
        int above = Dyadic.signOfSum(a[i + 1], -a[i + 4], -top, -high);
        int below = Dyadic.signOfSum(middle, -high, -a[i + 1], -a[i + 4]);
        if ((above > 0 && dy >= 0) || (below > 0 && dy <= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double time = PlanarSweep.roughly(a, i, dx, dz, kindB, b, j, s);
        MovingDisc disc = s.sweep().disc;
        if (time == Double.POSITIVE_INFINITY && !disc.contact) {
            return time;
        }
        double up = a[i + 1] - a[i + 4] - top - high;
        double down = middle - high - a[i + 1] - a[i + 4];
        double error = AxisBody.ROUNDOFF
                * (Math.abs(a[i + 1]) + a[i + 4] + Math.abs(top) + Math.abs(middle) + high + Math.abs(dy));
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
        Dyadic mine = Dyadic.of(a[i + 1]);
        Dyadic half = Dyadic.of(a[i + 4]);
        ExactDisc.Heights heights = new ExactDisc.Heights(
                mine.subtract(half).subtract(Dyadic.of(top)).subtract(Dyadic.of(high)),
                Dyadic.of(middle).subtract(Dyadic.of(high)).subtract(mine).subtract(half),
                Dyadic.of(dy));
        return ExactDisc.of(a, i, dx, dz, kindB, b, j, heights).time();
    }
}
