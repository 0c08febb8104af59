package robosim.geometry.narrow.sat;

import robosim.geometry.narrow.gjk.GjkScratch;
import robosim.geometry.narrow.leaf.LeafScratch;

/** The working memory of separating axes. */
public final class SatScratch {
    public final GjkScratch gjk;
    public final LeafScratch leaf;

    public final PolytopePolytope polytopes = new PolytopePolytope();

    public SatScratch(GjkScratch gjk, LeafScratch leaf) {
        this.gjk = gjk;
        this.leaf = leaf;
    }
}
