package robosim.geometry.narrow.leaf;

/**
 * One placed leaf: a {@link LeafKind} and {@link #STRIDE} numbers of an array, from an offset on. An instance belongs to the
 * query that sets it, once for each pair, and reads the array when it is asked.
 *
 * <table>
 * <caption>What the numbers of each kind mean</caption>
 * <tr><th>kind</th><th>numbers</th></tr>
 * <tr><td>{@link LeafKind#UPRIGHT_BOX}, {@link LeafKind#BOX}</td><td>0-2 centre, 3-5 half sizes along the own axes, 6-14 rotation</td></tr>
 * <tr><td>{@link LeafKind#UPRIGHT_CYLINDER}</td><td>0-2 centre, 3 radius, 4 half height</td></tr>
 * <tr><td>{@link LeafKind#CYLINDER}</td><td>0-2 centre, 3 radius, 4 half height, 6-14 rotation; its axis is the own Y</td></tr>
 * <tr><td>{@link LeafKind#UPRIGHT_CAPSULE}</td><td>0-2 centre, 3 radius, 4 half length of the segment</td></tr>
 * <tr><td>{@link LeafKind#CAPSULE}</td><td>the same, and 6-14 rotation; its segment lies along the own Y</td></tr>
 * <tr><td>{@link LeafKind#SPHERE}</td><td>0-2 centre, 3 radius</td></tr>
 * <tr><td>{@link LeafKind#TRIANGLE}</td><td>0-8 the three corners</td></tr>
 * <tr><td>{@link LeafKind#PRISM}</td><td>least and greatest x (0, 1), z (2, 3), x+z (4, 5), x-z (6, 7) and y (8, 9)</td></tr>
 * <tr><td>{@link LeafKind#MESH}, {@link LeafKind#SOLID_MESH}</td><td>0-2 centre, 6-14 rotation; the triangles stand beside the
 * row</td></tr>
 * <tr><td>{@link LeafKind#GRID}</td><td>0-2 centre, 4 half height, 6-14 rotation; the cells stand beside the row</td></tr>
 * </table>
 *
 * <p>A rotation is row-major and its columns are the own axes in the world. An upright box has its own Y along the
 * world's, so that [6] = [14] = cos, [8] = sin, [12] = -sin of its heading, and [10] = 1. Zero sizes are legal.
 */
public final class Leaf {
    /** Number of doubles in a row. */
    public static final int STRIDE = 16;

    /** Where the half sizes, or the radius and half height, begin. */
    public static final int SIZE = 3;

    /** Where the nine numbers of the rotation begin. */
    public static final int ROTATION = 6;

    public LeafKind kind;

    public double[] row;

    /** Where its numbers begin. */
    public int at;

    public Leaf(LeafKind kind, double[] row, int at) {
        this.kind = kind;
        this.row = row;
        this.at = at;
    }

    /** A leaf of a kind with numbers of its own. */
    public Leaf(LeafKind kind) {
        this(kind, new double[STRIDE], 0);
    }

    /** One that is set before it is read. */
    public Leaf() {
        this(LeafKind.SPHERE);
    }

    /** Becomes another leaf. */
    public Leaf set(LeafKind toKind, double[] toRow, int toAt) {
        kind = toKind;
        row = toRow;
        at = toAt;
        return this;
    }

    /** Becomes a leaf of a column, valid until another leaf of the column is read. */
    public Leaf set(LeafColumn column, int leaf) {
        return set(column.kind(leaf), column.rows(leaf), column.at(leaf));
    }

    /** Copies another leaf's numbers to its own. */
    public void copy(LeafKind toKind, double[] from, int fromAt) {
        kind = toKind;
        System.arraycopy(from, fromAt, row, at, STRIDE);
    }

    /** One of its numbers. */
    public double get(int k) {
        return row[at + k];
    }
}
