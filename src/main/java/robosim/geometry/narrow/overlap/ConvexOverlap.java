package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Whether two convex leaves have a point in common. */
public final class ConvexOverlap {
    /** More than rounding may add to the depth of balls, as a share of their radii. */
    private static final double DEEP = 0x1p-40;

    private ConvexOverlap() {}

    /** Whether they touch or overlap. */
    public static boolean test(Dimension dimension, Leaf a, Leaf b, OverlapScratch s) {
        return dimension == Dimension.PLANAR ? PlanarOverlap.test(a, b, s) : SpatialOverlap.test(a, b, s);
    }

    /** Whether they certainly overlap by more than rounding; false if that is not known. */
    public static boolean isDeep(Dimension dimension, Leaf a, Leaf b, OverlapScratch s) {
        if (a.kind == LeafKind.SPHERE && b.kind == LeafKind.SPHERE) {
            return areDeepBalls(dimension, a, b);
        }
        HullOverlap hulls = s.gjk.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(a);
        hulls.below(b);
        return hulls.areDeep();
    }

    private static boolean areDeepBalls(Dimension dimension, Leaf a, Leaf b) {
        double x = a.get(0) - b.get(0);
        double y = dimension == Dimension.PLANAR ? 0 : a.get(1) - b.get(1);
        double z = a.get(2) - b.get(2);
        double reach = a.get(3) + b.get(3);
        return Math.sqrt(x * x + y * y + z * z) < reach * (1 - DEEP) - VectorMath.UNDERFLOW;
    }
}
