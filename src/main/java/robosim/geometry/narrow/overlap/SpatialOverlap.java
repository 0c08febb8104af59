package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.Stages;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.Order;
import robosim.geometry.narrow.leaf.Upright;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactAxes;
import robosim.geometry.narrow.sat.ExactCylinder;
import robosim.geometry.narrow.sat.ExactPolytope;
import robosim.geometry.narrow.sat.ExactSphere;

/** Whether two leaves touch or overlap in space. */
public final class SpatialOverlap {
    /**
     * For the comparison of squares, with u = 2^-53: an offset 1u, which counts twice in its square, the square 1u, the
     * sum of three 2u, so 5u; the reach likewise 3u; their difference keeps its sign.
     */
    private static final double SPHERES_FILTER = Filter.bound(5.01 * 0x1p-53);

    private static final double UNDERFLOW = 0x1p-1000;
    private static final Stages.Counter EXACT = Stages.counter("SpatialOverlap");
    private static final Stages.Counter EXACT_SPHERES = Stages.counter("SpatialOverlap.spheres");

    private SpatialOverlap() {}

    /**
     * Whether two leaves touch or overlap; the same for (a, b) and (b, a).
     *
     * <p>Exact for the stored numbers, except for two cylinders whose axes are not parallel, for a prism with a sphere
     * or a turned cylinder, and where {@link PlanarOverlap} is not exact. These are certified: see {@link
     * CylinderCylinder#touch}; prisms, which are enclosures and only must not miss anything, are apart from round
     * shapes only if a slab between the two is wider than its rounding error, some 2^-48 of the sizes and the offset.
     */
    public static boolean test(int kindA, double[] a, int i, int kindB, double[] b, int j, OverlapScratch s) {
        if (Leaf.isUpright(kindA) && Leaf.isUpright(kindB)) {
            return Upright.heightsTouch(kindA, a, i, kindB, b, j) && PlanarOverlap.test(kindA, a, i, kindB, b, j, s);
        }
        return Order.isReversed(kindA, a, i, kindB, b, j)
                ? ordered(kindB, b, j, kindA, a, i, s)
                : ordered(kindA, a, i, kindB, b, j, s);
    }

    private static boolean ordered(int kindA, double[] a, int i, int kindB, double[] b, int j, OverlapScratch s) {
        if (isPolytope(kindA) && isPolytope(kindB)) {
            return s.polytopes.touch(kindA, a, i, kindB, b, j);
        }
        if (kindA == Leaf.SPHERE && kindB == Leaf.SPHERE) {
            return spheres(a, i, b, j);
        }
        if (isCylinder(kindA) && isCylinder(kindB)) {
            return CylinderCylinder.touch(kindA, a, i, kindB, b, j, s);
        }
        if (Filter.isDoubting() && hasExact(kindA, kindB)) {
            return exactly(kindA, a, i, kindB, b, j, s);
        }
        Gjk gjk = s.gjk;
        gjk.spatial(kindA, a, i, kindB, b, j);
        if (gjk.lower() > 0) {
            return false;
        }
        return gjk.isDeep() || exactly(kindA, a, i, kindB, b, j, s);
    }

    /** Whether {@link #exactly} decides for certain. */
    private static boolean hasExact(int kindA, int kindB) {
        return kindA != Leaf.PRISM && kindB != Leaf.PRISM;
    }

    /** Decides cases for which neither a slab nor a common point was found. */
    private static boolean exactly(int kindA, double[] a, int i, int kindB, double[] b, int j, OverlapScratch s) {
        EXACT.count();
        if (kindA == Leaf.SPHERE && kindB != Leaf.PRISM) {
            return sphere(new ExactSphere(a, i), kindB, b, j);
        }
        if (kindB == Leaf.SPHERE && kindA != Leaf.PRISM) {
            return sphere(new ExactSphere(b, j), kindA, a, i);
        }
        if (isPolytope(kindA) && isCylinder(kindB)) {
            return new ExactCylinder(kindB, b, j).touchesPolytope(new ExactPolytope(kindA, a, i));
        }
        if (isCylinder(kindA) && isPolytope(kindB)) {
            return new ExactCylinder(kindA, a, i).touchesPolytope(new ExactPolytope(kindB, b, j));
        }
        if (isPolytope(kindA) || isPolytope(kindB)) {
            return !ExactAxes.areApart(AxisBody.SPATIAL, kindA, a, i, kindB, b, j); // one is a prism
        }
        s.uncertain = true; // a prism and a round shape: no slab was wide enough
        return true;
    }

    private static boolean sphere(ExactSphere sphere, int kind, double[] row, int at) {
        if (isCylinder(kind)) {
            return sphere.touchesCylinder(new ExactCylinder(kind, row, at));
        }
        return sphere.touchesPolytope(new ExactPolytope(kind, row, at));
    }

    private static boolean spheres(double[] a, int i, double[] b, int j) {
        double dx = b[j] - a[i];
        double dy = b[j + 1] - a[i + 1];
        double dz = b[j + 2] - a[i + 2];
        double r = a[i + Leaf.SIZE] + b[j + Leaf.SIZE];
        double apart = dx * dx + dy * dy + dz * dz;
        double reach = r * r;
        double bound = SPHERES_FILTER * (apart + reach) + UNDERFLOW;
        if (apart - reach > bound) {
            return false;
        }
        if (apart - reach < -bound) {
            return true;
        }
        EXACT_SPHERES.count();
        return new ExactSphere(a, i).touchesSphere(b, j);
    }

    private static boolean isPolytope(int kind) {
        return kind == Leaf.UPRIGHT_BOX || kind == Leaf.BOX || kind == Leaf.TRIANGLE;
    }

    private static boolean isCylinder(int kind) {
        return kind == Leaf.UPRIGHT_CYLINDER || kind == Leaf.CYLINDER;
    }
}
