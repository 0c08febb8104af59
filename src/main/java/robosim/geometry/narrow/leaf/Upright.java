package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.Stages;

/** The heights of upright leaves: a flat base on an interval of Y. */
public final class Upright {
    // Rounding preserves the order of the two sums: only if the results are equal may either be the larger.
    private static final boolean IS_DOUBTING = Filter.isDoubting();
    private static final Stages.Counter EXACT = Stages.counter("Upright");

    private Upright() {}

    /** Whether the intervals of height of two upright leaves touch or overlap; exact. */
    public static boolean heightsTouch(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        return isNotAbove(kindA, a, i, kindB, b, j) && isNotAbove(kindB, b, j, kindA, a, i);
    }

    // Whether the minimum height of a is at most the maximum of b.
    private static boolean isNotAbove(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        double base = middle(kindA, a, i);
        double down = halfHeight(kindA, a, i);
        double top = top(kindB, b, j);
        double up = halfHeight(kindB, b, j);
        double apart = base - top;
        double halves = down + up;
        if (apart != halves && !IS_DOUBTING) {
            return apart < halves;
        }
        EXACT.count();
        return Dyadic.signOfSum(base, -top, -down, -up) <= 0;
    }

    /** The height of the centre of a box or cylinder; for an octagon, which has no half height, the minimum height. */
    public static double middle(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 8] : row[at + 1];
    }

    /** The height of the centre of a box or cylinder; for an octagon the maximum height. */
    public static double top(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 9] : row[at + 1];
    }

    /** The half height of a box or cylinder; 0 for an octagon. */
    public static double halfHeight(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? 0 : row[at + 4];
    }

    /** The minimum height of an upright leaf, rounded down. */
    public static double least(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 8] : 0 - sumUp(-row[at + 1], row[at + 4]);
    }

    /** The maximum height of an upright leaf, rounded up. */
    public static double greatest(int kind, double[] row, int at) {
        return kind == Leaf.PRISM ? row[at + 9] : sumUp(row[at + 1], row[at + 4]);
    }

    /** {@code a + b}, rounded up. */
    public static double sumUp(double a, double b) {
        double sum = a + b;
        return up(sum, DoubleDouble.sumTail(a, b, sum));
    }

    /**
     * The next double above a number if its tail is above 0; without a branch, which would be mispredicted half of the
     * time.
     */
    static double up(double number, double tail) {
        long isUp = Double.doubleToLongBits(0.0 - tail) >> (Long.SIZE - 1);
        long from = Double.doubleToRawLongBits(number + 0.0);
        long next = from + ((from >> (Long.SIZE - 1)) | 1);
        return Double.longBitsToDouble((Double.doubleToRawLongBits(number) & ~isUp) | (next & isUp));
    }
}
