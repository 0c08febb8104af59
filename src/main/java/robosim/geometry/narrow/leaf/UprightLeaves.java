package robosim.geometry.narrow.leaf;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;

/** The heights of upright leaves: a flat base on an interval of Y. */
public final class UprightLeaves {
    // Rounding preserves the order of the two sums: only if the results are equal may either be the larger.
    private static final boolean IS_DOUBTING = FilterBound.isDoubting();
    private static final StageCounters.Counter EXACT = StageCounters.counter("UprightLeaves");

    private UprightLeaves() {}

    /** Whether the intervals of height of two upright leaves touch or overlap; exact. */
    public static boolean heightsTouch(Leaf a, Leaf b) {
        return isNotAbove(a, b) && isNotAbove(b, a);
    }

    // Whether the minimum height of a is at most the maximum of b.
    private static boolean isNotAbove(Leaf a, Leaf b) {
        double base = middle(a);
        double down = halfHeight(a);
        double top = top(b);
        double up = halfHeight(b);
        double apart = base - top;
        double halves = down + up;
        if (apart != halves && !IS_DOUBTING) {
            return apart < halves;
        }
        EXACT.count();
        return Dyadic.signOfSum(base, -top, -down, -up) <= 0;
    }

    /** Whether one leaf lies wholly above another, or on it: whether its minimum height is at least the other's maximum; exact. */
    public static boolean isOnOrAbove(Leaf a, Leaf b) {
        return Dyadic.signOfSum(middle(a), -top(b), -halfHeight(a), -halfHeight(b)) >= 0;
    }

    /** The height of the centre of a box or cylinder; for an octagon, which has no half height, the minimum height. */
    public static double middle(Leaf leaf) {
        return isRange(leaf.kind) ? leaf.get(8) : leaf.get(1);
    }

    /** The height of the centre of a box or cylinder; for an octagon the maximum height. */
    public static double top(Leaf leaf) {
        return isRange(leaf.kind) ? leaf.get(9) : leaf.get(1);
    }

    /** The half height of a box or cylinder; 0 for an octagon. */
    public static double halfHeight(Leaf leaf) {
        return isRange(leaf.kind) ? 0 : leaf.get(4);
    }

    private static boolean isRange(LeafKind kind) {
        return kind.layout() == LeafKind.Layout.RANGES;
    }
}
