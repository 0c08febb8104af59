package robosim.geometry.narrow;

/** The working memory of planar kernels. */
public class PlanarScratch extends LeafScratch {
    /** The projections of the two leaves of a planar question. */
    public final PlanarShape planarA = new PlanarShape();

    public final PlanarShape planarB = new PlanarShape();
    public final PlanarBracket planarBracket = new PlanarBracket();
    public final FineOverlap fine = new FineOverlap();
    public final Pairs planarPairs = new Pairs(7);

    /** A direction and the depth along it. */
    public final double[] planarNormal = new double[3];

    public final double[] planarBounds = new double[6];
}
