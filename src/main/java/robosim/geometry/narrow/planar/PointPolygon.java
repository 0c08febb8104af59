package robosim.geometry.narrow.planar;

/** A point and a convex polygon stored in a {@link PlanarShape}. */
public final class PointPolygon {
    /** Sides shorter than this are scaled by {@link #ENLARGED} before they are measured. */
    private static final double SHORT = 0x1p-450;

    private static final double UNDERFLOW = 0x1p-960;
    private static final double ENLARGED = 0x1p500;

    // The product of a side's direction, which is off by 1u, and a corner, and the difference of two such products.
    private static final double PRODUCT = 3.01 * 0x1p-53;

    private PointPolygon() {}

    /** The squared distance to the nearest side, also from inside. */
    static double squareToOutline(double px, double pz, PlanarShape q) {
        double least = Double.POSITIVE_INFINITY;
        int last = q.count - 1;
        for (int k = 0; k <= last; k++) {
            int previous = k == 0 ? last : k - 1;
            least = Math.min(least, squareToSegment(px, pz, q.x[previous], q.z[previous], q.x[k], q.z[k]));
        }
        return least;
    }

    static double squareToSegment(double px, double pz, double ax, double az, double bx, double bz) {
        double ex = bx - ax;
        double ez = bz - az;
        double wx = px - ax;
        double wz = pz - az;
        double unit = 1;
        if (Math.abs(ex) + Math.abs(ez) < SHORT) { // otherwise its square would lose bits
            ex *= ENLARGED;
            ez *= ENLARGED;
            unit = ENLARGED;
        }
        double along = ex * wx + ez * wz;
        if (along <= 0) {
            return wx * wx + wz * wz;
        }
        double length = ex * ex + ez * ez;
        if (along * unit >= length) {
            double vx = px - bx;
            double vz = pz - bz;
            return vx * vx + vz * vz;
        }
        double across = ex * wz - ez * wx;
        return across / length * across;
    }

    /**
     * 1 where the origin is certainly inside, -1 where it is certainly outside, 0 where the sides do not decide. A
     * degenerate polygon has no inside.
     *
     * @param error at least the shape's own error, times a filter
     */
    public static int side(PlanarShape q, double error) {
        if (q.count < 3 || isBeyond(0, 0, q, error)) {
            return -1;
        }
        double off = error + PRODUCT * q.size;
        int verdict = 1;
        for (int k = 0; k < q.count; k++) {
            double ex = q.sideX[k];
            double ez = q.sideZ[k];
            double slack = off * (Math.abs(ex) + Math.abs(ez)) + UNDERFLOW;
            double left = ez * q.x[k] - ex * q.z[k];
            if (left < -slack) {
                return -1;
            }
            if (!(left > slack)) {
                verdict = 0;
            }
        }
        return verdict;
    }

    /**
     * Whether a point lies beyond all corners along an axis by more than the error; for sides too inaccurate to decide.
     */
    static boolean isBeyond(double px, double pz, PlanarShape q, double error) {
        boolean left = true;
        boolean right = true;
        boolean below = true;
        boolean above = true;
        for (int k = 0; k < q.count; k++) {
            left &= px < q.x[k] - error;
            right &= px > q.x[k] + error;
            below &= pz < q.z[k] - error;
            above &= pz > q.z[k] + error;
        }
        return left || right || below || above;
    }
}
