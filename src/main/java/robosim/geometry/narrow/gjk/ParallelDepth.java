package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * The penetration depth of two cylinders with parallel or nearly parallel axes, for which all directions perpendicular
 * to the axis may tie.
 */
final class ParallelDepth {
    private ParallelDepth() {}

    /**
     * A lower bound of the least depth, to within rounding; 0 unless both are cylinders.
     *
     * <p>The difference set of parallel cylinders is a cylinder with the sum of the radii and of the heights. Turning
     * the second about its centre by an angle t until it is parallel moves none of its points by more than t (r + h).
     */
    static double atLeast(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        if (!kindA.isCylinder() || !kindB.isCylinder()) {
            return 0;
        }
        double ax = kindA.isTurned() ? a[i + 7] : 0;
        double ay = kindA.isTurned() ? a[i + 10] : 1;
        double az = kindA.isTurned() ? a[i + 13] : 0;
        double bx = kindB.isTurned() ? b[j + 7] : 0;
        double by = kindB.isTurned() ? b[j + 10] : 1;
        double bz = kindB.isTurned() ? b[j + 13] : 0;
        double lengthA = VectorMath.length(ax, ay, az);
        double lengthB = VectorMath.length(bx, by, bz);
        double sine = VectorMath.length(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / (lengthA * lengthB);
        double wx = b[j] - a[i];
        double wy = b[j + 1] - a[i + 1];
        double wz = b[j + 2] - a[i + 2];
        double along = Math.abs(wx * ax + wy * ay + wz * az) / lengthA;
        double across = VectorMath.length(wy * az - wz * ay, wz * ax - wx * az, wx * ay - wy * ax) / lengthA;
        double half = b[j + 4] * lengthB;
        double depth = Math.min(a[i + 3] + b[j + 3] - across, a[i + 4] * lengthA + half - along);
        // An angle below a quarter turn is less than twice its sine.
        return Math.max(0, depth - 2 * sine * (b[j + 3] + half));
    }
}
