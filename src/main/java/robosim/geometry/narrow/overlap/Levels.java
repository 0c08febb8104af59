package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;

/** The range of heights of a leaf, if its top and bottom are sums of two doubles: exact, without allocation. */
public final class Levels {
    private Levels() {}

    /** Whether the heights of a kind are sums of two doubles. */
    public static boolean has(int kind) {
        return kind != Leaf.BOX && kind != Leaf.CYLINDER;
    }

    /** The first term of the top (side 1) or the bottom (side -1) of a leaf. */
    public static double middle(int kind, double[] row, int at, int side) {
        return switch (kind) {
            case Leaf.TRIANGLE ->
                side > 0
                        ? Math.max(Math.max(row[at + 1], row[at + 4]), row[at + 7])
                        : Math.min(Math.min(row[at + 1], row[at + 4]), row[at + 7]);
            case Leaf.PRISM -> side > 0 ? row[at + 9] : row[at + 8];
            default -> row[at + 1];
        };
    }

    /** The second term of the top, and negated that of the bottom. */
    public static double half(int kind, double[] row, int at) {
        return switch (kind) {
            case Leaf.TRIANGLE, Leaf.PRISM -> 0;
            case Leaf.SPHERE -> row[at + 3];
            default -> row[at + 4];
        };
    }

    /** Whether all of a is at or above the top of b. */
    static boolean isAbove(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        return isBeyond(kindA, a, i, middle(kindB, b, j, 1), half(kindB, b, j), 1);
    }

    /**
     * 1 if all of a is at or above the top of b, -1 if at or below its bottom, 0 if neither or if it cannot be decided
     * here.
     */
    public static int side(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (!has(kindA) || !has(kindB)) {
            return 0;
        }
        return isAbove(kindA, a, i, kindB, b, j) ? 1 : isAbove(kindB, b, j, kindA, a, i) ? -1 : 0;
    }

    /** Whether all of a leaf is at or above (side 1) or at or below (side -1) a height that is a sum of two doubles. */
    public static boolean isBeyond(int kind, double[] row, int at, double middle, double half, int side) {
        double mine = middle(kind, row, at, -side);
        return side * Dyadic.signOfSum(mine, -side * half(kind, row, at), -middle, -half) >= 0;
    }

    /** Whether the top and the bottom have the same projection as the whole leaf. */
    static boolean isFlat(int kind, double[] row, int at) {
        return kind == Leaf.TRIANGLE ? row[at + 1] == row[at + 4] && row[at + 4] == row[at + 7] : kind != Leaf.SPHERE;
    }

    /**
     * Writes the part of a leaf at its top (side 1) or bottom (side -1), for use in the plane: of a triangle the
     * corners there, of a sphere its centre; returns the kind of that part.
     */
    public static int part(int kind, double[] row, int at, int side, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        if (kind == Leaf.SPHERE) {
            out[Leaf.SIZE] = 0;
        } else if (kind == Leaf.TRIANGLE) {
            double level = middle(kind, row, at, side);
            int there = row[at + 1] == level ? 0 : row[at + 4] == level ? 3 : 6;
            for (int k = 0; k < 9; k += 3) {
                if (row[at + k + 1] != level) {
                    System.arraycopy(row, at + there, out, k, 3);
                }
            }
        }
        return kind;
    }

    /**
     * Whether leaf a stays above or below b while it moves by dy in height.
     */
    public static boolean parts(
            int kindA, double[] a, int i, double dy, int kindB, double[] b, int j, OverlapScratch s) {
        if (!has(kindA) || !has(kindB)) {
            return false;
        }
        int above = dy >= 0 ? sign(kindA, a, i, kindB, b, j) : -1;
        int below = above <= 0 && dy <= 0 ? sign(kindB, b, j, kindA, a, i) : -1;
        if (above > 0 || below > 0) {
            return true;
        }
        return (above == 0 || below == 0)
                && isFlat(kindA, a, i)
                && isFlat(kindB, b, j)
                && PlanarOverlap.test(kindA, a, i, kindB, b, j, s);
    }

    /** The sign of the gap from the top of b up to the bottom of a. */
    private static int sign(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        return Dyadic.signOfSum(
                middle(kindA, a, i, -1), -half(kindA, a, i), -middle(kindB, b, j, 1), -half(kindB, b, j));
    }

    /** Whether two leaves touch, if heights and projections decide it: 1 if they do, -1 if not, 0 if undecided. */
    public static int touch(int kindA, double[] a, int i, int kindB, double[] b, int j, OverlapScratch s) {
        if (!has(kindA) || !has(kindB)) {
            return 0;
        }
        if (sign(kindA, a, i, kindB, b, j) > 0 || sign(kindB, b, j, kindA, a, i) > 0) {
            return -1;
        }
        return isFlat(kindA, a, i) && isFlat(kindB, b, j)
                ? PlanarOverlap.test(kindA, a, i, kindB, b, j, s) ? 1 : -1
                : 0;
    }
}
