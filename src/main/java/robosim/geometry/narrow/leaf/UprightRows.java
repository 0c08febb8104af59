package robosim.geometry.narrow.leaf;

import java.util.Arrays;
import robosim.geometry.index.ArrayGrowth;
import robosim.geometry.index.tiles.OrientedRectangle;

/**
 * Upright boxes, cylinders and spheres, stored in half of a {@link Leaf}'s row: the most frequent leaves of a world. A
 * box has its cosine and sine at {@link #COS} and {@link #SIN} instead of nine numbers; the other numbers are as in a
 * full row. Every half row is also an {@link robosim.geometry.index.tiles.OrientedRectangle}; for objects with other leaves it is
 * only that.
 */
public final class UprightRows {
    public static final int COS = OrientedRectangle.COS;
    public static final int SIN = OrientedRectangle.SIN;

    /** Offset of the centre's height; NaN if the row is only an outline. */
    private static final int Y = 1;

    /** Marks a cylinder or sphere in place of the sine; no box has this value. */
    private static final double ROUND = -0.0;

    /** An empty instance for columns without half rows. */
    static final UprightRows NONE = new UprightRows();

    private static final byte VACANT = -1;
    private static final byte BOX = LeafKind.UPRIGHT_BOX.code();

    private int size;
    private byte[] kinds = new byte[0];

    // Code that reads a cylinder or sphere as a full row copies a full row's numbers.
    private double[] rows = OrientedRectangle.rows(0, Leaf.STRIDE);

    private final double[] spread = new double[Leaf.STRIDE];

    /**
     * A view of these rows, which must not be changed any more, with its own working memory, for one more thread to
     * read.
     */
    UprightRows view() {
        UprightRows view = new UprightRows();
        view.size = size;
        view.kinds = kinds;
        view.rows = rows;
        return view;
    }

    /** Whether a leaf fits into a half row: expanding that must give the full row to the bit. */
    static boolean takes(LeafKind kind, double[] row, int at) {
        return switch (kind) {
            case UPRIGHT_CYLINDER, SPHERE -> true;
            case UPRIGHT_BOX ->
                isZero(row[at + 7])
                        && isZero(row[at + 9])
                        && row[at + 10] == 1
                        && isZero(row[at + 11])
                        && isZero(row[at + 13])
                        && same(row[at + 12], 0.0 - row[at + 8])
                        && same(row[at + 14], row[at + 6])
                        && !same(row[at + 8], ROUND);
            case BOX, CYLINDER, TRIANGLE, PRISM, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> false;
        };
    }

    private static boolean isZero(double number) {
        return same(number, 0.0);
    }

    private static boolean same(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }

    int size() {
        return size;
    }

    /** The kind at a place, as {@link LeafKind#of} takes it. */
    byte code(int place) {
        return kinds[place];
    }

    /** Whether the half row that begins at an index is a cylinder or sphere. */
    public static boolean isRound(double[] rows, int at) {
        return same(rows[at + SIN], ROUND);
    }

    double[] rows() {
        return rows;
    }

    /** Makes room for a half row and all before it. */
    void reserve(int place) {
        if (place >= kinds.length) {
            resize(place < ArrayGrowth.FIRST ? ArrayGrowth.FIRST : ArrayGrowth.of(place));
        }
        while (size <= place) {
            kinds[size++] = VACANT;
        }
    }

    /** Writes only the outline of an object that has other leaves. */
    void outline(int place, double minX, double minZ, double maxX, double maxZ) {
        OrientedRectangle.write(rows, place, minX, minZ, maxX, maxZ);
        rows[OrientedRectangle.at(place) + Y] = Double.NaN;
    }

    /** Whether a half row is a leaf rather than only an outline. */
    public boolean isHere(int place) {
        return isHere(rows, OrientedRectangle.at(place));
    }

    /** The same for the half row that begins at an index. */
    public static boolean isHere(double[] rows, int at) {
        return !Double.isNaN(rows[at + Y]);
    }

    /** Gives up spare room. */
    void trim() {
        if (kinds.length - size > size >> 6) {
            resize(size);
        }
    }

    private void resize(int capacity) {
        kinds = Arrays.copyOf(kinds, capacity);
        rows = Arrays.copyOf(rows, OrientedRectangle.length(capacity) + Leaf.STRIDE);
    }

    void write(int place, LeafKind kind, double[] row, int at) {
        kinds[place] = kind.code();
        int to = OrientedRectangle.at(place);
        System.arraycopy(row, at, rows, to, Leaf.ROTATION);
        if (kind == LeafKind.UPRIGHT_BOX) {
            rows[to + COS] = row[at + 6];
            rows[to + SIN] = row[at + 8];
        } else { // the square around it
            rows[to + OrientedRectangle.HALF_Z] = row[at + Leaf.SIZE];
            rows[to + COS] = 1;
            rows[to + SIN] = ROUND;
        }
    }

    void vacate(int place) {
        kinds[place] = VACANT;
    }

    boolean isVacant(int place) {
        return kinds[place] == VACANT;
    }

    /**
     * An array that contains a half row expanded to a {@link Leaf}'s numbers, from {@link #at} on; valid until another
     * is read.
     */
    double[] rows(int place) {
        return kinds[place] == BOX ? spread : rows;
    }

    /** The index at which they begin. */
    int at(int place) {
        int from = OrientedRectangle.at(place);
        if (kinds[place] != BOX) {
            return from;
        }
        spread(from, spread, 0);
        return 0;
    }

    /** Writes a half row expanded to a {@link Leaf}'s numbers. */
    void copy(int place, double[] out, int to) {
        if (kinds[place] == BOX) {
            spread(OrientedRectangle.at(place), out, to);
        } else {
            System.arraycopy(rows, OrientedRectangle.at(place), out, to, Leaf.ROTATION);
        }
    }

    private void spread(int from, double[] out, int to) {
        System.arraycopy(rows, from, out, to, Leaf.ROTATION);
        double cos = rows[from + COS];
        double sin = rows[from + SIN];
        out[to + 6] = cos;
        out[to + 7] = 0;
        out[to + 8] = sin;
        out[to + 9] = 0;
        out[to + 10] = 1;
        out[to + 11] = 0;
        out[to + 12] = 0.0 - sin;
        out[to + 13] = 0;
        out[to + 14] = cos;
    }
}
