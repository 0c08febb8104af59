package robosim.geometry.narrow.distance;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.UprightLeaves;
import robosim.geometry.narrow.overlap.SpatialOverlap;

/** The least distance between two leaves in space. */
public final class SpatialDistance {
    private SpatialDistance() {}

    /**
     * The least distance, 0 if {@link SpatialOverlap} says that they touch, or if they are closer than doubles can
     * resolve; the same bits for (a, b) and (b, a).
     *
     * <p>Upright pairs: the planar distance and the gap between the heights, combined. A sphere with anything but a
     * prism: a few ulp below the truth, never above it ({@link SphereDistance}). Boxes, triangles and prisms: off by no
     * more than 2^-44 of the distance and 2^-47 of the sizes and the offset. A cylinder, unless both leaves are
     * upright: the lower end of a bracket, no more than 2^-44 of the distance and 2^-46 of the sizes and the offset
     * below the truth, never above it.
     */
    public static double between(Leaf a, Leaf b, DistanceScratch s) {
        if (a.kind.isVerticalPrism() && b.kind.isVerticalPrism()) {
            double planar = PlanarDistance.between(a, b, s);
            double vertical = gap(a, b);
            return vertical == 0 ? planar : planar == 0 ? vertical : VectorMath.legs(planar, vertical);
        }
        if (a.kind == LeafKind.SPHERE && SphereDistance.isFor(a, b)) {
            return s.sphereDistance.between(a, b);
        }
        if (b.kind == LeafKind.SPHERE && SphereDistance.isFor(b, a)) {
            return s.sphereDistance.between(b, a);
        }
        return PairOrder.isReversed(a, b) ? bracketed(b, a, s) : bracketed(a, b, s);
    }

    private static double bracketed(Leaf a, Leaf b, DistanceScratch s) {
        Gjk gjk = s.gjk.pair;
        double lower = gjk.spatial(a, b);
        if (lower == 0 && ((gjk.isDeep() && !FilterBound.isDoubting()) || SpatialOverlap.test(a, b, s.overlap))) {
            return 0;
        }
        if (lower == 0) {
            gjk.spatial(a, b); // the test may have used it for another query
        }
        if (!gjk.isClosed()) {
            lower = gjk.close();
        }
        return isBracketed(a.kind) || isBracketed(b.kind) ? lower : Math.max(0, gjk.reach());
    }

    /** Whether its nearest point is found to a bracket only: where it is round, but not a ball about a point or a segment. */
    private static boolean isBracketed(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_CYLINDER, CYLINDER -> true;
            case UPRIGHT_BOX, SPHERE, BOX, TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE -> false;
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** The gap between the heights of two upright leaves, to within a rounding; 0 if they touch. */
    static double gap(Leaf a, Leaf b) {
        if (UprightLeaves.heightsTouch(a, b)) {
            return 0;
        }
        return Math.max(above(a, b), above(b, a));
    }

    /** How far the minimum height of a is above the maximum of b. */
    private static double above(Leaf a, Leaf b) {
        double base = UprightLeaves.middle(a);
        double down = UprightLeaves.halfHeight(a);
        double top = UprightLeaves.top(b);
        double up = UprightLeaves.halfHeight(b);
        double between = base - top;
        double sizes = down + up;
        double lost = DoubleDouble.sumTail(base, -top, between) - DoubleDouble.sumTail(down, up, sizes);
        return (between - sizes) + lost;
    }
}
