package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.UprightLeaves;
import robosim.geometry.narrow.sat.ExactCapsule;
import robosim.geometry.narrow.sat.ExactCylinder;
import robosim.geometry.narrow.sat.ExactPolytope;

/** Whether two leaves touch or overlap in space. */
public final class SpatialOverlap {
    /**
     * For the comparison of squares, with u = 2^-53: an offset 1u, which counts twice in its square, the square 1u, the
     * sum of three 2u, so 5u; the reach likewise 3u; their difference keeps its sign.
     */
    private static final double SPHERES_FILTER = FilterBound.bound(5.01 * 0x1p-53);

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
    public static boolean test(Leaf a, Leaf b, OverlapScratch s) {
        if (a.kind.isVerticalPrism() && b.kind.isVerticalPrism()) {
            return UprightLeaves.heightsTouch(a, b) && PlanarOverlap.test(a, b, s);
        }
        return PairOrder.isReversed(a, b) ? ordered(b, a, s) : ordered(a, b, s);
    }

    private static boolean ordered(Leaf a, Leaf b, OverlapScratch s) {
        if (a.kind.isPolytope() && b.kind.isPolytope()) {
            return s.polytopes.touch(a, b);
        }
        if (a.kind == LeafKind.SPHERE && b.kind == LeafKind.SPHERE) {
            return spheres(a, b);
        }
        if (a.kind.isCylinder() && b.kind.isCylinder()) {
            return CylinderCylinder.touch(a, b, s);
        }
        if (FilterBound.isDoubting() && !a.kind.isEnclosure() && !b.kind.isEnclosure()) {
            return exactly(a, b, s);
        }
        int decided = s.gjk.pair.decide(a, b);
        return decided > 0 || (decided == 0 && exactly(a, b, s));
    }

    /** What neither a slab nor a common point could decide; certain but for a prism and something else. */
    private static boolean exactly(Leaf a, Leaf b, OverlapScratch s) {
        EXACT.count();
        if (a.kind.isEnclosure() || b.kind.isEnclosure()) {
            return uncertain(s);
        }
        return a.kind.isRound() ? round(a, b, s) : round(b, a, s);
    }

    private static boolean round(Leaf a, Leaf b, OverlapScratch s) {
        return switch (a.kind) {
            case SPHERE -> sphere(a, b, s);
            case UPRIGHT_CYLINDER, CYLINDER -> cylinder(a, b, s);
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(a, b, s);
            case UPRIGHT_BOX, BOX, TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> throw a.kind.refused();
        };
    }

    private static boolean sphere(Leaf a, Leaf b, OverlapScratch s) {
        return switch (b.kind) {
            case UPRIGHT_CYLINDER, CYLINDER -> new ExactCapsule(a).sphereTouches(new ExactCylinder(b));
            case UPRIGHT_BOX, BOX, TRIANGLE, SPHERE, UPRIGHT_CAPSULE, CAPSULE -> capsule(a, b, s);
            case PRISM, MESH, SOLID_MESH, GRID -> throw b.kind.refused();
        };
    }

    private static boolean cylinder(Leaf a, Leaf b, OverlapScratch s) {
        return switch (b.kind) {
            case UPRIGHT_BOX, BOX, TRIANGLE -> new ExactCylinder(a).touchesPolytope(new ExactPolytope(b));
            case SPHERE -> sphere(b, a, s);
            case UPRIGHT_CAPSULE, CAPSULE -> capsule(b, a, s);
            case UPRIGHT_CYLINDER, CYLINDER, PRISM, MESH, SOLID_MESH, GRID ->
                throw b.kind.refused(); // CylinderCylinder
        };
    }

    private static boolean capsule(Leaf a, Leaf b, OverlapScratch s) {
        return switch (b.kind) {
            case UPRIGHT_BOX, BOX, TRIANGLE -> new ExactCapsule(a).touchesPolytope(new ExactPolytope(b));
            case SPHERE, UPRIGHT_CAPSULE, CAPSULE -> new ExactCapsule(a).touches(new ExactCapsule(b));
            case UPRIGHT_CYLINDER, CYLINDER -> CapsuleCylinder.touch(a, b, s);
            case PRISM, MESH, SOLID_MESH, GRID -> throw b.kind.refused();
        };
    }

    /** No slab was wide enough. */
    private static boolean uncertain(OverlapScratch s) {
        s.uncertain = true;
        return true;
    }

    private static boolean spheres(Leaf a, Leaf b) {
        double dx = b.get(0) - a.get(0);
        double dy = b.get(1) - a.get(1);
        double dz = b.get(2) - a.get(2);
        double r = a.get(Leaf.SIZE) + b.get(Leaf.SIZE);
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
        return new ExactCapsule(a).touches(new ExactCapsule(b));
    }
}
