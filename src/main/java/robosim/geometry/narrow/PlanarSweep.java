package robosim.geometry.narrow;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.Stages;

/** The motion of one leaf's projection on XZ against another's at rest. */
public final class PlanarSweep {
    private static final Stages.Counter EXACT = Stages.counter("MovingDisc");

    private PlanarSweep() {}

    /**
     * Time of the first touch when leaf a moves straight on by (dx, dz) during the time from 0 to 1.
     *
     * <p>What touches or overlaps at the start meets nothing later, as convex things that part on a line stay apart; it is
     * only asked whether the motion goes deeper at once, against every direction of least penetration.
     *
     * @param dy ignored: heights do not count
     * @return the time of impact, from 0 to 1, rounded down; 0 where a motion from contact goes deeper;
     *     {@code +Infinity} where nothing is met by time 1 (touching at time 1 is meeting), or a motion from contact goes
     *     along or away
     */
    public static double translation(
            int kindA, double[] a, int i, double dx, double dy, double dz, int kindB, double[] b, int j, Scratch s) {
        if (AxisBody.isPolytope(kindA)) {
            if (AxisBody.isPolytope(kindB)) {
                double time = s.sweep().axes.time(MovingAxes.PLANAR, kindA, a, i, dx, 0, dz, kindB, b, j);
                return Double.isNaN(time)
                        ? ExactAxes.time(MovingAxes.PLANAR, kindA, a, i, dx, 0, dz, kindB, b, j)
                        : time;
            }
            if (isDisc(kindB)) {
                return disc(b, j, -dx, -dz, kindA, a, i, s);
            }
        } else if (isDisc(kindA) && (isDisc(kindB) || AxisBody.isPolytope(kindB))) {
            return disc(a, i, dx, dz, kindB, b, j, s);
        }
        return s.sweep().move.time(true, kindA, a, i, dx, 0, dz, kindB, b, j, s);
    }

    /**
     * The free share of a turn of leaf a by {@code degrees}, of any size and sign, about the axis of unit length
     * (wx, wy, wz) through (px, py, pz).
     *
     * <p>What touches or overlaps at the start blocks where the depth anywhere on the arc is above that at the start.
     * What starts nearer than 2^-44 of the sizes may count as touching, and what touches may get deeper by as much.
     *
     * @return the share that is free, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and
     *     contact may be a gap of 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot away;
     *     {@code +Infinity} where all of the turn is free
     */
    public static double turn(
            int kindA,
            double[] a,
            int i,
            double px,
            double py,
            double pz,
            double wx,
            double wy,
            double wz,
            double degrees,
            int kindB,
            double[] b,
            int j,
            Scratch s) {
        if (degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (wx == 0 && wz == 0 && PlanarTurn.isCovered(kindA) && PlanarTurn.isCovered(kindB)) {
            return s.sweep()
                    .turn
                    .free(kindA, a, i, px, pz, wy < 0 ? -degrees : degrees, kindB, b, j, Double.POSITIVE_INFINITY);
        }
        return s.sweep().heldTurn.free(true, kindA, a, i, px, py, pz, wx, wy, wz, degrees, kindB, b, j, s);
    }

    static boolean isDisc(int kind) {
        return kind == Leaf.UPRIGHT_CYLINDER || kind == Leaf.SPHERE;
    }

    private static double disc(double[] a, int i, double dx, double dz, int kindB, double[] b, int j, Scratch s) {
        double time = roughly(a, i, dx, dz, kindB, b, j, s);
        if (!Double.isNaN(time)) {
            return time;
        }
        return exactDisc(a, i, dx, dz, kindB, b, j, null);
    }

    /** Time of contact of a disc in the plane; NaN where pairs of doubles cannot tell. */
    static double roughly(double[] a, int i, double dx, double dz, int kindB, double[] b, int j, Scratch s) {
        MovingDisc disc = s.sweep().disc;
        return isDisc(kindB)
                ? disc.discs(a, i, dx, dz, b, j, s.sweep().outline)
                : disc.polygon(a, i, dx, dz, kindB, b, j, s.sweep().outline);
    }

    static double exactDisc(
            double[] a,
            int i,
            double dx,
            double dz,
            int kindB,
            double[] b,
            int j,
            ExactDisc.@Nullable Heights heights) {
        return exact(a, i, dx, dz, kindB, b, j, heights).time();
    }

    /** A disc and what it may meet, without rounding. */
    static ExactDisc exact(
            double[] a,
            int i,
            double dx,
            double dz,
            int kindB,
            double[] b,
            int j,
            ExactDisc.@Nullable Heights heights) {
        EXACT.count();
        Dyadic radius = Dyadic.of(a[i + 3]);
        if (isDisc(kindB)) {
            radius = radius.add(Dyadic.of(b[j + 3]));
        }
        Dyadic[] centre = ExactOutline.pair(Dyadic.of(a[i]), Dyadic.of(a[i + 2]));
        ExactOutline outline = ExactOutline.of(kindB, b, j).relative(centre, Dyadic.ONE);
        Dyadic[] move = ExactOutline.pair(Dyadic.of(dx), Dyadic.of(dz));
        return new ExactDisc(outline, radius, move, heights);
    }
}
