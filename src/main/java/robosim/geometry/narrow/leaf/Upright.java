package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.StageCounters;

/** The heights of upright leaves: a flat base on an interval of Y. */
public final class Upright {
    // Rounding preserves the order of the two sums: only if the results are equal may either be the larger.
    private static final boolean IS_DOUBTING = Filter.isDoubting();
    private static final StageCounters.Counter EXACT = StageCounters.counter("Upright");

    private Upright() {}

    /** Whether the intervals of height of two upright leaves touch or overlap; exact. */
    public static boolean heightsTouch(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        return isNotAbove(kindA, a, i, kindB, b, j) && isNotAbove(kindB, b, j, kindA, a, i);
    }

    // Whether the minimum height of a is at most the maximum of b.
    private static boolean isNotAbove(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
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
    public static double middle(LeafKind kind, double[] row, int at) {
        return isRange(kind) ? row[at + 8] : row[at + 1];
    }

    /** The height of the centre of a box or cylinder; for an octagon the maximum height. */
    public static double top(LeafKind kind, double[] row, int at) {
        return isRange(kind) ? row[at + 9] : row[at + 1];
    }

    /** The half height of a box or cylinder; 0 for an octagon. */
    public static double halfHeight(LeafKind kind, double[] row, int at) {
        return isRange(kind) ? 0 : row[at + 4];
    }

    private static boolean isRange(LeafKind kind) {
        return kind.layout() == LeafKind.Layout.RANGES;
    }
}
