package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** The range of heights of a leaf, if its top and bottom are sums of two doubles: exact, without allocation. */
public final class HeightIntervals {
    private HeightIntervals() {}

    /** The first term of the top (side 1) or the bottom (side -1) of a leaf. */
    public static double middle(LeafKind kind, double[] row, int at, int side) {
        return switch (kind) {
            case TRIANGLE ->
                side > 0
                        ? Math.max(Math.max(row[at + 1], row[at + 4]), row[at + 7])
                        : Math.min(Math.min(row[at + 1], row[at + 4]), row[at + 7]);
            case PRISM -> side > 0 ? row[at + 9] : row[at + 8];
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE -> row[at + 1];
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** The second term of the top, and negated that of the bottom. */
    public static double half(LeafKind kind, double[] row, int at) {
        return switch (kind) {
            case TRIANGLE, PRISM -> 0;
            case SPHERE -> row[at + 3];
            case UPRIGHT_BOX, UPRIGHT_CYLINDER -> row[at + 4];
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /** Whether all of a is at or above the top of b. */
    static boolean isAbove(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        return isBeyond(kindA, a, i, middle(kindB, b, j, 1), half(kindB, b, j), 1);
    }

    /**
     * 1 if all of a is at or above the top of b, -1 if at or below its bottom, 0 if neither or if it cannot be decided
     * here.
     */
    public static int side(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        if (!kindA.hasLevels() || !kindB.hasLevels()) {
            return 0;
        }
        return isAbove(kindA, a, i, kindB, b, j) ? 1 : isAbove(kindB, b, j, kindA, a, i) ? -1 : 0;
    }

    /** Whether all of a leaf is at or above (side 1) or at or below (side -1) a height that is a sum of two doubles. */
    public static boolean isBeyond(LeafKind kind, double[] row, int at, double middle, double half, int side) {
        double mine = middle(kind, row, at, -side);
        return side * Dyadic.signOfSum(mine, -side * half(kind, row, at), -middle, -half) >= 0;
    }

    /** Whether the top and the bottom have the same projection as the whole leaf. */
    static boolean isFlat(LeafKind kind, double[] row, int at) {
        return switch (kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, PRISM -> true;
            case SPHERE -> false;
            case TRIANGLE -> row[at + 1] == row[at + 4] && row[at + 4] == row[at + 7];
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    /**
     * Writes what a leaf has in its top (side 1) or bottom (side -1), to be seen from above: of a triangle the corners that
     * are there, of a sphere its centre.
     */
    public static void part(LeafKind kind, double[] row, int at, int side, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        switch (kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, PRISM -> {}
            case SPHERE -> out[Leaf.SIZE] = 0;
            case TRIANGLE -> {
                double level = middle(kind, row, at, side);
                int there = row[at + 1] == level ? 0 : row[at + 4] == level ? 3 : 6;
                for (int k = 0; k < 9; k += 3) {
                    if (row[at + k + 1] != level) {
                        System.arraycopy(row, at + there, out, k, 3);
                    }
                }
            }
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    /**
     * Whether leaf a stays above or below b while it moves by dy in height.
     */
    public static boolean parts(
            LeafKind kindA, double[] a, int i, double dy, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (!kindA.hasLevels() || !kindB.hasLevels()) {
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
    private static int sign(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        return Dyadic.signOfSum(
                middle(kindA, a, i, -1), -half(kindA, a, i), -middle(kindB, b, j, 1), -half(kindB, b, j));
    }

    /** Whether two leaves touch, if heights and projections decide it: 1 if they do, -1 if not, 0 if undecided. */
    public static int touch(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j, OverlapScratch s) {
        if (!kindA.hasLevels() || !kindB.hasLevels()) {
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
