package robosim.geometry.narrow.overlap;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;

/** The range of heights of a leaf, if its top and bottom are sums of two doubles: exact, without allocation. */
public final class HeightIntervals {
    private HeightIntervals() {}

    /** The first term of the top (side 1) or the bottom (side -1) of a leaf. */
    public static double middle(Leaf leaf, int side) {
        return switch (leaf.kind) {
            case TRIANGLE ->
                side > 0
                        ? Math.max(Math.max(leaf.get(1), leaf.get(4)), leaf.get(7))
                        : Math.min(Math.min(leaf.get(1), leaf.get(4)), leaf.get(7));
            case PRISM -> side > 0 ? leaf.get(9) : leaf.get(8);
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, SPHERE -> leaf.get(1);
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    /** The second term of the top, and negated that of the bottom. */
    public static double half(Leaf leaf) {
        return switch (leaf.kind) {
            case TRIANGLE, PRISM -> 0;
            case SPHERE -> leaf.get(3);
            case UPRIGHT_BOX, UPRIGHT_CYLINDER -> leaf.get(4);
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    /** Whether all of a is at or above the top of b. */
    static boolean isAbove(Leaf a, Leaf b) {
        return isBeyond(a, middle(b, 1), half(b), 1);
    }

    /**
     * 1 if all of a is at or above the top of b, -1 if at or below its bottom, 0 if neither or if it cannot be decided
     * here.
     */
    public static int side(Leaf a, Leaf b) {
        if (!a.kind.hasLevels() || !b.kind.hasLevels()) {
            return 0;
        }
        return isAbove(a, b) ? 1 : isAbove(b, a) ? -1 : 0;
    }

    /** Whether all of a leaf is at or above (side 1) or at or below (side -1) a height that is a sum of two doubles. */
    public static boolean isBeyond(Leaf leaf, double middle, double half, int side) {
        double mine = middle(leaf, -side);
        return side * Dyadic.signOfSum(mine, -side * half(leaf), -middle, -half) >= 0;
    }

    /** Whether the top and the bottom have the same projection as the whole leaf. */
    static boolean isFlat(Leaf leaf) {
        return switch (leaf.kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, PRISM -> true;
            case SPHERE -> false;
            case TRIANGLE -> leaf.get(1) == leaf.get(4) && leaf.get(4) == leaf.get(7);
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        };
    }

    /**
     * Writes what a leaf has in its top (side 1) or bottom (side -1), to be seen from above: of a triangle the corners that
     * are there, of a sphere its centre.
     */
    public static void part(Leaf leaf, int side, Leaf to) {
        to.copy(leaf.kind, leaf.row, leaf.at);
        double[] out = to.row;
        switch (leaf.kind) {
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, PRISM -> {}
            case SPHERE -> out[Leaf.SIZE] = 0;
            case TRIANGLE -> {
                double level = middle(leaf, side);
                int there = leaf.get(1) == level ? 0 : leaf.get(4) == level ? 3 : 6;
                for (int k = 0; k < 9; k += 3) {
                    if (leaf.get(k + 1) != level) {
                        System.arraycopy(leaf.row, leaf.at + there, out, k, 3);
                    }
                }
            }
            case BOX, CYLINDER, UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw leaf.kind.refused();
        }
    }

    /**
     * Whether leaf a stays above or below b while it moves by dy in height.
     */
    public static boolean parts(Leaf a, double dy, Leaf b, OverlapScratch s) {
        if (!a.kind.hasLevels() || !b.kind.hasLevels()) {
            return false;
        }
        int above = dy >= 0 ? sign(a, b) : -1;
        int below = above <= 0 && dy <= 0 ? sign(b, a) : -1;
        if (above > 0 || below > 0) {
            return true;
        }
        return (above == 0 || below == 0) && isFlat(a) && isFlat(b) && PlanarOverlap.test(a, b, s);
    }

    /** The sign of the gap from the top of b up to the bottom of a. */
    private static int sign(Leaf a, Leaf b) {
        return Dyadic.signOfSum(middle(a, -1), -half(a), -middle(b, 1), -half(b));
    }

    /** Whether two leaves touch, if heights and projections decide it: 1 if they do, -1 if not, 0 if undecided. */
    public static int touch(Leaf a, Leaf b, OverlapScratch s) {
        if (!a.kind.hasLevels() || !b.kind.hasLevels()) {
            return 0;
        }
        if (sign(a, b) > 0 || sign(b, a) > 0) {
            return -1;
        }
        return isFlat(a) && isFlat(b) ? PlanarOverlap.test(a, b, s) ? 1 : -1 : 0;
    }
}
