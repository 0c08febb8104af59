package robosim.geometry.narrow.leaf;

import robosim.geometry.model.Dimension;

/** Axis-aligned bounds of leaves, rounded outward: no point of the leaf lies outside. */
public final class LeafBounds {
    // Six roundings of a sum of products of numbers that are not negative, and one for this product itself.
    private static final double OUTWARD = 1 + 0x1p-49;

    private LeafBounds() {}

    /** Writes least x, y, z and greatest x, y, z of a leaf of any kind. */
    public static void of(int kind, double[] rows, int at, double[] out6) {
        switch (kind) {
            case Leaf.UPRIGHT_BOX, Leaf.BOX -> box(rows, at, out6);
            case Leaf.UPRIGHT_CYLINDER -> around(rows, at, rows[at + 3], rows[at + 4], rows[at + 3], out6);
            case Leaf.SPHERE -> around(rows, at, rows[at + 3], rows[at + 3], rows[at + 3], out6);
            case Leaf.CYLINDER -> cylinder(rows, at, out6);
            case Leaf.TRIANGLE -> triangle(rows, at, out6);
            case Leaf.PRISM -> {
                out6[0] = rows[at];
                out6[1] = rows[at + 8];
                out6[2] = rows[at + 2];
                out6[3] = rows[at + 1];
                out6[4] = rows[at + 9];
                out6[5] = rows[at + 3];
            }
            default -> throw new IllegalArgumentException("kind must be one of Leaf (got: " + kind + ")");
        }
    }

    /**
     * Whether the bounds of two leaves are apart; in PLANAR ignoring heights.
     *
     * @param p six numbers, for the bounds of a
     * @param q six numbers, for those of b
     */
    public static boolean areApart(
            Dimension dimension, int kindA, double[] a, int i, int kindB, double[] b, int j, double[] p, double[] q) {
        of(kindA, a, i, p);
        of(kindB, b, j, q);
        for (int k = 0; k < 3; k += dimension == Dimension.PLANAR ? 2 : 1) {
            if (p[k] > q[3 + k] || q[k] > p[3 + k]) {
                return true;
            }
        }
        return false;
    }

    private static void around(double[] rows, int at, double halfX, double halfY, double halfZ, double[] out6) {
        out6[0] = 0 - Upright.sumUp(-rows[at], halfX);
        out6[1] = 0 - Upright.sumUp(-rows[at + 1], halfY);
        out6[2] = 0 - Upright.sumUp(-rows[at + 2], halfZ);
        out6[3] = Upright.sumUp(rows[at], halfX);
        out6[4] = Upright.sumUp(rows[at + 1], halfY);
        out6[5] = Upright.sumUp(rows[at + 2], halfZ);
    }

    private static void box(double[] rows, int at, double[] out6) {
        around(rows, at, boxHalf(rows, at, 0), boxHalf(rows, at, 3), boxHalf(rows, at, 6), out6);
    }

    // Half the extent along one world axis; exact if the leaf's own axes are the world's.
    private static double boxHalf(double[] rows, int at, int rowOfRotation) {
        int r = at + Leaf.ROTATION + rowOfRotation;
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum = Upright.sumUp(sum, productUp(rows[at + Leaf.SIZE + axis], Math.abs(rows[r + axis])));
        }
        return sum;
    }

    // Rounded up, of numbers that are not negative.
    private static double productUp(double a, double b) {
        double product = a * b;
        if (a == 0 || b == 0 || a == 1 || b == 1) {
            return product;
        }
        // Below this the rounding error of the product may itself be rounded.
        return Upright.up(product, product < 0x1p-960 ? 1 : Math.fma(a, b, -product));
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
                cylinderHalf(radius, half, ax, ay, az, length),
                cylinderHalf(radius, half, ay, az, ax, length),
                cylinderHalf(radius, half, az, ax, ay, length),
                out6);
    }

    private static double cylinderHalf(double radius, double half, double along, double p, double q, double length) {
        double rim = radius * (Math.sqrt(p * p + q * q) / length);
        double sum = (half * Math.abs(along) + rim) * OUTWARD;
        return sum == 0 ? (radius == 0 && half == 0 ? 0 : Double.MIN_VALUE) : Math.nextUp(sum);
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
