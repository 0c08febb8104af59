package robosim.geometry.exact;

/**
 * A sum of products as a double-double: {@link #hi} plus {@link #lo}, some 106 bits.
 *
 * <p>A product is off by at most 2^-100 of itself, a sum by 2^-104 of its operands' magnitudes (see {@link
 * DoubleDouble}).
 */
public final class DoubleDoubleSum {
    /** The rounding error of a product below this may have been lost to underflow. */
    private static final double SMALL = 0x1p-900;

    public double hi;
    public double lo;

    /** Whether nothing has been rounded so far, so that the sum is exactly {@link #hi}. */
    public boolean plain;

    /** So many sums, each cleared. */
    public static DoubleDoubleSum[] array(int count) {
        DoubleDoubleSum[] sums = new DoubleDoubleSum[count];
        for (int k = 0; k < count; k++) {
            sums[k] = new DoubleDoubleSum();
        }
        return sums;
    }

    public void clear() {
        hi = 0;
        lo = 0;
        plain = true;
    }

    public void add(double p, double q) {
        double sum = hi + p;
        double tail = DoubleDouble.sumTail(hi, p, sum);
        double lows = lo + q;
        double lost = DoubleDouble.sumTail(lo, q, lows);
        plain &= q == 0 && tail == 0;
        tail += lows;
        double s = sum + tail;
        tail = tail - (s - sum) + lost;
        hi = s + tail;
        lo = tail - (hi - s);
    }

    public void add(DoubleDoubleSum other) {
        plain &= other.plain;
        add(other.hi, other.lo);
    }

    public void subtract(DoubleDoubleSum other) {
        plain &= other.plain;
        add(-other.hi, -other.lo);
    }

    /** Adds the product of {@code p + pTail} and {@code q + qTail}. */
    public void addProduct(double p, double pTail, double q, double qTail) {
        double product = p * q;
        double tail = DoubleDouble.productTail(p, q, product);
        plain &= pTail == 0 && qTail == 0 && (Math.abs(product) > SMALL || p == 0 || q == 0);
        tail += p * qTail + pTail * q;
        double s = product + tail;
        add(s, tail - (s - product));
    }

    public void negate() {
        hi = -hi;
        lo = -lo;
    }

    public void set(DoubleDoubleSum other) {
        hi = other.hi;
        lo = other.lo;
        plain = other.plain;
    }

    /** Whether this sum is less than another. */
    public boolean isBelow(DoubleDoubleSum other) {
        return hi < other.hi || (hi == other.hi && lo < other.lo);
    }

    /**
     * The largest double not above {@code gap / closing}, both of which are positive and off by at most the given
     * errors; NaN if the quotient is too close to a double to decide, or is not known to some 2^-56 of itself.
     */
    public static double floorQuotient(
            DoubleDoubleSum gap, double gapError, DoubleDoubleSum closing, double closingError) {
        // The division below is off by 2^-100 of its result; twice the sum covers the products of the errors.
        double share = 2 * (gapError / gap.hi + closingError / closing.hi) + 0x1p-98;
        if (!(share < 0x1p-58 && gap.hi > 0 && closing.hi > 0)) {
            return Double.NaN;
        }
        double q = gap.hi / closing.hi;
        double product = q * closing.hi;
        double tail = DoubleDouble.productTail(q, closing.hi, product);
        if (!(q > 0x1p-900 && product > 0x1p-900 && q < 0x1p900)) {
            return Double.NaN;
        }
        if (gap.plain && closing.plain) {
            // Close to each other, so their difference is exact.
            return product - gap.hi + tail > 0 ? Math.nextDown(q) : q;
        }
        double rest = (gap.hi - product - tail + gap.lo - q * closing.lo) / closing.hi;
        double nearest = q + rest;
        double beyond = rest - (nearest - q);
        double error = 2 * share * q;
        return beyond > error ? nearest : beyond < -error ? Math.nextDown(nearest) : Double.NaN;
    }
}
