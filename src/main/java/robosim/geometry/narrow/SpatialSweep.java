package robosim.geometry.narrow;

import robosim.geometry.exact.Dyadic;

/** The motion of one leaf against another at rest, in space. */
public final class SpatialSweep {
    private SpatialSweep() {}

    /**
     * Time of the first touch when leaf a moves straight on by (dx, dy, dz) during the time from 0 to 1.
     *
     * <p>What touches or overlaps at the start meets nothing later, as convex things that part on a line stay apart; it is
     * only asked whether the motion goes deeper at once, against every direction of least penetration.
     *
     * @return the time of impact, from 0 to 1, rounded down; 0 where a motion from contact goes deeper;
     *     {@code +Infinity} where nothing is met by time 1 (touching at time 1 is meeting), or a motion from contact goes
     *     along or away
     */
    public static double translation(
            int kindA, double[] a, int i, double dx, double dy, double dz, int kindB, double[] b, int j, Scratch s) {
        if (Levels.parts(kindA, a, i, dy, kindB, b, j, s)) {
            return Double.POSITIVE_INFINITY;
        }
        if (AxisBody.isPolytope(kindA) && AxisBody.isPolytope(kindB)) {
            boolean upright = Leaf.isUpright(kindA) && Leaf.isUpright(kindB);
            int mode = upright ? MovingAxes.UPRIGHT : MovingAxes.SPATIAL;
            double time = s.sweep().axes.time(mode, kindA, a, i, dx, dy, dz, kindB, b, j);
            return Double.isNaN(time) ? ExactAxes.time(mode, kindA, a, i, dx, dy, dz, kindB, b, j) : time;
        }
        if (Leaf.isUpright(kindA) && Leaf.isUpright(kindB)) {
            return kindA == Leaf.UPRIGHT_CYLINDER
                    ? cylinder(a, i, dx, dy, dz, kindB, b, j, s)
                    : cylinder(b, j, -dx, -dy, -dz, kindA, a, i, s);
        }
        if (kindA == Leaf.SPHERE) {
            return sphere(a, i, dx, dy, dz, kindB, b, j, s);
        }
        if (kindB == Leaf.SPHERE) {
            return sphere(b, j, -dx, -dy, -dz, kindA, a, i, s);
        }
        return s.sweep().move.time(false, kindA, a, i, dx, dy, dz, kindB, b, j, s);
    }

    /** A sphere against anything: what held axes do not prove free is found in closed form, but on a rim. */
    private static double sphere(
            double[] a, int i, double dx, double dy, double dz, int kindB, double[] b, int j, Scratch s) {
        boolean exact =
                kindB == Leaf.SPHERE || kindB == Leaf.TRIANGLE || kindB == Leaf.BOX || kindB == Leaf.UPRIGHT_BOX;
        if (kindB == Leaf.UPRIGHT_BOX && MovingBall.isAbove(a, i, dy, b, j)) {
            return Double.POSITIVE_INFINITY;
        }
        HeldMove held = s.sweep().move;
        double time = held.time(false, Leaf.SPHERE, a, i, dx, dy, dz, kindB, b, j, s);
        if (held.contact) {
            return exact ? ExactBall.time(a, i, dx, dy, dz, kindB, b, j) : time;
        }
        if (time > 1 || !(exact || kindB == Leaf.UPRIGHT_CYLINDER)) {
            return time;
        }
        double found = s.sweep().ball.time(a, i, dx, dy, dz, kindB, b, j, time);
        if (!Double.isNaN(found)) {
            return found;
        }
        return exact ? ExactBall.time(a, i, dx, dy, dz, kindB, b, j) : time;
    }

    /**
     * The free share of a turn of leaf a by {@code degrees}, of any size and sign, about the axis of unit length
     * (wx, wy, wz) through (px, py, pz).
     *
     * <p>What touches or overlaps at the start blocks where the depth anywhere on the arc is above that at the start.
     *
     * @return the share that is free, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and
     *     contact may be a gap of 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot away; {@code +Infinity} where all of the turn is free
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
        if (wx == 0 && wz == 0 && Leaf.isUpright(kindA) && Leaf.isUpright(kindB)) {
            double mid = middle(kindA, a, i);
            double half = halfHeight(kindA, a, i);
            double top = top(kindA, a, i);
            double otherMid = middle(kindB, b, j);
            double otherHalf = halfHeight(kindB, b, j);
            double otherTop = top(kindB, b, j);
            if (Dyadic.signOfSum(mid, -half, -otherTop, -otherHalf) > 0
                    || Dyadic.signOfSum(otherMid, -otherHalf, -top, -half) > 0) {
                return Double.POSITIVE_INFINITY;
            }
            double depth = Math.min(otherTop + otherHalf - mid + half, top + half - otherMid + otherHalf);
            return s.sweep().turn.free(kindA, a, i, px, pz, wy < 0 ? -degrees : degrees, kindB, b, j, depth);
        }
        return s.sweep().heldTurn.free(false, kindA, a, i, px, py, pz, wx, wy, wz, degrees, kindB, b, j, s);
    }

    // A box or cylinder reaches from middle - half to middle + half; a prism, of half 0, from middle to top.
    private static double middle(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 8] : row[at + 1];
    }

    private static double top(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 9] : row[at + 1];
    }

    private static double halfHeight(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? 0 : row[at + 4];
    }

    /** An upright cylinder against anything upright: a disc in the plane, while the heights touch. */
    private static double cylinder(
            double[] a, int i, double dx, double dy, double dz, int kindB, double[] b, int j, Scratch s) {
        double middle = middle(kindB, b, j);
        double top = top(kindB, b, j);
        double high = halfHeight(kindB, b, j);
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
        double error = MovingAxes.ROUNDOFF
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
        return PlanarSweep.exactDisc(a, i, dx, dz, kindB, b, j, heights);
    }
}
