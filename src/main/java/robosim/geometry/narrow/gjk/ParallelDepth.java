package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

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
    static double atLeast(Leaf a, Leaf b) {
        if (!a.kind.isCylinder() || !b.kind.isCylinder()) {
            return 0;
        }
        double ax = a.kind.isTurned() ? a.get(7) : 0;
        double ay = a.kind.isTurned() ? a.get(10) : 1;
        double az = a.kind.isTurned() ? a.get(13) : 0;
        double bx = b.kind.isTurned() ? b.get(7) : 0;
        double by = b.kind.isTurned() ? b.get(10) : 1;
        double bz = b.kind.isTurned() ? b.get(13) : 0;
        double lengthA = VectorMath.length(ax, ay, az);
        double lengthB = VectorMath.length(bx, by, bz);
        double sine = VectorMath.length(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / (lengthA * lengthB);
        double wx = b.get(0) - a.get(0);
        double wy = b.get(1) - a.get(1);
        double wz = b.get(2) - a.get(2);
        double along = Math.abs(wx * ax + wy * ay + wz * az) / lengthA;
        double across = VectorMath.length(wy * az - wz * ay, wz * ax - wx * az, wx * ay - wy * ax) / lengthA;
        double half = b.get(4) * lengthB;
        double depth = Math.min(a.get(3) + b.get(3) - across, a.get(4) * lengthA + half - along);
        // An angle below a quarter turn is less than twice its sine.
        return Math.max(0, depth - 2 * sine * (b.get(3) + half));
    }
}
