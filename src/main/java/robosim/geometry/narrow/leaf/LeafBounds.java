package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.UpwardRounding;
import robosim.geometry.model.Dimension;

/** Axis-aligned bounds of leaves, rounded outward: no point of the leaf lies outside. */
public final class LeafBounds {
    private LeafBounds() {}

    /** Writes least x, y, z and greatest x, y, z of a leaf of any kind. */
    public static void of(LeafKind kind, double[] rows, int at, double[] out6) {
        switch (kind) {
            case UPRIGHT_BOX, BOX -> box(rows, at, out6);
            case UPRIGHT_CYLINDER -> around(rows, at, rows[at + 3], rows[at + 4], rows[at + 3], out6);
            case SPHERE -> around(rows, at, rows[at + 3], rows[at + 3], rows[at + 3], out6);
            case CYLINDER -> cylinder(rows, at, out6);
            case UPRIGHT_CAPSULE ->
                around(rows, at, rows[at + 3], UpwardRounding.sum(rows[at + 4], rows[at + 3]), rows[at + 3], out6);
            case CAPSULE -> capsule(rows, at, out6);
            case TRIANGLE -> triangle(rows, at, out6);
            case PRISM -> {
                out6[0] = rows[at];
                out6[1] = rows[at + 8];
                out6[2] = rows[at + 2];
                out6[3] = rows[at + 1];
                out6[4] = rows[at + 9];
                out6[5] = rows[at + 3];
            }
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    /**
     * Whether the bounds of two leaves are apart; in PLANAR ignoring heights.
     *
     * @param p six numbers, for the bounds of a
     * @param q six numbers, for those of b
     */
    public static boolean areApart(Dimension dimension, Leaf a, Leaf b, double[] p, double[] q) {
        of(a.kind, a.row, a.at, p);
        of(b.kind, b.row, b.at, q);
        for (int k = 0; k < 3; k += dimension == Dimension.PLANAR ? 2 : 1) {
            if (p[k] > q[3 + k] || q[k] > p[3 + k]) {
                return true;
            }
        }
        return false;
    }

    private static void around(double[] rows, int at, double halfX, double halfY, double halfZ, double[] out6) {
        out6[0] = 0 - UpwardRounding.sum(-rows[at], halfX);
        out6[1] = 0 - UpwardRounding.sum(-rows[at + 1], halfY);
        out6[2] = 0 - UpwardRounding.sum(-rows[at + 2], halfZ);
        out6[3] = UpwardRounding.sum(rows[at], halfX);
        out6[4] = UpwardRounding.sum(rows[at + 1], halfY);
        out6[5] = UpwardRounding.sum(rows[at + 2], halfZ);
    }

    private static void box(double[] rows, int at, double[] out6) {
        int r = at + Leaf.ROTATION;
        if (isAlongAxes(rows, r)) {
            around(rows, at, rows[at + 3], rows[at + 4], rows[at + 5], out6);
            return;
        }
        around(
                rows,
                at,
                UpwardRounding.ofBox(rows, at + Leaf.SIZE, rows, r),
                UpwardRounding.ofBox(rows, at + Leaf.SIZE, rows, r + 3),
                UpwardRounding.ofBox(rows, at + Leaf.SIZE, rows, r + 6),
                out6);
    }

    /** Whether a rotation is none, so that products with it are exact. */
    private static boolean isAlongAxes(double[] rows, int r) {
        return rows[r] == 1
                && rows[r + 4] == 1
                && rows[r + 8] == 1
                && rows[r + 2] == 0
                && rows[r + 6] == 0
                && rows[r + 1] == 0
                && rows[r + 3] == 0
                && rows[r + 5] == 0
                && rows[r + 7] == 0;
    }

    private static void capsule(double[] rows, int at, double[] out6) {
        double radius = rows[at + 3];
        double half = rows[at + 4];
        around(
                rows,
                at,
                UpwardRounding.ofCapsule(radius, half, rows[at + 7]),
                UpwardRounding.ofCapsule(radius, half, rows[at + 10]),
                UpwardRounding.ofCapsule(radius, half, rows[at + 13]),
                out6);
    }

    private static void cylinder(double[] rows, int at, double[] out6) {
        double ax = rows[at + 7];
        double ay = rows[at + 10];
        double az = rows[at + 13];
        double radius = rows[at + 3];
        double half = rows[at + 4];
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        around(
                rows,
                at,
                UpwardRounding.ofCylinder(radius, half, ax, ay, az, length),
                UpwardRounding.ofCylinder(radius, half, ay, az, ax, length),
                UpwardRounding.ofCylinder(radius, half, az, ax, ay, length),
                out6);
    }

    private static void triangle(double[] rows, int at, double[] out6) {
        for (int axis = 0; axis < 3; axis++) {
            double a = rows[at + axis];
            double b = rows[at + 3 + axis];
            double c = rows[at + 6 + axis];
            out6[axis] = Math.min(a, Math.min(b, c));
            out6[3 + axis] = Math.max(a, Math.max(b, c));
        }
    }
}
