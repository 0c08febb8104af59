package robosim.geometry.narrow.leaf;

/**
 * What kernels about leaves work in, so that a query allocates nothing; each room adds its own to that of the rooms below. One for
 * each owner of queries, never shared between threads.
 */
public class LeafScratch {
    public final MeshWalk outer = new MeshWalk();
    public final MeshWalk inner = new MeshWalk();
    public final MeshWalk around = new MeshWalk();

    /** A placed triangle of the first and of the second mesh, as leaf rows. */
    public final double[] triangleA = new double[Leaf.STRIDE];

    public final double[] triangleB = new double[Leaf.STRIDE];

    /** A leaf laid flat. */
    public final double[] flat = new double[Leaf.STRIDE];

    /** Leaves whose lengths would underflow. */
    public final UnderflowScaling scaling = new UnderflowScaling();

    public final double[] box = new double[6];
    public final double[] triangleBox = new double[6];
    public final double[] meshBox = new double[6];

    /** The bounds of two leaves where these decide. */
    public final double[] boundsA = new double[6];

    public final double[] boundsB = new double[6];
}
