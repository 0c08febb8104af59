package robosim.geometry.narrow;

/**
 * Working memory of the kernels, so that a query allocates nothing. One for each owner of queries; never shared
 * between threads.
 */
public final class Scratch {
    final RayInterval ray = new RayInterval();
    final RayRefine refine = new RayRefine();
    final NearestFace face = new NearestFace();
    final Cone cone = new Cone();
    final ConePolytope conePolytope = new ConePolytope();
    final ConeCylinder coneCylinder = new ConeCylinder();
}
