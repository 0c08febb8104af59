package robosim.geometry.narrow;

/** The working memory of separating axes. */
public class SatScratch extends GjkScratch {
    public final PolytopePolytope polytopes = new PolytopePolytope();
}
