package robosim.geometry.narrow.leaf;

/** The row of a leaf at a later place of its motion, to within rounding: for choosing an axis, not for proofs. */
public final class Poses {
    private Poses() {}

    /** The row after a translation; the kind stays. */
    public static void moved(int kind, double[] row, int at, double dx, double dy, double dz, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        if (kind == Leaf.PRISM) {
            for (int k = 0; k < 2; k++) {
                out[k] += dx;
                out[k + 2] += dz;
                out[k + 4] += dx + dz;
                out[k + 6] += dx - dz;
                out[k + 8] += dy;
            }
            return;
        }
        for (int k = 0; k < (kind == Leaf.TRIANGLE ? 9 : 3); k += 3) {
            out[k] += dx;
            out[k + 1] += dy;
            out[k + 2] += dz;
        }
    }

    /** The kind of a leaf that has been turned about any axis. */
    public static int turnedKind(int kind) {
        return switch (kind) {
            case Leaf.UPRIGHT_BOX, Leaf.PRISM -> Leaf.BOX;
            case Leaf.UPRIGHT_CYLINDER -> Leaf.CYLINDER;
            default -> kind;
        };
    }

    /** The row after a turn about the axis (wx, wy, wz) through (px, py, pz), for any kind but a prism. */
    public static void turned(
            int kind,
            double[] row,
            int at,
            double px,
            double py,
            double pz,
            double wx,
            double wy,
            double wz,
            double cos,
            double sin,
            double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        if (kind == Leaf.UPRIGHT_CYLINDER) {
            out[7] = 0;
            out[10] = 1;
            out[13] = 0;
        }
        for (int k = 0; k < (kind == Leaf.TRIANGLE ? 9 : 3); k += 3) {
            out[k] -= px;
            out[k + 1] -= py;
            out[k + 2] -= pz;
            turn(out, k, 1, wx, wy, wz, cos, sin);
            out[k] += px;
            out[k + 1] += py;
            out[k + 2] += pz;
        }
        if (kind != Leaf.TRIANGLE && kind != Leaf.SPHERE) {
            for (int k = 0; k < 3; k++) {
                turn(out, Leaf.ROTATION + k, 3, wx, wy, wz, cos, sin);
            }
        }
    }

    // Rodrigues: v cos + (w x v) sin + w (w.v)(1 - cos)
    private static void turn(double[] v, int at, int step, double wx, double wy, double wz, double cos, double sin) {
        double x = v[at];
        double y = v[at + step];
        double z = v[at + 2 * step];
        double along = (wx * x + wy * y + wz * z) * (1 - cos);
        v[at] = x * cos + (wy * z - wz * y) * sin + wx * along;
        v[at + step] = y * cos + (wz * x - wx * z) * sin + wy * along;
        v[at + 2 * step] = z * cos + (wx * y - wy * x) * sin + wz * along;
    }
}
