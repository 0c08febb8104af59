package robosim.geometry.narrow.leaf;

/**
 * A fixed order of the two leaves of a pair, by kind and then by numbers, so that (a, b) and (b, a) give the same bits.
 */
public final class Order {
    /** The number of relevant numbers in a row, by kind. */
    private static final int[] LENGTHS = {15, 5, 4, 15, 15, 9, 10};

    private Order() {}

    /** Whether a pair has to be swapped. */
    public static boolean isReversed(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        if (kindA != kindB) {
            return kindA > kindB;
        }
        int length = LENGTHS[kindA];
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
