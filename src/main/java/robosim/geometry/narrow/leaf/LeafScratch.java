package robosim.geometry.narrow.leaf;

import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.WorkCounter;

/**
 * Working memory of kernels, so that a query allocates nothing; each package extends the scratch of the packages below.
 * One instance for each owner of queries, never shared between threads.
 */
public final class LeafScratch {
    /** Counts what the kernels do. */
    public final WorkCounter work = new WorkCounter();

    public final MeshWalk outer = new MeshWalk(work);
    public final MeshWalk inner = new MeshWalk(work);
    public final MeshWalk around = new MeshWalk(work);

    // Most worlds have no grid, and no two that are compared.
    private @Nullable GridWalk cells;
    private @Nullable GridWalk cellsOfGrid;

    private @Nullable LeafBoxes parts;

    /** The bounds of the leaves of an object that has several. */
    public LeafBoxes parts() {
        LeafBoxes made = parts == null ? new LeafBoxes() : parts;
        parts = made;
        return made;
    }

    /** Walks a grid for a leaf of a kind: another one than for its cells where that is a grid, too. */
    public GridWalk cells(LeafKind kind) {
        GridWalk walk = kind.isGrid() ? cellsOfGrid : cells;
        if (walk != null) {
            return walk;
        }
        GridWalk made = new GridWalk(work);
        if (kind.isGrid()) {
            cellsOfGrid = made;
        } else {
            cells = made;
        }
        return made;
    }

    /** The two leaves of a query. */
    public final Leaf placedA = new Leaf();

    public final Leaf placedB = new Leaf();

    /** A placed triangle of the first and of the second mesh. */
    public final Leaf faceA = new Leaf(LeafKind.TRIANGLE);

    public final Leaf faceB = new Leaf(LeafKind.TRIANGLE);

    /** Their numbers. */
    public final double[] triangleA = faceA.row;

    public final double[] triangleB = faceB.row;

    /** A leaf laid flat. */
    public final double[] flat = new double[Leaf.STRIDE];

    /** Scales up leaves whose products would underflow. */
    public final UnderflowScaling scaling = new UnderflowScaling();

    public final double[] box = new double[6];
    public final double[] triangleBox = new double[6];
    public final double[] meshBox = new double[6];

    /** The bounds of two leaves. */
    public final double[] boundsA = new double[6];

    public final double[] boundsB = new double[6];
}
