package robosim.geometry.narrow;

import java.util.Arrays;
import robosim.geometry.index.Growth;

/**
 * Upright boxes and cylinders and spheres that stay where they are, beside each other in half of a {@link Leaf}'s row: what
 * a world has most of. A box has its cosine and sine at {@link #COS} and {@link #SIN} in place of the nine numbers that
 * they make; the others stand as in a row.
 */
final class UprightRows {
    /** Doubles in a row. */
    static final int STRIDE = 8;

    static final int COS = 6;
    static final int SIN = 7;

    /** No rows, for who has none. */
    static final UprightRows NONE = new UprightRows();

    private static final byte VACANT = -1;

    private int size;
    private byte[] kinds = new byte[0];

    // What takes a cylinder or sphere for a row copies as many numbers as a row has.
    private double[] rows = new double[Leaf.STRIDE];

    private final double[] spread = new double[Leaf.STRIDE];

    /** The same rows, which nobody may change any more, with working memory of its own: for one more thread to read. */
    UprightRows view() {
        UprightRows view = new UprightRows();
        view.size = size;
        view.kinds = kinds;
        view.rows = rows;
        return view;
    }

    /** Whether a row can stand here: what it is spread to must be the row to the bit. */
    static boolean takes(int kind, double[] row, int at) {
        return kind == Leaf.UPRIGHT_CYLINDER
                || kind == Leaf.SPHERE
                || (kind == Leaf.UPRIGHT_BOX
                        && isZero(row[at + 7])
                        && isZero(row[at + 9])
                        && row[at + 10] == 1
                        && isZero(row[at + 11])
                        && isZero(row[at + 13])
                        && same(row[at + 12], 0.0 - row[at + 8])
                        && same(row[at + 14], row[at + 6]));
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

    int kind(int place) {
        return kinds[place];
    }

    double[] rows() {
        return rows;
    }

    /** Makes room for one more and answers its place. */
    int append() {
        if (size == kinds.length) {
            resize(size == 0 ? Growth.FIRST : Growth.of(size));
        }
        kinds[size] = VACANT;
        return size++;
    }

    /** Gives up room that there is for more. */
    void trim() {
        if (kinds.length - size > size >> 6) {
            resize(size);
        }
    }

    private void resize(int capacity) {
        kinds = Arrays.copyOf(kinds, capacity);
        rows = Arrays.copyOf(rows, STRIDE * capacity + Leaf.STRIDE);
    }

    void write(int place, int kind, double[] row, int at) {
        kinds[place] = (byte) kind;
        int to = STRIDE * place;
        System.arraycopy(row, at, rows, to, Leaf.ROTATION);
        if (kind == Leaf.UPRIGHT_BOX) {
            rows[to + COS] = row[at + 6];
            rows[to + SIN] = row[at + 8];
        }
    }

    void vacate(int place) {
        kinds[place] = VACANT;
    }

    boolean isVacant(int place) {
        return kinds[place] == VACANT;
    }

    /** What holds the numbers of a place as a {@link Leaf}'s, from {@link #at} on; good until another is asked for. */
    double[] rows(int place) {
        return kinds[place] == Leaf.UPRIGHT_BOX ? spread : rows;
    }

    /** Where they begin. */
    int at(int place) {
        int from = STRIDE * place;
        if (kinds[place] != Leaf.UPRIGHT_BOX) {
            return from;
        }
        spread(from, spread, 0);
        return 0;
    }

    /** Writes the numbers of a place as a {@link Leaf}'s. */
    void copy(int place, double[] out, int to) {
        if (kinds[place] == Leaf.UPRIGHT_BOX) {
            spread(STRIDE * place, out, to);
        } else {
            System.arraycopy(rows, STRIDE * place, out, to, Leaf.ROTATION);
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
