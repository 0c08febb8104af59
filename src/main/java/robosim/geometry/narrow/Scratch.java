package robosim.geometry.narrow;

import org.jspecify.annotations.Nullable;

/**
 * Working memory of the kernels, so that a query allocates nothing. One for each owner of queries; never shared
 * between threads.
 */
public final class Scratch {
    /**
     * Whether a kernel has answered "touch" or 0 without a proof since this was last set to false.
     *
     * <p>Only certified pairs do that (see {@link SpatialOverlap#test} and {@link PlanarOverlap#test}), and only where the
     * true gap is below their stated bound. Kernels only set it; whoever wants to know sets it to false before the
     * question. A question that ends with "apart" may have set it on the way, from a part that did not decide.
     */
    public boolean uncertain;

    final MeshWalk outer = new MeshWalk();
    final MeshWalk inner = new MeshWalk();
    final MeshWalk around = new MeshWalk();

    final MeshRay meshRay = new MeshRay();
    final MeshSight meshSight = new MeshSight();

    /** A placed triangle of the first and of the second mesh, as leaf rows. */
    final double[] triangleA = new double[Leaf.STRIDE];

    final double[] triangleB = new double[Leaf.STRIDE];

    /** What two leaves in contact have in one level. */
    final double[] triangleC = new double[Leaf.STRIDE];

    final double[] triangleD = new double[Leaf.STRIDE];

    /** A point as a sphere's row. */
    final double[] witness = new double[Leaf.STRIDE];

    /** Leaves whose lengths would underflow. */
    final Magnified magnified = new Magnified();

    final double[] box = new double[6];
    final double[] triangleBox = new double[6];
    final double[] meshBox = new double[6];

    /** The bounds of two leaves where these decide. */
    final double[] boundsA = new double[6];

    final double[] boundsB = new double[6];

    /** Distance and penetration of the two leaves of a question, in space or in the plane. */
    final Gjk gjk = new Gjk();

    /** Looks at the two leaves that {@link #gjk} was asked about last. */
    final InnerHull hull = new InnerHull(gjk.first, gjk.second);

    final PolytopePolytope polytopes = new PolytopePolytope();
    final SphereDistance sphereDistance = new SphereDistance();

    /** The projections of the two leaves of a planar question. */
    final PlanarShape planarA = new PlanarShape();

    final PlanarShape planarB = new PlanarShape();
    final PlanarBracket planarBracket = new PlanarBracket();
    final FineOverlap fine = new FineOverlap();
    final Pairs planarPairs = new Pairs(7);

    /** A direction and the depth along it. */
    final double[] planarNormal = new double[3];

    final double[] planarBounds = new double[6];
    final RayInterval ray = new RayInterval();
    final RayRefine refine = new RayRefine();
    final NearestFace face = new NearestFace();
    final PlanarSector sector = new PlanarSector();

    /** A leaf laid flat. */
    final double[] flat = new double[Leaf.STRIDE];

    // What is large and not asked of every world is made when first asked.
    private @Nullable MeshPairs meshPairs;
    private @Nullable ContactPairs pairs;
    private @Nullable SweepScratch sweep;
    private @Nullable Penetration penetration;
    private @Nullable HullOverlap hulls;
    private @Nullable ConeScratch cones;
    private @Nullable SectorOval sectorOval;

    /** Two meshes in space, descended at once. */
    MeshPairs meshPairs() {
        if (meshPairs == null) {
            meshPairs = new MeshPairs(this);
        }
        return meshPairs;
    }

    /** Two meshes seen from above, descended at once. */
    ContactPairs pairs() {
        if (pairs == null) {
            pairs = new ContactPairs(this);
        }
        return pairs;
    }

    SweepScratch sweep() {
        if (sweep == null) {
            sweep = new SweepScratch();
        }
        return sweep;
    }

    Penetration penetration() {
        if (penetration == null) {
            penetration = new Penetration();
        }
        return penetration;
    }

    HullOverlap hulls() {
        if (hulls == null) {
            hulls = new HullOverlap();
        }
        return hulls;
    }

    SectorOval sectorOval() {
        if (sectorOval == null) {
            sectorOval = new SectorOval();
        }
        return sectorOval;
    }

    ConeScratch cones() {
        if (cones == null) {
            cones = new ConeScratch();
        }
        return cones;
    }
}
