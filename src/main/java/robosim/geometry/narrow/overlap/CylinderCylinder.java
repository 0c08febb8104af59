package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.sat.ExactCylinders;

/** Overlap of two cylinders in space, of which at least one is turned. */
public final class CylinderCylinder {
    /**
     * Rounding error along parallel axes, in u = 2^-53 of the operands' magnitudes: an offset 1, its products 1 and
     * their sum 2. The last difference keeps its sign.
     */
    private static final double ALONG_ERROR = FilterBound.bound(4.01 * 0x1p-53);

    /** Rounding error of the half heights: a.a and a.b 3, their products 1, the sum 1. */
    private static final double HEIGHTS_ERROR = FilterBound.bound(5.01 * 0x1p-53);

    /**
     * Rounding error of the squared permanents of w x a: a product 2, a coordinate 3, its square 7, the sum of three 9.
     * Of the squared reach: the sum of the radii 1, its square 3, a.a 3, the product 7.
     */
    private static final double ACROSS_ERROR = FilterBound.bound(9.01 * 0x1p-53);

    private static final double REACH_ERROR = FilterBound.bound(7.01 * 0x1p-53);

    /** More than the error that underflow may add. */
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter EXACT = StageCounters.counter("CylinderCylinder");

    private CylinderCylinder() {}

    /**
     * Whether two cylinders touch or overlap.
     *
     * <p>Exact where the stored axes are parallel. Otherwise certified: apart only if a slab separates the two (by more
     * than the rounding of doubles, or in exact arithmetic); touching if a common point is found (so deep that no
     * rounding matters, or exactly). If neither is found the answer is touching, with {@link OverlapScratch#uncertain}
     * set; this happens only if the gap or the depth is below 2^-40 of the sizes.
     */
    public static boolean touch(Leaf a, Leaf b, OverlapScratch s) {
        double ax = a.kind.isTurned() ? a.get(7) : 0;
        double ay = a.kind.isTurned() ? a.get(10) : 1;
        double az = a.kind.isTurned() ? a.get(13) : 0;
        double bx = b.kind.isTurned() ? b.get(7) : 0;
        double by = b.kind.isTurned() ? b.get(10) : 1;
        double bz = b.kind.isTurned() ? b.get(13) : 0;
        boolean same = (ax == bx && ay == by && az == bz) || (ax == -bx && ay == -by && az == -bz);
        if (same || (maybeParallel(ax, ay, az, bx, by, bz) && areParallel(a, b))) {
            int sure = parallel(a, ax, ay, az, b, Math.abs(ax * bx + ay * by + az * bz));
            if (sure != 0) {
                return sure > 0;
            }
            EXACT.count();
            return new ExactCylinders(a, b).parallelTouch();
        }
        Gjk gjk = s.gjk.pair;
        int decided = gjk.decide(a, b);
        if (decided != 0) {
            return decided > 0;
        }
        s.gjk.hull.grow(Double.MIN_VALUE);
        if (s.gjk.hull.lower() > 0) {
            return true;
        }
        if (-s.gjk.hull.upper() > s.gjk.hull.error()) {
            return false; // the slab that GJK did not find
        }
        EXACT.count();
        ExactCylinders exact = new ExactCylinders(a, b);
        if (exact.isApart(gjk.nx(), gjk.ny(), gjk.nz(), s.gjk.hull.x(), s.gjk.hull.y(), s.gjk.hull.z())) {
            return false;
        }
        if (exact.haveInCommon(
                0.5 * gjk.ax() + 0.5 * gjk.bx(), 0.5 * gjk.ay() + 0.5 * gjk.by(), 0.5 * gjk.az() + 0.5 * gjk.bz())) {
            return true;
        }
        // If bounds prove them apart, they are: otherwise an answer would depend on which tree was used.
        if (LeafBounds.areApart(Dimension.SPATIAL, a, b, s.leaf.boundsA, s.leaf.boundsB)) {
            return false;
        }
        s.uncertain = true;
        return true;
    }

    private static boolean areParallel(Leaf a, Leaf b) {
        return new ExactCylinders(a, b).areParallel();
    }

    // If the difference is 0, both products round to the same double, and otherwise to neighbouring ones at worst.
    private static boolean maybeParallel(double ax, double ay, double az, double bx, double by, double bz) {
        double least = 0x1p-50;
        return Math.abs(ay * bz - az * by) < least
                && Math.abs(az * bx - ax * bz) < least
                && Math.abs(ax * by - ay * bx) < least;
    }

    /** Returns +1 for touching, -1 for apart, 0 if doubles cannot decide; {@code cosine} is |a.b|. */
    private static int parallel(Leaf a, double ax, double ay, double az, Leaf b, double cosine) {
        double wx = b.get(0) - a.get(0);
        double wy = b.get(1) - a.get(1);
        double wz = b.get(2) - a.get(2);
        double square = ax * ax + ay * ay + az * az;
        double heights = a.get(4) * square + b.get(4) * cosine;
        double along = Math.abs(wx * ax + wy * ay + wz * az);
        double size = Math.abs(wx * ax) + Math.abs(wy * ay) + Math.abs(wz * az);
        double alongError = ALONG_ERROR * size + HEIGHTS_ERROR * heights + UNDERFLOW;
        double yz = wy * az;
        double zy = wz * ay;
        double zx = wz * ax;
        double xz = wx * az;
        double xy = wx * ay;
        double yx = wy * ax;
        double across = square(yz - zy) + square(zx - xz) + square(xy - yx);
        double permanent = square(Math.abs(yz) + Math.abs(zy))
                + square(Math.abs(zx) + Math.abs(xz))
                + square(Math.abs(xy) + Math.abs(yx));
        double reach = square(a.get(3) + b.get(3)) * square;
        double acrossError = ACROSS_ERROR * permanent + REACH_ERROR * reach + UNDERFLOW;
        if (along - heights > alongError || across - reach > acrossError) {
            return -1;
        }
        return along - heights < -alongError && across - reach < -acrossError ? 1 : 0;
    }

    private static double square(double v) {
        return v * v;
    }
}
