package robosim.geometry.narrow.overlap;

import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.LeafKind;

/** Whether two convex leaves have a point in common. */
public final class ConvexOverlap {
    private ConvexOverlap() {}

    /** Whether they touch or overlap. */
    public static boolean test(
            Dimension dimension,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            OverlapScratch s) {
        return dimension == Dimension.PLANAR
                ? PlanarOverlap.test(kindA, a, i, kindB, b, j, s)
                : SpatialOverlap.test(kindA, a, i, kindB, b, j, s);
    }

    /** Whether they certainly overlap by more than rounding; false if that is not known. */
    public static boolean isDeep(
            Dimension dimension,
            LeafKind kindA,
            double[] a,
            int i,
            LeafKind kindB,
            double[] b,
            int j,
            OverlapScratch s) {
        HullOverlap hulls = s.gjk.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(kindA, a, i);
        hulls.below(kindB, b, j);
        return hulls.areDeep();
    }
}
