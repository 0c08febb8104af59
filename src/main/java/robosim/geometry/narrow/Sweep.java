package robosim.geometry.narrow;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Rotations;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.mesh.MeshSweep;
import robosim.geometry.narrow.planar.PlainCells;
import robosim.geometry.narrow.sat.ExactExtent;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;
import robosim.geometry.narrow.sweep.SweepScratch;
import robosim.geometry.narrow.sweep.SweptBounds;

/**
 * Sweeps one placed leaf against another at rest, meshes and grids included: the only switch over leaf kinds for sweeps. An
 * instance holds the motion and belongs to one owner of queries.
 */
public final class Sweep {
    /** A mesh with at most this many triangles is bounded triangle by triangle, a larger one by its box. */
    private static final int FEW = 64;

    private final Scratch s;
    private final double[] swept = new double[6];
    private final Leaf mover = new Leaf();
    private final Leaf obstacle = new Leaf();

    /** A mesh's bounds as a moving box. */
    private final Leaf moverBox = new Leaf(LeafKind.UPRIGHT_BOX);

    private Dimension dimension = Dimension.SPATIAL;
    private boolean turns;
    private double dx;
    private double dy;
    private double dz;
    private final PivotTurn turn = new PivotTurn();

    /** The same for kernels, at height 0 where heights do not count. */
    private final PivotTurn kernelTurn = new PivotTurn();

    /**
     * The mover's contacts at the start, if they are to be considered; the moving leaf and triangle, and what is hit
     * first.
     */
    private @Nullable StartContacts standing;

    /** Decides about pairs in place of the kernels, if pairs that come near are asked for; and how near. */
    private @Nullable Pairs pairs;

    private final MeshSweep.Judge meshPair = this::meshPair;
    private final double[] way = new double[3];
    private double least;

    private double margin;

    /** Whether it only matters that something blocks: the first piece found is enough. */
    private boolean isVerdict;

    /** Whether doubles could not tell of some pair. */
    private boolean isUnsure;

    /** Whether pairs of triangles that clearly keep off each other on a turn are left out. */
    private boolean isSieved;

    private int leaf;
    private int own;
    private int ownPiece;
    private int otherPiece;

    public Sweep(Scratch scratch) {
        s = scratch;
    }

    boolean isTurn() {
        return turns;
    }

    /** Whether a leaf that starts and ends on one side of a plane stays there in between; exact. */
    boolean keeps(ExactVector normal, Leaf leaf) {
        if (!turns) {
            return true;
        }
        return normal.cross(ExactVector.of(turn.wx, turn.wy, turn.wz)).isZero() || isTurnedIntoItself(leaf);
    }

    /** The same for a horizontal plane. */
    boolean keepsLevel(Leaf leaf) {
        return !turns || turn.isLevel() || isTurnedIntoItself(leaf);
    }

    private boolean isTurnedIntoItself(Leaf leaf) {
        boolean flat = dimension == Dimension.PLANAR;
        boolean isLevel = turn.isLevel();
        if (leaf.get(0) != turn.px || leaf.get(2) != turn.pz || (leaf.get(1) != turn.py && !(isLevel || flat))) {
            return false;
        }
        return switch (leaf.kind) {
            case SPHERE -> true;
            case UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> isLevel;
            case CYLINDER, CAPSULE ->
                ExactExtent.axis(leaf)
                        .cross(ExactVector.of(turn.wx, turn.wy, turn.wz))
                        .isZero();
            case UPRIGHT_BOX, BOX, TRIANGLE, PRISM, MESH, SOLID_MESH, GRID -> false;
        };
    }

    /** Whether translations of two kinds of leaves are decided without rounding; an enclosure's are not. */
    public static boolean isExact(Dimension dimension, LeafKind a, LeafKind b) {
        boolean isFlat = dimension == Dimension.PLANAR;
        return (isFlat ? isExactInPlane(a) && isExactInPlane(b) : isExactInSpace(a) && isExactInSpace(b))
                || (!isFlat && a.isVerticalPrism() && b.isVerticalPrism() && !a.isEnclosure() && !b.isEnclosure());
    }

    private static boolean isExactInPlane(LeafKind kind) {
        return isExactInSpace(kind) || (kind.isDisc() && !kind.isEnclosure());
    }

    private static boolean isExactInSpace(LeafKind kind) {
        return kind == LeafKind.SPHERE || ((kind.isPolytope() || kind.hasPieces()) && !kind.isEnclosure());
    }

    /** Sets a straight translation. */
    public void translation(Dimension inDimension, double x, double y, double z) {
        dimension = inDimension;
        turns = false;
        dx = x;
        dy = y;
        dz = z;
    }

    /** Sets a turn, which the caller fills in. */
    public PivotTurn turn(Dimension inDimension) {
        dimension = inDimension;
        turns = true;
        return turn;
    }

    /**
     * Writes the direction in which a point of the mover goes, a unit vector, horizontal in PLANAR; 0 if it stays, or if heights
     * do not count but matter, as in PLANAR for turns that tip.
     */
    public void direction(double x, double y, double z, double[] out) {
        if (turns && dimension == Dimension.PLANAR && !turn.isLevel()) {
            Arrays.fill(out, 0, 3, 0);
            return;
        }
        out[0] = dx;
        out[1] = dy;
        out[2] = dz;
        if (turns) {
            double sign = Math.signum(turn.degrees);
            out[0] = sign * (turn.wy * (z - turn.pz) - turn.wz * (y - turn.py));
            out[1] = sign * (turn.wz * (x - turn.px) - turn.wx * (z - turn.pz));
            out[2] = sign * (turn.wx * (y - turn.py) - turn.wy * (x - turn.px));
        }
        if (dimension == Dimension.PLANAR) {
            out[1] = 0;
        }
        double length = VectorMath.anyLength(out[0], out[1], out[2]);
        for (int k = 0; k < 3; k++) {
            out[k] = length > 0 ? out[k] / length : 0;
        }
    }

    /** Bounds, rounded outward, of all places of a leaf during the motion. */
    public void bounds(LeafColumn column, int leaf, double[] out) {
        LeafKind kind = column.kind(leaf);
        if (!kind.isMesh()) {
            bounds(mover.set(column, leaf), out);
            return;
        }
        double[] box = s.leaf.meshBox;
        column.bounds(leaf, box);
        boxRow(box, moverBox.row);
        bounds(moverBox, out);
    }

    /** The same, but with each triangle of a mesh on its own, if the moving bounds of the mesh would be too large. */
    public void tightBounds(LeafColumn column, int leaf, double[] out) {
        if (!column.kind(leaf).isMesh()) {
            bounds(column, leaf, out);
            return;
        }
        column.bounds(leaf, s.leaf.meshBox);
        Arrays.fill(out, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(out, 3, 6, Double.NEGATIVE_INFINITY);
        s.leaf.outer.startBox(column, leaf, s.leaf.meshBox);
        for (int t = s.leaf.outer.next(0); t >= 0; t = s.leaf.outer.next(0)) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            bounds(s.leaf.faceA, swept);
            for (int k = 0; k < 3; k++) {
                out[k] = Math.min(out[k], swept[k]);
                out[3 + k] = Math.max(out[3 + k], swept[3 + k]);
            }
        }
    }

    /**
     * Extends the bounds of x + z (two numbers) and of x - z (two more), which hold at the start, to hold for the leaf
     * anywhere on a turn.
     */
    public void turnDiagonals(LeafColumn column, int leaf, double[] out4) {
        LeafKind kind = column.kind(leaf);
        if (!kind.isMesh()) {
            turnDiagonals(mover.set(column, leaf), out4);
            return;
        }
        double[] box = s.leaf.meshBox;
        column.bounds(leaf, box);
        if (column.mesh(leaf).size() <= FEW) {
            s.leaf.outer.startBox(column, leaf, box);
            for (int t = s.leaf.outer.next(0); t >= 0; t = s.leaf.outer.next(0)) {
                s.leaf.outer.corners(t, s.leaf.triangleA, 0);
                turnDiagonals(s.leaf.faceA, out4);
            }
            return;
        }
        out4[0] = Math.min(out4[0], Math.nextDown(box[0] + box[2]));
        out4[1] = Math.max(out4[1], Math.nextUp(box[3] + box[5]));
        out4[2] = Math.min(out4[2], Math.nextDown(box[0] - box[5]));
        out4[3] = Math.max(out4[3], Math.nextUp(box[3] - box[2]));
        boxRow(box, moverBox.row);
        turnDiagonals(moverBox, out4);
    }

    private void turnDiagonals(Leaf leaf, double[] out4) {
        SweptBounds.turnDiagonals(leaf, turn, out4, s.sweep);
    }

    private static void boxRow(double[] box, double[] row) {
        for (int k = 0; k < 3; k++) {
            row[k] = box[k] / 2 + box[3 + k] / 2;
            row[3 + k] = Math.nextUp(Math.max(box[3 + k] - row[k], row[k] - box[k]));
        }
        Rotations.identity(row, Leaf.ROTATION);
    }

    private void bounds(Leaf leaf, double[] out) {
        if (turns) {
            SweptBounds.turn(leaf, turn, out, s.sweep);
        } else {
            SweptBounds.translation(leaf, dx, dy, dz, out);
        }
        widen(out);
    }

    private void widen(double[] box) {
        for (int k = 0; k < 3 && margin > 0; k++) {
            box[k] = Math.nextDown(box[k] - margin);
            box[3 + k] = Math.nextUp(box[3 + k] + margin);
        }
    }

    /**
     * The mover's triangle that hit something first, as a position in the order of the leaves; -1 if it is not a mesh.
     */
    public int ownPiece() {
        return ownPiece;
    }

    /** The same for the triangle that was hit, or the cell of a grid. */
    public int otherPiece() {
        return otherPiece;
    }

    /** Decides how far the motion may go with regard to a pair of pieces. */
    public interface Pairs {
        /**
         * The fraction of the motion that is free; +Infinity for all of it.
         *
         * @param t     the mover's triangle, as a position in the order of the leaves, or -1
         * @param u     the same for the other's triangle, or the cell of a grid
         * @param least a result above this does not matter
         */
        double share(int t, int u, double least);
    }

    /** As {@link #free(LeafColumn, int, LeafColumn, int)}, but pieces behind a contact plane of the mover do not block. */
    public double free(LeafColumn a, int i, LeafColumn b, int j, StartContacts on) {
        standing = on;
        try {
            return free(a, i, b, j);
        } finally {
            standing = null; // also where the work is ended
        }
    }

    /**
     * The least of what is decided about each pair of pieces whose bounds come within a distance of each other, except
     * those behind a contact plane of the mover.
     */
    public double nearby(LeafColumn a, int i, LeafColumn b, int j, StartContacts on, double distance, Pairs decide) {
        pairs = decide;
        margin = distance;
        try {
            return on.isEmpty() ? free(a, i, b, j) : free(a, i, b, j, on);
        } finally {
            pairs = null;
            margin = 0;
        }
    }

    /**
     * Whether {@link #free} is below +Infinity.
     *
     * @param on the mover's contacts at the start, if they are to be considered
     */
    public boolean isBlocked(LeafColumn a, int i, LeafColumn b, int j, @Nullable StartContacts on) {
        standing = on;
        isVerdict = true;
        boolean hasPieces = a.kind(i).hasPieces() || b.kind(j).hasPieces();
        try {
            if (hasPieces && on == null) { // mostly some pair tells, and the exact kernels are not needed
                s.sweep.need = SweepScratch.Need.SURE_VERDICT;
                isUnsure = false;
                boolean isMet = free(a, i, b, j) != Double.POSITIVE_INFINITY;
                if (isMet || !isUnsure) {
                    return isMet;
                }
            }
            s.sweep.need = SweepScratch.Need.VERDICT;
            return free(a, i, b, j) != Double.POSITIVE_INFINITY;
        } finally {
            standing = null;
            isVerdict = false;
            s.sweep.need = SweepScratch.Need.TIME;
        }
    }

    /**
     * The fraction of the motion during which leaf i of a does not touch leaf j of b: +Infinity if it never does, else
     * from 0 to 1, rounded down. A contact at the start blocks only motion deeper into it.
     */
    public double free(LeafColumn a, int i, LeafColumn b, int j) {
        s.work.take();
        leaf = i;
        own = -1;
        ownPiece = -1;
        otherPiece = -1;
        LeafKind kindA = a.kind(i);
        LeafKind kindB = b.kind(j);
        if (!kindA.isMesh() && !kindB.hasPieces()) {
            return piece(mover.set(a, i), obstacle.set(b, j), -1, Double.POSITIVE_INFINITY);
        }
        if (!kindA.isMesh()) {
            return againstPieces(mover.set(a, i), b, j);
        }
        if (kindB.isMesh() && !turns && pairs == null) {
            return meshes(a, i, b, j);
        }
        double least = Double.POSITIVE_INFINITY;
        obstacleBounds(b, j);
        isSieved = kindB.isMesh() && turns && pairs == null && (dimension == Dimension.SPATIAL || turn.isLevel());
        if (isSieved) {
            s.sweep.turnTriangles(turn, dimension == Dimension.PLANAR);
        }
        // A moving mesh: each triangle whose path may hit the obstacle.
        s.leaf.outer.startBox(a, i, reach(a, i));
        for (int t = s.leaf.outer.next(0); t >= 0; t = s.leaf.outer.next(0)) {
            s.leaf.outer.corners(t, s.leaf.triangleA, 0);
            bounds(s.leaf.faceA, swept);
            if (overlaps(swept, s.leaf.triangleBox)) {
                own = t;
                int before = otherPiece;
                double share = kindB.isMesh()
                        ? againstSwept(s.leaf.faceA, b, j)
                        : kindB.isGrid()
                                ? againstGrid(s.leaf.faceA, b, j)
                                : piece(s.leaf.faceA, obstacle.set(b, j), -1, least);
                boolean isFirst =
                        share < least || (share == least && ownPiece >= 0 && isLower(s.leaf.outer, t, ownPiece));
                if (share != Double.POSITIVE_INFINITY && isFirst) {
                    least = share;
                    ownPiece = t;
                } else {
                    otherPiece = before;
                }
                if (isEnough(least)) {
                    return least;
                }
                obstacleBounds(b, j);
            }
        }
        return least;
    }

    private boolean isEnough(double share) {
        return isVerdict && share != Double.POSITIVE_INFINITY;
    }

    /** The same for two meshes, of which one is translated. */
    private double meshes(LeafColumn a, int i, LeafColumn b, int j) {
        way[0] = dx;
        way[1] = dy;
        way[2] = dz;
        least = Double.POSITIVE_INFINITY;
        s.leaf.outer.open(a, i);
        s.leaf.inner.open(b, j);
        s.mesh.sweep().descend(dimension, a, i, way, b, j, meshPair);
        return least;
    }

    private double meshPair(int t, int u) {
        s.leaf.outer.corners(t, s.leaf.triangleA, 0);
        s.leaf.inner.corners(u, s.leaf.triangleB, 0);
        if (dimension == Dimension.SPATIAL && MeshSweep.keepApart(s.leaf.triangleA, s.leaf.triangleB, way)) {
            return least;
        }
        own = t;
        double share = piece(s.leaf.faceA, s.leaf.faceB, u, least);
        if (share < least || (share == least && ownPiece >= 0 && isLowerPair(t, u))) {
            least = share;
            ownPiece = t;
            otherPiece = u;
        }
        return isEnough(least) ? -1 : least;
    }

    /** Whether a pair of triangles comes before the one that was met. */
    private boolean isLowerPair(int t, int u) {
        return t == ownPiece ? isLower(s.leaf.inner, u, otherPiece) : isLower(s.leaf.outer, t, ownPiece);
    }

    /**
     * The bounds of the points from which a translation reaches the obstacle's bounds; for a turn, those of the whole
     * mesh.
     */
    private double[] reach(LeafColumn a, int i) {
        double[] box = s.leaf.box;
        if (turns) {
            a.bounds(i, box);
            widen(box);
        } else {
            System.arraycopy(s.leaf.triangleBox, 0, box, 0, 6);
            double slack = margin + 0x1p-46 * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz) + size(box));
            box[0] -= Math.max(0, dx) + slack;
            box[1] -= Math.max(0, dy) + slack;
            box[2] -= Math.max(0, dz) + slack;
            box[3] -= Math.min(0, dx) - slack;
            box[4] -= Math.min(0, dy) - slack;
            box[5] -= Math.min(0, dz) - slack;
        }
        if (dimension == Dimension.PLANAR) {
            box[1] = Double.NEGATIVE_INFINITY;
            box[4] = Double.POSITIVE_INFINITY;
        }
        return box;
    }

    private static double size(double[] box) {
        double size = 0;
        for (double b : box) {
            size += Math.abs(b);
        }
        return size;
    }

    private void obstacleBounds(LeafColumn b, int j) {
        b.bounds(j, s.leaf.triangleBox);
    }

    private boolean overlaps(double[] a, double[] b) {
        return a[0] <= b[3]
                && b[0] <= a[3]
                && a[2] <= b[5]
                && b[2] <= a[5]
                && (dimension == Dimension.PLANAR || (a[1] <= b[4] && b[1] <= a[4]));
    }

    private double againstPieces(Leaf leaf, LeafColumn b, int j) {
        return b.kind(j).isGrid() ? againstGrid(leaf, b, j) : againstMesh(leaf, b, j);
    }

    /**
     * Whether leaf i of a passes by all cells of a grid on a translation, or meets one that it does not touch at the start: see
     * {@link PlainCells#compare}. Doubles do not always tell.
     */
    public int passesCells(LeafColumn a, int i, LeafColumn grid, int of) {
        return s.planar.plainCells.compare(dimension, mover.set(a, i), dx, dy, dz, grid, of);
    }

    private double againstGrid(Leaf leaf, LeafColumn grid, int of) {
        if (!turns
                && pairs == null
                && s.planar.plainCells.compare(dimension, leaf, dx, dy, dz, grid, of) == PlainCells.PAST) {
            otherPiece = -1;
            return Double.POSITIVE_INFINITY;
        }
        GridWalk walk = s.leaf.cells(leaf.kind);
        startCells(walk, leaf, grid, of);
        double least = Double.POSITIVE_INFINITY;
        int first = -1;
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            LeafColumn box = walk.piece(cell, leaf.kind);
            double share = piece(leaf, obstacle.set(box, 0), cell, least);
            if (share < least || (share == least && cell < first)) {
                least = share;
                first = cell;
            }
            if (isEnough(least)) {
                break;
            }
        }
        otherPiece = first;
        return least;
    }

    /** Starts with all cells that the motion may meet. */
    private void startCells(GridWalk walk, Leaf leaf, LeafColumn grid, int of) {
        bounds(leaf, swept);
        if (dimension == Dimension.PLANAR) {
            swept[1] = Double.NEGATIVE_INFINITY;
            swept[4] = Double.POSITIVE_INFINITY;
        }
        if (turns) {
            walk.startBox(grid, of, swept);
            return;
        }
        double low = swept[1];
        double high = swept[4];
        LeafBounds.of(leaf.kind, leaf.row, leaf.at, swept);
        widen(swept);
        swept[1] = low;
        swept[4] = high;
        walk.startSwept(grid, of, swept, dx, dz);
    }

    private double againstMesh(Leaf leaf, LeafColumn mesh, int of) {
        bounds(leaf, swept);
        isSieved = false;
        return againstSwept(leaf, mesh, of);
    }

    /** The same with the bounds of the motion found. */
    private double againstSwept(Leaf leaf, LeafColumn mesh, int of) {
        if (dimension == Dimension.PLANAR) {
            swept[1] = Double.NEGATIVE_INFINITY;
            swept[4] = Double.POSITIVE_INFINITY;
        }
        if (isSieved) {
            s.sweep.turnTriangle(leaf.row);
        }
        double least = Double.POSITIVE_INFINITY;
        int first = -1;
        s.leaf.inner.startBox(mesh, of, swept);
        for (int t = s.leaf.inner.next(0); t >= 0; t = s.leaf.inner.next(0)) {
            s.leaf.inner.corners(t, s.leaf.triangleB, 0);
            if (isSieved && s.sweep.isClearOf(s.leaf.triangleB, leaf.row)) {
                continue;
            }
            double share = piece(leaf, s.leaf.faceB, t, least);
            if (share < least || (share == least && first >= 0 && isLower(s.leaf.inner, t, first))) {
                least = share;
                first = t;
            }
            if (isEnough(least)) {
                break;
            }
        }
        otherPiece = first;
        return least;
    }

    private static boolean isLower(MeshWalk walk, int t, int than) {
        return walk.triangle(t) < walk.triangle(than);
    }

    /**
     * The fraction for two pieces; also +Infinity if the other one is behind a contact plane.
     *
     * @param u      the other's triangle, or -1
     * @param before a result above this fraction does not matter
     */
    private double piece(Leaf a, Leaf b, int u, double before) {
        if (standing != null && standing.isBehindLevel(leaf, a, own, b)) {
            return Double.POSITIVE_INFINITY;
        }
        s.sweep.latest = before;
        double share = pairs == null ? convex(a, b) : 0;
        if (Double.isNaN(share)) {
            isUnsure = true;
            return Double.POSITIVE_INFINITY;
        }
        if (standing != null
                && share != Double.POSITIVE_INFINITY
                && share <= before
                && standing.isBehind(leaf, a, own, b)) {
            return Double.POSITIVE_INFINITY;
        }
        return pairs == null ? share : pairs.share(own, u, before);
    }

    private double convex(Leaf a, Leaf b) {
        boolean isFlat = dimension == Dimension.PLANAR;
        Dimension counted = isLevel() ? Dimension.PLANAR : Dimension.SPATIAL;
        double y = isLevel() ? 0 : turns ? turn.py : dy;
        double largest = turns ? VectorMath.largest(turn.px, y, turn.pz) : VectorMath.largest(dx, y, dz);
        UnderflowScaling m = s.leaf.scaling;
        boolean isTakenUp = largest < UnderflowScaling.SMALL && m.take(counted, largest, a, b);
        Leaf one = isTakenUp ? m.first : a;
        Leaf two = isTakenUp ? m.second : b;
        if (turns) {
            kernelTurn.about(turn.px, y, turn.pz).by(turn.wx, turn.wy, turn.wz, turn.degrees);
            PivotTurn by = isTakenUp ? m.up(kernelTurn) : kernelTurn;
            return isFlat ? PlanarSweep.turn(one, by, two, s.sweep) : SpatialSweep.turn(one, by, two, s.sweep);
        }
        double x = isTakenUp ? m.up(dx) : dx;
        double z = isTakenUp ? m.up(dz) : dz;
        y = isTakenUp ? m.up(y) : y;
        return isFlat
                ? PlanarSweep.translation(one, x, y, z, two, s.sweep)
                : SpatialSweep.translation(one, x, y, z, two, s.sweep);
    }

    /** Whether the motion is horizontal. */
    private boolean isLevel() {
        return dimension == Dimension.PLANAR && !(turns && !turn.isLevel());
    }
}
