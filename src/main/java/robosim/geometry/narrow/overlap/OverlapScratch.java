package robosim.geometry.narrow.overlap;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.sat.SatScratch;

/** The working memory of overlaps. */
public class OverlapScratch extends SatScratch {
    /**
     * Whether a kernel has answered "touch" or 0 without a proof since this was last set to false.
     *
     * <p>Only certified pairs do that (see {@link SpatialOverlap#test} and {@link PlanarOverlap#test}), and only where the
     * true gap is below their stated bound. Kernels only set it; whoever wants to know sets it to false before the
     * question. A question that ends with "apart" may have set it on the way, from a part that did not decide.
     */
    public boolean uncertain;

    /** What two leaves in contact have in one level. */
    public final double[] triangleC = new double[Leaf.STRIDE];

    public final double[] triangleD = new double[Leaf.STRIDE];
}
