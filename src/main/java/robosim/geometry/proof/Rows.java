package robosim.geometry.proof;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** The stored numbers of a {@link Piece} in plain doubles: where witnesses are looked for, and nothing is decided. */
final class Rows {
    /** More than the rounding of any of these sums, of the magnitudes of their terms. */
    static final double ROUNDING = 64 * 0x1p-53;

    /** More than the rounding of a difference of squares, of their size: its root is larger by the root of this where it is 0. */
    private static final double SQUARES = 0x1p-50;

    private Rows() {}

    static boolean isTriangle(double[] row) {
        return row.length == 9;
    }

    static double dot(double[] row, int at, double[] n) {
        return row[at] * n[0] + row[at + 1] * n[1] + row[at + 2] * n[2];
    }

    /** The product of a normal with an own axis. */
    static double alongAxis(double[] row, int axis, double[] n) {
        return row[3 + axis] * n[0] + row[6 + axis] * n[1] + row[9 + axis] * n[2];
    }

    /** The largest of n.x over a piece. */
    static double most(double[] row, double[] n) {
        if (isTriangle(row)) {
            return Math.max(dot(row, 0, n), Math.max(dot(row, 3, n), dot(row, 6, n)));
        }
        double most = dot(row, 0, n);
        for (int k = 0; k < 3; k++) {
            most += row[12 + k] == 0 ? 0 : row[12 + k] * Math.abs(alongAxis(row, k, n));
        }
        return most + round(row, n);
    }

    /** How much a disc or a ball adds. */
    static double round(double[] row, double[] n) {
        if (row[15] > 0) {
            // Not a difference of squares: the root would make its rounding larger where the normal is nearly the axis.
            double[] up = {row[4], row[7], row[10]};
            return row[15] * length(cross(n, up)) / length(up);
        }
        return row[16] > 0 ? row[16] * length(n) : 0;
    }

    /** The same, or slightly more, of a disc that turns, whose axis has at least this product with the normal. */
    static double round(double[] row, double[] n, double along) {
        double[] up = {row[4], row[7], row[10]};
        double square = product(n, n) * product(up, up);
        return row[15] * Math.sqrt(Math.max(0, square - along * along) + SQUARES * square) / length(up);
    }

    /** Writes a point of a piece with the largest product with a normal of length 1. */
    static void support(double[] row, double[] n, double[] out) {
        if (isTriangle(row)) {
            double a = dot(row, 0, n);
            double b = dot(row, 3, n);
            double c = dot(row, 6, n);
            System.arraycopy(row, a >= b && a >= c ? 0 : b >= c ? 3 : 6, out, 0, 3);
            return;
        }
        System.arraycopy(row, 0, out, 0, 3);
        for (int k = 0; k < 3; k++) {
            double half = alongAxis(row, k, n) < 0 ? -row[12 + k] : row[12 + k];
            for (int axis = 0; axis < 3; axis++) {
                out[axis] += half * row[3 + 3 * axis + k];
            }
        }
        double[] up = {row[4], row[7], row[10]};
        double square = product(up, up);
        double along = row[15] > 0 && square > 0 ? product(up, n) / square : 0;
        double[] aside = unit(new double[] {n[0] - along * up[0], n[1] - along * up[1], n[2] - along * up[2]});
        for (int axis = 0; axis < 3; axis++) {
            out[axis] += (row[15] + row[16]) * aside[axis];
        }
    }

    /** The sum of the magnitudes that go into {@link #most}, for a normal of magnitudes of at most 1. */
    static double size(double[] row) {
        double size = 0;
        for (int k = 0; k < (isTriangle(row) ? 9 : 3); k++) {
            size += Math.abs(row[k]);
        }
        for (int k = 12; k < row.length; k++) {
            size += 2 * row[k];
        }
        return size;
    }

    /** Least and greatest coordinates, rounded outward. */
    static void bounds(double[] row, double[] out, int at) {
        double pad = ROUNDING * size(row) + Double.MIN_NORMAL;
        double[] n = new double[3];
        for (int k = 0; k < 3; k++) {
            n[k] = -1;
            out[at + k] = -most(row, n) - pad;
            n[k] = 1;
            out[at + 3 + k] = most(row, n) + pad;
            n[k] = 0;
        }
    }

    /** Writes a piece as a leaf of the kernels. */
    static void leaf(double[] row, Leaf out) {
        double[] to = out.row;
        if (isTriangle(row)) {
            out.kind = LeafKind.TRIANGLE;
            System.arraycopy(row, 0, to, 0, 9);
            return;
        }
        boolean isUpright = row[4] == 0 && Math.abs(row[7]) == 1 && row[10] == 0;
        System.arraycopy(row, 0, to, 0, 3);
        System.arraycopy(row, 3, to, Leaf.ROTATION, 9);
        boolean isBox = row[15] == 0 && row[16] == 0;
        to[Leaf.SIZE] = isBox ? row[12] : row[15] + row[16];
        to[Leaf.SIZE + 1] = row[13];
        to[Leaf.SIZE + 2] = row[14];
        if (isBox) {
            out.kind = LeafKind.BOX;
        } else if (row[15] > 0) {
            out.kind = isUpright ? LeafKind.UPRIGHT_CYLINDER : LeafKind.CYLINDER;
        } else {
            out.kind = row[13] == 0 ? LeafKind.SPHERE : isUpright ? LeafKind.UPRIGHT_CAPSULE : LeafKind.CAPSULE;
        }
    }

    /** Corners as {@link Piece#corners}, in the same order. */
    static double[][] corners(double[] row) {
        if (isTriangle(row)) {
            return new double[][] {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, {row[6], row[7], row[8]}};
        }
        int count = 1;
        for (int k = 0; k < 3; k++) {
            count *= row[12 + k] == 0 ? 1 : 2;
        }
        double[][] all = new double[count][];
        for (int c = 0; c < count; c++) {
            double[] v = {row[0], row[1], row[2]};
            int bit = count;
            for (int k = 0; k < 3; k++) {
                if (row[12 + k] != 0) {
                    bit /= 2;
                    double share = (c & bit) == 0 ? -row[12 + k] : row[12 + k];
                    for (int axis = 0; axis < 3; axis++) {
                        v[axis] += share * row[3 + 3 * axis + k];
                    }
                }
            }
            all[c] = v;
        }
        return all;
    }

    /** A piece at height 0, for directions that are level. */
    static double[] level(double[] row) {
        double[] level = row.clone();
        for (int k = 1; k < (isTriangle(row) ? 9 : 3); k += 3) {
            level[k] = 0;
        }
        if (!isTriangle(row)) {
            level[6] = 0;
            level[7] = 0;
            level[8] = 0;
        }
        return level;
    }

    static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    static double product(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** The same of length 1, or zero. */
    static double[] unit(double[] v) {
        double largest = Math.max(Math.abs(v[0]), Math.max(Math.abs(v[1]), Math.abs(v[2])));
        if (!(largest > 0) || largest == Double.POSITIVE_INFINITY) {
            return new double[3];
        }
        double[] scaled = {v[0] / largest, v[1] / largest, v[2] / largest};
        double length = length(scaled);
        return new double[] {scaled[0] / length, scaled[1] / length, scaled[2] / length};
    }
}
