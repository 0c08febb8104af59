package robosim.geometry.narrow;

/**
 * Working memory of the kernels, so that a query allocates nothing. One for each owner of queries; never shared
 * between threads.
 */
public final class Scratch {
    final RayInterval ray = new RayInterval();
}
