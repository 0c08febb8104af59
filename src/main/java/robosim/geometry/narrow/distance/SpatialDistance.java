package robosim.geometry.narrow.distance;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.Upright;
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
    public static double between(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        if (kindA.isVerticalPrism() && kindB.isVerticalPrism()) {
            double planar = PlanarDistance.between(kindA, a, i, kindB, b, j, s);
            double vertical = gap(kindA, a, i, kindB, b, j);
            return vertical == 0 ? planar : planar == 0 ? vertical : VectorMath.legs(planar, vertical);
        }
        if (kindA == LeafKind.SPHERE && SphereDistance.isFor(kindB, a, i, b, j)) {
            return s.sphereDistance.between(a, i, kindB, b, j);
        }
        if (kindB == LeafKind.SPHERE && SphereDistance.isFor(kindA, b, j, a, i)) {
            return s.sphereDistance.between(b, j, kindA, a, i);
        }
        return PairOrder.isReversed(kindA, a, i, kindB, b, j)
                ? bracketed(kindB, b, j, kindA, a, i, s)
                : bracketed(kindA, a, i, kindB, b, j, s);
    }

    private static double bracketed(
            LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, DistanceScratch s) {
        Gjk gjk = s.gjk.pair;
        double lower = gjk.spatial(kindA, a, i, kindB, b, j);
        if (lower == 0 && SpatialOverlap.test(kindA, a, i, kindB, b, j, s.overlap)) {
            return 0;
        }
        if (lower == 0) {
            gjk.spatial(kindA, a, i, kindB, b, j); // the test may have used it for another query
        }
        if (!gjk.isClosed()) {
            lower = gjk.close();
        }
        return isBracketed(kindA) || isBracketed(kindB) ? lower : Math.max(0, gjk.reach());
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
    private static double gap(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        if (Upright.heightsTouch(kindA, a, i, kindB, b, j)) {
            return 0;
        }
        return Math.max(above(kindA, a, i, kindB, b, j), above(kindB, b, j, kindA, a, i));
    }

    /** How far the minimum height of a is above the maximum of b. */
    private static double above(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        double base = Upright.middle(kindA, a, i);
        double down = Upright.halfHeight(kindA, a, i);
        double top = Upright.top(kindB, b, j);
        double up = Upright.halfHeight(kindB, b, j);
        double between = base - top;
        double sizes = down + up;
        double lost = DoubleDouble.sumTail(base, -top, between) - DoubleDouble.sumTail(down, up, sizes);
        return (between - sizes) + lost;
    }
}
