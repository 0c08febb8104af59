package robosim.geometry.bench;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** What the numbers of a leaf's row mean: which of them are lengths, how it is moved, and its farthest point. */
final class LeafRows {
    private LeafRows() {}

    /** How many of a row's first numbers are lengths. */
    static int places(LeafKind kind) {
        return kind == LeafKind.TRIANGLE ? 9 : kind == LeafKind.PRISM ? 10 : 6;
    }

    /**
     * Moves a leaf.
     *
     * @param sign what the way is multiplied by
     */
    static void shift(LeafKind kind, double[] row, double sign, double[] by) {
        double x = sign * by[0];
        double y = sign * by[1];
        double z = sign * by[2];
        if (kind == LeafKind.PRISM) {
            double[] offsets = {x, x, z, z, x + z, x + z, x - z, x - z, y, y};
            for (int k = 0; k < 10; k++) {
                row[k] += offsets[k];
            }
            return;
        }
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k += 3) {
            row[k] += x;
            row[k + 1] += y;
            row[k + 2] += z;
        }
    }

    static void set(double[] v, double x, double y, double z) {
        v[0] = x;
        v[1] = y;
        v[2] = z;
    }

    static void cross(double[] u, double[] v, double[] out) {
        set(out, u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    }

    /** The point of a leaf that is farthest along a direction, to rounding. */
    static void support(LeafKind kind, double[] row, double[] n, double[] out) {
        switch (kind) {
            case TRIANGLE -> {
                int best = 0;
                for (int k = 3; k < 9; k += 3) {
                    best = along(row, k, n) > along(row, best, n) ? k : best;
                }
                System.arraycopy(row, best, out, 0, 3);
            }
            case PRISM -> {
                double x = row[n[0] > 0 ? 1 : 0];
                double z = n[0] > 0 ? (n[2] > 0 ? row[5] - x : x - row[7]) : n[2] > 0 ? x - row[6] : row[4] - x;
                set(out, x, row[n[1] > 0 ? 9 : 8], z);
            }
            case UPRIGHT_BOX, BOX -> {
                System.arraycopy(row, 0, out, 0, 3);
                for (int k = 0; k < 3; k++) {
                    int r = Leaf.ROTATION + k;
                    double side = n[0] * row[r] + n[1] * row[r + 3] + n[2] * row[r + 6] > 0 ? row[3 + k] : -row[3 + k];
                    for (int m = 0; m < 3; m++) {
                        out[m] += side * row[r + 3 * m];
                    }
                }
            }
            case SPHERE -> round(row, 0, 0, 0, n, out);
            case UPRIGHT_CYLINDER -> round(row, 0, 1, 0, n, out);
            default -> round(row, row[7], row[10], row[13], n, out);
        }
    }

    private static double along(double[] row, int at, double[] n) {
        return row[at] * n[0] + row[at + 1] * n[1] + row[at + 2] * n[2];
    }

    private static void round(double[] row, double ax, double ay, double az, double[] n, double[] out) {
        double axial = n[0] * ax + n[1] * ay + n[2] * az;
        double x = n[0] - axial * ax;
        double y = n[1] - axial * ay;
        double z = n[2] - axial * az;
        double size = Math.sqrt(x * x + y * y + z * z);
        double share = size > 1e-9 ? row[3] / size : 0;
        double up = axial > 0 ? row[4] : -row[4];
        set(out, row[0] + up * ax + share * x, row[1] + up * ay + share * y, row[2] + up * az + share * z);
    }
}
