package robosim.geometry.narrow;

import robosim.geometry.exact.Dyadic;

/** Where a leaf begins and ends in height, if both are sums of two doubles: exact, and nothing is allocated. */
final class Levels {
    private Levels() {}

    /** Whether heights are sums of two. */
    static boolean has(int kind) {
        return kind != Leaf.BOX && kind != Leaf.CYLINDER;
    }

    /** The first term of the top (side 1) or the bottom (side -1) of a leaf. */
    static double middle(int kind, double[] row, int at, int side) {
        return switch (kind) {
            case Leaf.TRIANGLE ->
                side > 0
                        ? Math.max(Math.max(row[at + 1], row[at + 4]), row[at + 7])
                        : Math.min(Math.min(row[at + 1], row[at + 4]), row[at + 7]);
            case Leaf.PRISM -> side > 0 ? row[at + 9] : row[at + 8];
            default -> row[at + 1];
        };
    }

    /** The second term of the top; less it, that of the bottom. */
    static double half(int kind, double[] row, int at) {
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

    /** 1 where all of a is at or above the top of b, -1 at or below its bottom, 0 where neither is or may be told here. */
    static int side(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (!has(kindA) || !has(kindB)) {
            return 0;
        }
        return isAbove(kindA, a, i, kindB, b, j) ? 1 : isAbove(kindB, b, j, kindA, a, i) ? -1 : 0;
    }

    /** Whether all of a leaf is at or above (side 1), at or below (side -1) a level that is a sum of two. */
    static boolean isBeyond(int kind, double[] row, int at, double middle, double half, int side) {
        double mine = middle(kind, row, at, -side);
        return side * Dyadic.signOfSum(mine, -side * half(kind, row, at), -middle, -half) >= 0;
    }

    /** Whether the top and the bottom are as wide as the leaf as seen from above. */
    static boolean isFlat(int kind, double[] row, int at) {
        return kind != Leaf.TRIANGLE || (row[at + 1] == row[at + 4] && row[at + 4] == row[at + 7]);
    }
}
