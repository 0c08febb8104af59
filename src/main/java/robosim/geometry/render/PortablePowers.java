package robosim.geometry.render;

/** PortablePowers by multiplications and square roots alone, which are the same bits on every JVM. */
final class PortablePowers {
    /** Bits of the exponent behind the point; the rest makes less than a part in a million. */
    private static final int BITS = 20;

    /** What is smaller lights nothing, and its powers would only become slow. */
    private static final double NOTHING = 0x1p-60;

    private PortablePowers() {}

    /**
     * A power of a share.
     *
     * @param base     from 0 to 1
     * @param exponent at least 0; taken to 20 bits behind the point
     */
    static double of(double base, double exponent) {
        if (!(base > 0)) {
            return exponent > 0 ? 0 : 1;
        }
        int whole = (int) exponent;
        double result = 1;
        double square = base;
        for (int left = whole; left > 0; left >>= 1) {
            if ((left & 1) == 1) {
                result *= square;
            }
            square *= square;
            if (result < NOTHING || (square < NOTHING && left > 1)) {
                return 0;
            }
        }
        double rest = exponent - whole;
        double root = base;
        for (int bit = 0; bit < BITS && rest > 0; bit++) {
            root = Math.sqrt(root);
            rest *= 2;
            if (rest >= 1) {
                result *= root;
                rest -= 1;
            }
        }
        return result;
    }
}
