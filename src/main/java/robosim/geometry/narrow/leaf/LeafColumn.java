package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.UpwardRounding;
import robosim.geometry.index.cells.PlacedCells;
import robosim.geometry.index.meshes.BoxTree;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.index.tiles.OrientedRectangle;

/**
 * An array of leaves: for each a kind, a row of {@link Leaf#STRIDE} doubles and, for meshes, the triangles. The column
 * of a world also has half-row leaves, numbered by their object with the bit {@link #UPRIGHT} set; these are read
 * through {@link #rows(int)} and {@link #at}, or by methods that take a leaf's number.
 */
public final class LeafColumn {
    private static final byte VACANT = -1;

    /** Columns with fewer leaves are doubled when they grow. */
    private static final int SMALL = 1 << 15;

    /** The bit that is set in the number of a half-row leaf. */
    public static final int UPRIGHT = 1 << 30;

    // Two products and their sum, and this one, each rounded by 2^-53 of itself.
    private static final double OUTWARD = 1 + 0x1p-50;

    private int size;
    private byte[] kinds;
    private double[] rows;

    private UprightRows upright = UprightRows.NONE;

    /** Null until the first mesh is added. */
    private @Nullable TriangleMesh @Nullable [] meshes;

    /** Null until the first grid is added. */
    private @Nullable PlacedCells @Nullable [] grids;

    /** The bounds of one of several leaves. */
    private final double[] part = new double[6];

    /** An empty column with room for a number of leaves. */
    public LeafColumn(int capacity) {
        kinds = new byte[Math.max(1, capacity)];
        rows = new double[kinds.length * Leaf.STRIDE];
    }

    private LeafColumn(LeafColumn of) {
        size = of.size;
        kinds = of.kinds;
        rows = of.rows;
        meshes = of.meshes;
        grids = of.grids;
        upright = of.upright.view();
    }

    /** A view of these leaves, which must not be changed any more, for one more thread to read. */
    public LeafColumn view() {
        return new LeafColumn(this);
    }

    /** The number of full-row leaves. */
    public int size() {
        return size;
    }

    /** The number of objects, counted from the first, that have a half row. */
    public int uprightSize() {
        return upright.size();
    }

    /** Whether a leaf is a half-row leaf. */
    public static boolean isUpright(int leaf) {
        return (leaf & UPRIGHT) != 0;
    }

    /** Whether the only leaf of this column fits into a half row. */
    public boolean fitsUpright() {
        return size == 1 && !kind(0).hasPieces() && UprightRows.takes(kind(0), rows, 0);
    }

    /** Makes room for the half row of an object. */
    public void reserveUpright(int id) {
        if (upright == UprightRows.NONE) {
            upright = new UprightRows();
        }
        upright.reserve(id);
    }

    /** Writes the outline of an object to its half row, unless the half row is its leaf: see {@link #outlines}. */
    public void outline(int id, double minX, double minZ, double maxX, double maxZ) {
        if (upright.isVacant(id)) {
            upright.outline(id, minX, minZ, maxX, maxZ);
        }
    }

    /** The half rows of all objects, each of which is an {@link robosim.geometry.index.tiles.OrientedRectangle} of the object. */
    public double[] outlines() {
        return upright.rows();
    }

    /** Whether the half row of an object is its only leaf, not just an outline. */
    public boolean isUprightObject(int id) {
        return upright.isHere(id);
    }

    /** An empty column with room for a number of full rows, sharing the half rows of this one. */
    public LeafColumn withUpright(int capacity) {
        LeafColumn column = new LeafColumn(capacity);
        column.upright = upright;
        return column;
    }

    /** Adds room for {@code count} leaves at the end and returns the first one's index. */
    public int append(int count) {
        int first = size;
        size += count;
        if (size > kinds.length) {
            int more = kinds.length < SMALL ? kinds.length : kinds.length >> 2;
            int capacity = Math.max(size, kinds.length + more + 1);
            resize(capacity);
        }
        return first;
    }

    /** Appends copies of leaves of another column as full rows and returns the first one's index. */
    public int appendWhole(LeafColumn other, int first, int count) {
        int at = append(count);
        if (isUpright(first)) {
            kinds[at] = other.kind(first).code();
            other.upright.copy(first ^ UPRIGHT, rows, at * Leaf.STRIDE);
            return at;
        }
        copy(other, first, count, at);
        return at;
    }

    /** Copies all leaves of another column to this one, from a leaf on. */
    public void copy(LeafColumn other, int at) {
        if (isUpright(at)) {
            upright.write(at ^ UPRIGHT, other.kind(0), other.rows, 0);
            return;
        }
        copy(other, 0, other.size, at);
    }

    private void copy(LeafColumn other, int first, int count, int at) {
        System.arraycopy(other.kinds, first, kinds, at, count);
        System.arraycopy(other.rows, first * Leaf.STRIDE, rows, at * Leaf.STRIDE, count * Leaf.STRIDE);
        for (int k = 0; k < count; k++) {
            if (kind(at + k).isMesh()) {
                setMesh(at + k, other.mesh(first + k));
            } else if (kind(at + k).isGrid()) {
                setCells(at + k, other.cells(first + k));
            }
        }
    }

    /** Gives up spare room. */
    public void trim() {
        if (kinds.length - size > size >> 6) {
            resize(size);
        }
        upright.trim();
    }

    private void resize(int capacity) {
        kinds = Arrays.copyOf(kinds, capacity);
        rows = Arrays.copyOf(rows, capacity * Leaf.STRIDE);
        if (meshes != null) {
            meshes = Arrays.copyOf(meshes, capacity);
        }
        if (grids != null) {
            grids = Arrays.copyOf(grids, capacity);
        }
    }

    /** Marks a leaf as vacant. */
    public void vacate(int leaf) {
        if (isUpright(leaf)) {
            upright.vacate(leaf ^ UPRIGHT);
            return;
        }
        kinds[leaf] = VACANT;
        if (meshes != null) {
            meshes[leaf] = null;
        }
        if (grids != null) {
            grids[leaf] = null;
        }
    }

    /** Whether a leaf is vacant. */
    public boolean isVacant(int leaf) {
        return isUpright(leaf) ? upright.isVacant(leaf ^ UPRIGHT) : kinds[leaf] == VACANT;
    }

    /** Removes all leaves. */
    public void clear() {
        size = 0;
        meshes = null;
        grids = null;
    }

    public LeafKind kind(int leaf) {
        return LeafKind.of(isUpright(leaf) ? upright.code(leaf ^ UPRIGHT) : kinds[leaf]);
    }

    /** The kinds of several leaves: for each that there is, the bit of its code. */
    public int kinds(int first, int count) {
        int kinds = 0;
        for (int leaf = first; leaf < first + count; leaf++) {
            kinds |= 1 << kind(leaf).code();
        }
        return kinds;
    }

    public void setKind(int leaf, LeafKind kind) {
        kinds[leaf] = kind.code();
    }

    /** The numbers of all full-row leaves; leaf k begins at {@code k * Leaf.STRIDE}. Valid until the next append. */
    public double[] rows() {
        return rows;
    }

    /** An array that contains the numbers of a leaf, from {@link #at} on; valid until another leaf is read. */
    public double[] rows(int leaf) {
        return isUpright(leaf) ? upright.rows(leaf ^ UPRIGHT) : rows;
    }

    /** The index at which the numbers of a leaf begin. */
    public int at(int leaf) {
        return isUpright(leaf) ? upright.at(leaf ^ UPRIGHT) : leaf * Leaf.STRIDE;
    }

    /** The numbers of all half-row leaves; each begins at {@link #uprightAt}. */
    public double[] uprightRows() {
        return upright.rows();
    }

    public static int uprightAt(int leaf) {
        return OrientedRectangle.at(leaf ^ UPRIGHT);
    }

    /**
     * Sets this column to a single piece: a leaf of another column, a triangle of its mesh, given its position in the
     * order of the leaves, or a cell of its grid.
     */
    public void setPiece(LeafColumn other, int leaf, int piece) {
        clear();
        if (piece < 0) {
            appendWhole(other, leaf, 1);
            return;
        }
        append(1);
        if (other.kind(leaf).isGrid()) {
            setKind(0, LeafKind.UPRIGHT_BOX);
            CellBox.write(other.cells(leaf), other.rows, leaf * Leaf.STRIDE, piece, rows, 0);
            return;
        }
        setKind(0, LeafKind.TRIANGLE);
        other.mesh(leaf).placedAt(piece, other.rows, leaf * Leaf.STRIDE, rows, 0);
    }

    /** The triangles of a leaf that is a mesh. */
    public TriangleMesh mesh(int leaf) {
        if (meshes != null) {
            TriangleMesh mesh = meshes[leaf];
            if (mesh != null) {
                return mesh;
            }
        }
        throw new IllegalStateException("leaf must be a mesh (got: leaf " + leaf + " of kind " + kind(leaf) + ")");
    }

    /** The bounds of a leaf, rounded outward: minimum x, y and z, then maximum. */
    public void bounds(int leaf, double[] out) {
        if (kind(leaf).isMesh()) {
            meshBounds(leaf, out);
        } else if (kind(leaf).isGrid()) {
            gridBounds(leaf, out);
        } else {
            LeafBounds.of(kind(leaf), rows(leaf), at(leaf), out);
        }
    }

    /**
     * Bounds of a leaf as in {@link #bounds}, or slightly wider if that is faster, by less than 2<sup>-48</sup> of the
     * coordinates and sizes.
     */
    public void roughBounds(int leaf, double[] out) {
        int at = leaf * Leaf.STRIDE;
        if (isUpright(leaf)) {
            bounds(leaf, out);
            return;
        }
        switch (kind(leaf)) {
            case UPRIGHT_CYLINDER -> roughBounds(at, rows[at + 3], rows[at + 4], rows[at + 3], out);
            case SPHERE -> roughBounds(at, rows[at + 3], rows[at + 3], rows[at + 3], out);
            case UPRIGHT_BOX -> {
                double cos = Math.abs(rows[at + Leaf.ROTATION]);
                double sin = Math.abs(rows[at + Leaf.ROTATION + 2]);
                double halfX = (rows[at + 3] * cos + rows[at + 5] * sin) * OUTWARD;
                double halfZ = (rows[at + 3] * sin + rows[at + 5] * cos) * OUTWARD;
                roughBounds(at, halfX, rows[at + 4], halfZ, out);
            }
            case BOX, CYLINDER, TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> bounds(leaf, out);
        }
    }

    private void roughBounds(int at, double halfX, double halfY, double halfZ, double[] out) {
        roughRange(rows[at], halfX, out, 0);
        roughRange(rows[at + 1], halfY, out, 1);
        roughRange(rows[at + 2], halfZ, out, 2);
    }

    private static void roughRange(double middle, double half, double[] out, int axis) {
        // More than the rounding of a sum of two.
        double more = half + (0x1p-51 * (Math.abs(middle) + half) + Double.MIN_NORMAL);
        out[axis] = middle - more;
        out[3 + axis] = middle + more;
    }

    /** The bounds of the placed box of a mesh, widened as {@link MeshWalk} widens a query. */
    private void meshBounds(int leaf, double[] out) {
        BoxTree tree = mesh(leaf).tree();
        double[] b = tree.bounds();
        int at = leaf * Leaf.STRIDE;
        for (int k = 0; k < 3; k++) {
            double middle = rows[at + k];
            double half = 0;
            double size = Math.abs(middle);
            for (int j = 0; j < 3; j++) {
                double turn = rows[at + Leaf.ROTATION + 3 * k + j];
                middle += turn * (b[j] / 2 + b[3 + j] / 2);
                half += Math.abs(turn) * (b[3 + j] / 2 - b[j] / 2);
                size += Math.abs(b[j]) + Math.abs(b[3 + j]);
            }
            double pad = MeshWalk.WIDEN * size + MeshWalk.UNDERFLOW;
            out[k] = middle - half - pad;
            out[3 + k] = middle + half + pad;
        }
    }

    /** The bounds of the occupied cells. */
    private void gridBounds(int leaf, double[] out) {
        int at = leaf * Leaf.STRIDE;
        PlacedCells cells = cells(leaf);
        out[0] = cells.bound(0);
        out[1] = 0 - UpwardRounding.sum(-rows[at + 1], rows[at + 4]);
        out[2] = cells.bound(1);
        out[3] = cells.bound(2);
        out[4] = UpwardRounding.sum(rows[at + 1], rows[at + 4]);
        out[5] = cells.bound(3);
    }

    /** The cells of a leaf that is a grid. */
    public PlacedCells cells(int leaf) {
        if (grids != null) {
            PlacedCells cells = grids[leaf];
            if (cells != null) {
                return cells;
            }
        }
        throw new IllegalStateException("leaf must be a grid (got: leaf " + leaf + " of kind " + kind(leaf) + ")");
    }

    void setCells(int leaf, PlacedCells cells) {
        if (grids == null) {
            grids = new PlacedCells[kinds.length];
        }
        grids[leaf] = cells;
    }

    void setMesh(int leaf, TriangleMesh mesh) {
        if (meshes == null) {
            meshes = new TriangleMesh[kinds.length];
        }
        meshes[leaf] = mesh;
    }

    /**
     * Writes outward bounds of several leaves, six numbers.
     *
     * @param number how many leaves, from the first on
     */
    public void bounds(int first, int number, double[] out) {
        bounds(first, out);
        for (int leaf = first + 1; leaf < first + number; leaf++) {
            bounds(leaf, part);
            for (int k = 0; k < 3; k++) {
                out[k] = Math.min(out[k], part[k]);
                out[3 + k] = Math.max(out[3 + k], part[3 + k]);
            }
        }
    }
}
