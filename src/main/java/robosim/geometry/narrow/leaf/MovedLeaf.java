package robosim.geometry.narrow.leaf;

/** A leaf at a later place of its motion, to within rounding: for choosing an axis, not for proofs. */
public final class MovedLeaf {
    private MovedLeaf() {}

    /** Writes it after a translation; the kind stays. */
    public static void moved(Leaf leaf, double dx, double dy, double dz, Leaf to) {
        to.copy(leaf.kind, leaf.row, leaf.at);
        double[] out = to.row;
        switch (leaf.kind.layout()) {
            case CENTRE -> shift(out, 3, dx, dy, dz);
            case CORNERS -> shift(out, 9, dx, dy, dz);
            case RANGES -> {
                for (int k = 0; k < 2; k++) {
                    out[k] += dx;
                    out[k + 2] += dz;
                    out[k + 4] += dx + dz;
                    out[k + 6] += dx - dz;
                    out[k + 8] += dy;
                }
            }
        }
    }

    private static void shift(double[] out, int numbers, double dx, double dy, double dz) {
        for (int k = 0; k < numbers; k += 3) {
            out[k] += dx;
            out[k + 1] += dy;
            out[k + 2] += dz;
        }
    }

    /** The kind of a leaf that has been turned about any axis. */
    public static LeafKind turnedKind(LeafKind kind) {
        return switch (kind) {
            case UPRIGHT_BOX -> LeafKind.BOX;
            case UPRIGHT_CYLINDER -> LeafKind.CYLINDER;
            case UPRIGHT_CAPSULE -> LeafKind.CAPSULE;
            case SPHERE, BOX, CYLINDER, TRIANGLE, PRISM, CAPSULE, MESH, SOLID_MESH, GRID -> kind;
        };
    }

    /** Writes it after a turn by the angle of a cosine and sine, for any convex kind but a prism. */
    public static void turned(Leaf leaf, PivotTurn turn, double cos, double sin, Leaf to) {
        to.copy(turnedKind(leaf.kind), leaf.row, leaf.at);
        double[] out = to.row;
        switch (leaf.kind) {
            case UPRIGHT_BOX, BOX, CYLINDER, CAPSULE -> {
                turnPoints(out, 3, turn, cos, sin);
                turnAxes(out, turn, cos, sin);
            }
            case UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> {
                out[7] = 0;
                out[10] = 1;
                out[13] = 0;
                turnPoints(out, 3, turn, cos, sin);
                turnAxes(out, turn, cos, sin);
            }
            case SPHERE -> turnPoints(out, 3, turn, cos, sin);
            case TRIANGLE -> turnPoints(out, 9, turn, cos, sin);
            case PRISM, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
    }

    private static void turnPoints(double[] out, int numbers, PivotTurn turn, double cos, double sin) {
        for (int k = 0; k < numbers; k += 3) {
            out[k] -= turn.px;
            out[k + 1] -= turn.py;
            out[k + 2] -= turn.pz;
            turn(out, k, 1, turn, cos, sin);
            out[k] += turn.px;
            out[k + 1] += turn.py;
            out[k + 2] += turn.pz;
        }
    }

    private static void turnAxes(double[] out, PivotTurn turn, double cos, double sin) {
        for (int k = 0; k < 3; k++) {
            turn(out, Leaf.ROTATION + k, 3, turn, cos, sin);
        }
    }

    // Rodrigues: v cos + (w x v) sin + w (w.v)(1 - cos)
    private static void turn(double[] v, int at, int step, PivotTurn turn, double cos, double sin) {
        double wx = turn.wx;
        double wy = turn.wy;
        double wz = turn.wz;
        double x = v[at];
        double y = v[at + step];
        double z = v[at + 2 * step];
        double along = (wx * x + wy * y + wz * z) * (1 - cos);
        v[at] = x * cos + (wy * z - wz * y) * sin + wx * along;
        v[at + step] = y * cos + (wz * x - wx * z) * sin + wy * along;
        v[at + 2 * step] = z * cos + (wx * y - wy * x) * sin + wz * along;
    }
}
