package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.Upright;
import robosim.geometry.narrow.sat.ExactCapsule;
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
    private static final StageCounters.Counter EXACT = StageCounters.counter("SpatialOverlap");
    private static final StageCounters.Counter EXACT_SPHERES = StageCounters.counter("SpatialOverlap.spheres");

    private SpatialOverlap() {}

    /**
     * Whether two leaves touch or overlap; the same for (a, b) and (b, a).
     *
     * <p>Exact for the stored numbers, but for two cylinders whose axes are not parallel, a capsule and a cylinder, and
     * a prism with anything else (or where {@link PlanarOverlap} is not). These are certified: see
     * {@link CylinderCylinder#touch} and {@link CapsuleCylinder#touch};
     * and prisms, which are enclosures and only have to miss nothing, are apart from another kind only where a slab
     * between the two is wider than its rounding error, some 2^-48 of the sizes and the offset.
     */
    public static boolean test(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (kindA.isVerticalPrism() && kindB.isVerticalPrism()) {
            return Upright.heightsTouch(kindA, a, i, kindB, b, j) && PlanarOverlap.test(kindA, a, i, kindB, b, j, s);
        }
        return PairOrder.isReversed(kindA, a, i, kindB, b, j)
                ? ordered(kindB, b, j, kindA, a, i, s)
                : ordered(kindA, a, i, kindB, b, j, s);
    }

    private static boolean ordered(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (kindA.isPolytope() && kindB.isPolytope()) {
            return s.sat.polytopes.touch(kindA, a, i, kindB, b, j);
        }
        if (kindA == LeafKind.SPHERE && kindB == LeafKind.SPHERE) {
            return spheres(a, i, b, j);
        }
        if (kindA.isCylinder() && kindB.isCylinder()) {
            return CylinderCylinder.touch(kindA, a, i, kindB, b, j, s);
        }
        if (Filter.isDoubting() && !kindA.isEnclosure() && !kindB.isEnclosure()) {
            return exactly(kindA, a, i, kindB, b, j, s);
        }
        Gjk gjk = s.gjk.pair;
        gjk.spatial(kindA, a, i, kindB, b, j);
        if (gjk.lower() > 0) {
            return false;
        }
        return gjk.isDeep() || exactly(kindA, a, i, kindB, b, j, s);
    }

    /** What neither a slab nor a common point could decide; certain but for a prism and something else. */
    private static boolean exactly(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        EXACT.count();
        if (kindA.isEnclosure() || kindB.isEnclosure()) {
            return uncertain(s);
        }
        return kindA.isRound() ? round(kindA, a, i, kindB, b, j, s) : round(kindB, b, j, kindA, a, i, s);
    }

    private static boolean round(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindA) {
            case SPHERE -> sphere(a, i, kindB, b, j, s);
            case UPRIGHT_CYLINDER, CYLINDER -> cylinder(kindA, a, i, kindB, b, j, s);
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(kindA, a, i, kindB, b, j, s);
            case UPRIGHT_BOX, BOX, TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw kindA.refused();
        };
    }

    private static boolean sphere(double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindB) {
            case UPRIGHT_BOX, BOX, TRIANGLE -> new ExactSphere(a, i).touchesPolytope(new ExactPolytope(kindB, b, j));
            case SPHERE -> new ExactSphere(a, i).touchesSphere(b, j);
            case UPRIGHT_CYLINDER, CYLINDER -> new ExactSphere(a, i).touchesCylinder(new ExactCylinder(kindB, b, j));
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(kindB, b, j, LeafKind.SPHERE, a, i, s);
            case PRISM, MESH, SOLID_MESH, GRID -> throw kindB.refused();
        };
    }

    private static boolean cylinder(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindB) {
            case UPRIGHT_BOX, BOX, TRIANGLE ->
                new ExactCylinder(kindA, a, i).touchesPolytope(new ExactPolytope(kindB, b, j));
            case SPHERE -> sphere(b, j, kindA, a, i, s);
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(kindB, b, j, kindA, a, i, s);
            case UPRIGHT_CYLINDER, CYLINDER, PRISM, MESH, SOLID_MESH, GRID -> throw kindB.refused(); // CylinderCylinder
        };
    }

    private static boolean capsule(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        return switch (kindB) {
            case UPRIGHT_BOX, BOX, TRIANGLE ->
                new ExactCapsule(kindA, a, i).touchesPolytope(new ExactPolytope(kindB, b, j));
            case SPHERE, UPRIGHT_CAPSULE, CAPSULE ->
                new ExactCapsule(kindA, a, i).touches(new ExactCapsule(kindB, b, j));
            case UPRIGHT_CYLINDER, CYLINDER -> CapsuleCylinder.touch(kindA, a, i, kindB, b, j, s);
            case PRISM, MESH, SOLID_MESH, GRID -> throw kindB.refused();
        };
    }

    /** No slab was wide enough. */
    private static boolean uncertain(OverlapScratch s) {
        s.uncertain = true;
        return true;
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
}
