package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.PivotTurn;

/**
 * Rules out the triangles that a turning triangle clearly does not come near; {@link TurnAdvancement} decides about the others,
 * with the same answer.
 *
 * <p>A turn keeps how high a point is along the axis, h, and how far from the axis, r. Two sets that a line separates in the plane
 * of (h, r) therefore never meet. No point of a triangle has a larger r than the mean of its corners, weighted as the point is, and
 * none a smaller one than that point along any one direction away from the axis: a triangle lies between two shadows of three
 * corners each. Further, the plane of the triangle at rest may separate the two during the whole turn: between its ends a corner
 * rises by at most the height of its arc.
 */
final class TurnSieve {
    /** A gap below this share of the largest distance from the axis is left to the kernel. */
    private static final double NEAR = 0x1p-10;

    /** More than rounding, as a share of the coordinates, and than the axis may be longer or shorter than 1. */
    private static final double ROUNDED = 0x1p-26;

    private static final double LEAST = 0x1p-300;

    /** Larger turns leave the plane of the triangle at rest out. */
    private static final double MOST_DEGREES = 150;

    private final PivotTurn turn = new PivotTurn();
    private final Shadow mover = new Shadow();
    private final Shadow other = new Shadow();
    private final double[] ends = new double[9];
    private double cos;
    private double sin;

    /** How high an arc of radius 1 rises above its chord; infinite for large turns. */
    private double rise;

    private boolean countsHeights;

    /** Begins with a turn; without heights it must be level. */
    void begin(PivotTurn by, boolean inPlane) {
        turn.about(by.px, by.py, by.pz).by(by.wx, by.wy, by.wz, by.degrees);
        countsHeights = !inPlane;
        double angle = Degrees.toRadians(by.degrees);
        cos = StrictMath.cos(angle);
        sin = StrictMath.sin(angle);
        boolean isLarge = inPlane || Math.abs(by.degrees) > MOST_DEGREES;
        rise = isLarge ? Double.POSITIVE_INFINITY : 1 - StrictMath.cos(angle / 2) + ROUNDED;
    }

    /** Takes the triangle that turns: nine numbers. */
    void mover(double[] corners) {
        mover.cast(corners);
        for (int k = 0; k < 9 && rise < 1; k += 3) {
            double x = corners[k] - turn.px;
            double y = corners[k + 1] - turn.py;
            double z = corners[k + 2] - turn.pz;
            double along = (1 - cos) * (x * turn.wx + y * turn.wy + z * turn.wz);
            ends[k] = turn.px + cos * x + sin * (turn.wy * z - turn.wz * y) + along * turn.wx;
            ends[k + 1] = turn.py + cos * y + sin * (turn.wz * x - turn.wx * z) + along * turn.wy;
            ends[k + 2] = turn.pz + cos * z + sin * (turn.wx * y - turn.wy * x) + along * turn.wz;
        }
    }

    /** Whether the triangle that turns clearly keeps off one at rest. */
    boolean isClear(double[] corners, double[] moving) {
        other.cast(corners);
        double margin = NEAR * mover.farthest + ROUNDED * (mover.size + other.size) + LEAST;
        return isApart(0, 1, margin)
                || (countsHeights
                        && (isApart(1, 0, margin)
                                || isApart(mover.normalHeight, mover.normalRadius, margin)
                                || isApart(other.normalHeight, other.normalRadius, margin)
                                || (rise < 1 && staysBeside(moving, margin))));
    }

    private boolean isApart(double height, double radius, double margin) {
        mover.project(height, radius);
        other.project(height, radius);
        return mover.low - other.high > margin || other.low - mover.high > margin;
    }

    /** Whether the plane of the triangle at rest separates the two all the way. */
    private boolean staysBeside(double[] moving, double margin) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 9; k += 3) {
            double from = other.heightOf(moving, k);
            double to = other.heightOf(ends, k);
            low = Math.min(low, Math.min(from, to));
            high = Math.max(high, Math.max(from, to));
        }
        double most = margin + mover.farthest * rise;
        return low > most || high < -most;
    }

    /** A triangle as it is seen in the plane of heights along the axis and distances from it. */
    private final class Shadow {
        private final double[] h = new double[3];
        private final double[] far = new double[3];
        private final double[] near = new double[3];
        private double normalHeight;
        private double normalRadius;
        private double farthest;
        private double size;
        private double low;
        private double high;

        // The unit normal, and a corner.
        private double nx;
        private double ny;
        private double nz;
        private double ox;
        private double oy;
        private double oz;

        private void cast(double[] c) {
            double ux = 0;
            double uy = 0;
            double uz = 0;
            farthest = 0;
            size = 0;
            for (int k = 0; k < 3; k++) {
                double x = c[3 * k] - turn.px;
                double y = c[3 * k + 1] - turn.py;
                double z = c[3 * k + 2] - turn.pz;
                h[k] = x * turn.wx + y * turn.wy + z * turn.wz;
                x -= h[k] * turn.wx;
                y -= h[k] * turn.wy;
                z -= h[k] * turn.wz;
                far[k] = Math.sqrt(x * x + y * y + z * z);
                ux += x;
                uy += y;
                uz += z;
                farthest = Math.max(farthest, far[k]);
                size += Math.abs(c[3 * k]) + Math.abs(c[3 * k + 1]) + Math.abs(c[3 * k + 2]) + Math.abs(h[k]) + far[k];
            }
            double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
            double by = length > LEAST ? 1 / length : 0;
            ux *= by;
            uy *= by;
            uz *= by;
            for (int k = 0; k < 3; k++) {
                near[k] = (c[3 * k] - turn.px) * ux + (c[3 * k + 1] - turn.py) * uy + (c[3 * k + 2] - turn.pz) * uz;
            }
            takeNormal(c);
            normalHeight = nx * turn.wx + ny * turn.wy + nz * turn.wz;
            normalRadius = nx * ux + ny * uy + nz * uz;
        }

        private void takeNormal(double[] c) {
            ox = c[0];
            oy = c[1];
            oz = c[2];
            double ex = c[3] - ox;
            double ey = c[4] - oy;
            double ez = c[5] - oz;
            double fx = c[6] - ox;
            double fy = c[7] - oy;
            double fz = c[8] - oz;
            nx = ey * fz - ez * fy;
            ny = ez * fx - ex * fz;
            nz = ex * fy - ey * fx;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            double by = length > VectorMath.UNDERFLOW ? 1 / length : 0;
            nx *= by;
            ny *= by;
            nz *= by;
        }

        private double heightOf(double[] c, int k) {
            return (c[k] - ox) * nx + (c[k + 1] - oy) * ny + (c[k + 2] - oz) * nz;
        }

        private void project(double height, double radius) {
            low = Double.POSITIVE_INFINITY;
            high = Double.NEGATIVE_INFINITY;
            for (int k = 0; k < 3; k++) {
                double up = height * h[k];
                double one = up + radius * far[k];
                double two = up + radius * near[k];
                low = Math.min(low, Math.min(one, two));
                high = Math.max(high, Math.max(one, two));
            }
        }
    }
}
