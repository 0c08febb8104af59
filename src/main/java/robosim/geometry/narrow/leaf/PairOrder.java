package robosim.geometry.narrow.leaf;

/**
 * A fixed order of the two leaves of a pair, by kind and then by numbers, so that (a, b) and (b, a) give the same bits.
 */
public final class PairOrder {
    private PairOrder() {}

    /** Whether a pair has to be swapped. */
    public static boolean isReversed(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        if (kindA != kindB) {
            return kindA.compareTo(kindB) > 0;
        }
        int length = kindA.numbers();
        for (int k = 0; k < length; k++) {
            double p = a[i + k];
            double q = b[j + k];
            if (p != q) {
                return p > q;
            }
        }
        return false;
    }
}
