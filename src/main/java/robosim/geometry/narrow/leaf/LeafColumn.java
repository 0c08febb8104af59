package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.index.boxes.BoxTree;
import robosim.geometry.index.tiles.Outline;
import robosim.geometry.model.TriangleMesh;

/**
 * Leaves beside each other: a kind, a row of {@link Leaf#STRIDE} doubles and, for meshes, the triangles of each. A world's
 * also has leaves of half a row, each with its object's number and the bit {@link #UPRIGHT}: these are read through
 * {@link #rows(int)} and {@link #at}, or left to what asks for a leaf by its number.
 */
public final class LeafColumn {
    private static final byte VACANT = -1;

    /** Columns with fewer leaves grow by as many again. */
    private static final int SMALL = 1 << 15;

    /** The bit in the number of a leaf of half a row. */
    public static final int UPRIGHT = 1 << 30;

    // Two products and their sum, and this one, each rounded by 2^-53 of itself.
    private static final double OUTWARD = 1 + 0x1p-50;

    private int size;
    private byte[] kinds;
    private double[] rows;

    private UprightRows upright = UprightRows.NONE;

    /** None until the first mesh comes. */
    private @Nullable TriangleMesh @Nullable [] meshes;

    /** The bounds of one of several leaves. */
    private final double[] part = new double[6];

    /** An empty column with room for so many leaves. */
    public LeafColumn(int capacity) {
        kinds = new byte[Math.max(1, capacity)];
        rows = new double[kinds.length * Leaf.STRIDE];
    }

    private LeafColumn(LeafColumn of) {
        size = of.size;
        kinds = of.kinds;
        rows = of.rows;
        meshes = of.meshes;
        upright = of.upright.view();
    }

    /** The same leaves, which nobody may change any more, for one more thread to read. */
    public LeafColumn view() {
        return new LeafColumn(this);
    }

    /** How many leaves of whole rows there are. */
    public int size() {
        return size;
    }

    /** For how many objects, from the first number on, there is half a row. */
    public int uprightSize() {
        return upright.size();
    }

    /** Whether a leaf is one of half a row. */
    public static boolean isUpright(int leaf) {
        return (leaf & UPRIGHT) != 0;
    }

    /** Whether the only leaf of this column can be one of half a row. */
    public boolean fitsUpright() {
        return size == 1 && !kind(0).isMesh() && UprightRows.takes(kind(0), rows, 0);
    }

    /** Makes room for the half row of an object. */
    public void reserveUpright(int id) {
        if (upright == UprightRows.NONE) {
            upright = new UprightRows();
        }
        upright.reserve(id);
    }

    /** Writes in an object's half row where it is, unless the row is its leaf: see {@link #outlines}. */
    public void outline(int id, double minX, double minZ, double maxX, double maxZ) {
        if (upright.isVacant(id)) {
            upright.outline(id, minX, minZ, maxX, maxZ);
        }
    }

    /** The half rows of all objects, which are an {@link robosim.geometry.index.tiles.Outline} of each. */
    public double[] outlines() {
        return upright.rows();
    }

    /** Whether the only leaf of an object is the half row of its number, not just an outline. */
    public boolean isUprightObject(int id) {
        return upright.isHere(id);
    }

    /** An empty column with room for so many whole rows, and with the half rows of this one. */
    public LeafColumn withUpright(int capacity) {
        LeafColumn column = new LeafColumn(capacity);
        column.upright = upright;
        return column;
    }

    /** Makes room for {@code count} leaves at the end and answers the first one's index. */
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

    /** Appends copies of leaves of another column in whole rows and answers the first one's index. */
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

    /** Writes copies of all leaves of another column from a leaf on. */
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
            }
        }
    }

    /** Gives up room that there is for more. */
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
    }

    /** Leaves nothing at a leaf's place. */
    public void vacate(int leaf) {
        if (isUpright(leaf)) {
            upright.vacate(leaf ^ UPRIGHT);
            return;
        }
        kinds[leaf] = VACANT;
        if (meshes != null) {
            meshes[leaf] = null;
        }
    }

    /** Whether nothing is at a leaf's place. */
    public boolean isVacant(int leaf) {
        return isUpright(leaf) ? upright.isVacant(leaf ^ UPRIGHT) : kinds[leaf] == VACANT;
    }

    /** Forgets all leaves. */
    public void clear() {
        size = 0;
        meshes = null;
    }

    public LeafKind kind(int leaf) {
        return LeafKind.of(isUpright(leaf) ? upright.code(leaf ^ UPRIGHT) : kinds[leaf]);
    }

    public void setKind(int leaf, LeafKind kind) {
        kinds[leaf] = kind.code();
    }

    /** The numbers of all leaves of whole rows; leaf k begins at {@code k * Leaf.STRIDE}. Valid until the next append. */
    public double[] rows() {
        return rows;
    }

    /** What holds the numbers of a leaf, from {@link #at} on; good until another leaf is asked for. */
    public double[] rows(int leaf) {
        return isUpright(leaf) ? upright.rows(leaf ^ UPRIGHT) : rows;
    }

    /** Where the numbers of a leaf begin. */
    public int at(int leaf) {
        return isUpright(leaf) ? upright.at(leaf ^ UPRIGHT) : leaf * Leaf.STRIDE;
    }

    /** The numbers of all leaves of half a row; each begins at {@link #uprightAt}. */
    public double[] uprightRows() {
        return upright.rows();
    }

    public static int uprightAt(int leaf) {
        return Outline.at(leaf ^ UPRIGHT);
    }

    /** Makes this column hold one piece: a leaf of another, or the triangle of its mesh at a place in the order of the leaves. */
    public void setPiece(LeafColumn other, int leaf, int triangle) {
        clear();
        if (triangle < 0) {
            appendWhole(other, leaf, 1);
            return;
        }
        append(1);
        setKind(0, LeafKind.TRIANGLE);
        other.mesh(leaf).placedAt(triangle, other.rows, leaf * Leaf.STRIDE, rows, 0);
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

    /** The outward bounds of a leaf: least x, y and z, then greatest. */
    public void bounds(int leaf, double[] out) {
        if (kind(leaf).isMesh()) {
            meshBounds(leaf, out);
        } else {
            LeafBounds.of(kind(leaf), rows(leaf), at(leaf), out);
        }
    }

    /**
     * Bounds of a leaf, least x, y and z and then greatest: as {@link #bounds} or, where that is quicker, a little wider, by
     * less than 2<sup>-48</sup> of the coordinates and sizes.
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
            case BOX, CYLINDER, TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH -> bounds(leaf, out);
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

    /** Where the box of the mesh in its own frame comes to stand, widened as {@link MeshWalk} widens a question. */
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
