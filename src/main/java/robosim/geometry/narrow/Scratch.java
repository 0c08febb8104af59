package robosim.geometry.narrow;

/**
 * Working memory of the kernels, so that a query allocates nothing. One for each owner of queries; never shared
 * between threads.
 */
public final class Scratch {
    final SweepScratch sweep = new SweepScratch();

    /** Distance and penetration of the two leaves of a question, in space or in the plane. */
    final Gjk gjk = new Gjk();

    final PolytopePolytope polytopes = new PolytopePolytope();
    final Penetration penetration = new Penetration();

    /** The projections of the two leaves of a planar question. */
    final PlanarShape planarA = new PlanarShape();

    final PlanarShape planarB = new PlanarShape();
    final PlanarBracket planarBracket = new PlanarBracket();

    /** A direction and the depth along it. */
    final double[] planarNormal = new double[3];

    final double[] planarBounds = new double[6];
}
