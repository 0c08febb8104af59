package robosim.geometry.narrow.overlap;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.Leaf;

/** Whether two convex leaves have a point in common. */
public final class ConvexOverlap {
    private ConvexOverlap() {}

    /** Whether they touch or overlap. */
    public static boolean test(Dimension dimension, Leaf a, Leaf b, OverlapScratch s) {
        return dimension == Dimension.PLANAR ? PlanarOverlap.test(a, b, s) : SpatialOverlap.test(a, b, s);
    }

    /** Whether they certainly overlap by more than rounding; false if that is not known. */
    public static boolean isDeep(Dimension dimension, Leaf a, Leaf b, OverlapScratch s) {
        HullOverlap hulls = s.gjk.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(a);
        hulls.below(b);
        return hulls.areDeep();
    }
}
