package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDoubles;

/** The working memory of planar kernels. */
public final class PlanarScratch {
    /** The projections of the two leaves of a planar query. */
    public final PlanarShape planarA = new PlanarShape();

    public final PlanarShape planarB = new PlanarShape();
    public final PlanarBracket planarBracket = new PlanarBracket();
    public final DoubleDoubleOverlap fine = new DoubleDoubleOverlap();
    public final DoubleDoubles planarPairs = new DoubleDoubles(7);

    public final PlainCells plainCells = new PlainCells();

    /** A direction and the depth along it. */
    public final double[] planarNormal = new double[3];

    public final double[] planarBounds = new double[6];
}
