package robosim.geometry.narrow.sat;

import robosim.geometry.narrow.gjk.GjkScratch;

/** The working memory of separating axes. */
public class SatScratch extends GjkScratch {
    public final PolytopePolytope polytopes = new PolytopePolytope();
}
