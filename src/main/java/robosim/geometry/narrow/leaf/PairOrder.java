package robosim.geometry.narrow.leaf;

/**
 * A fixed order of the two leaves of a pair, by kind and then by numbers, so that (a, b) and (b, a) give the same bits.
 */
public final class PairOrder {
    private PairOrder() {}

    /** Whether a pair has to be swapped. */
    public static boolean isReversed(Leaf a, Leaf b) {
        if (a.kind != b.kind) {
            return a.kind.compareTo(b.kind) > 0;
        }
        int length = a.kind.numbers();
        for (int k = 0; k < length; k++) {
            double p = a.get(k);
            double q = b.get(k);
            if (p != q) {
                return p > q;
            }
        }
        return false;
    }
}
