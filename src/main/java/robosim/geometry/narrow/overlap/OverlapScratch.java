package robosim.geometry.narrow.overlap;

import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafScratch;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.planar.PlanarScratch;
import robosim.geometry.narrow.sat.PolytopePolytope;

/** The working memory of overlap tests. */
public final class OverlapScratch {
    final PolytopePolytope polytopes = new PolytopePolytope();
    public final GjkScratch gjk;
    public final PlanarScratch planar;
    public final LeafScratch leaf;

    /**
     * Whether a kernel has answered "touch" or 0 without a proof since this was last set to false.
     *
     * <p>Only certified pairs set it (see {@link SpatialOverlap#test} and {@link PlanarOverlap#test}), and only if the
     * true gap is below their stated bound. Kernels only set it; a caller that needs it clears it before the query. A
     * query whose result is "apart" may have set it on the way, in a part that did not decide.
     */
    public boolean uncertain;

    /** That of {@link PlanarOverlap}, which kernels ask about leaves that are scaled up already. */
    final UnderflowScaling ovals = new UnderflowScaling();

    /** The part of a leaf in a horizontal contact plane. */
    public final Leaf levelA = new Leaf();

    public final Leaf levelB = new Leaf();

    public OverlapScratch(GjkScratch gjk, PlanarScratch planar, LeafScratch leaf) {
        this.gjk = gjk;
        this.planar = planar;
        this.leaf = leaf;
    }
}
