package robosim.geometry.exact;

/**
 * Angles in degrees: sine and cosine that are exact at quarter turns, headings that do not drift, and conversion from
 * and to radians.
 *
 * <p>Everything is built on {@link Radians}, {@link StrictMath} and exact reductions, so results are the same to the
 * bit on every JVM.
 */
public final class Degrees {
    // pi / 180, 180 / pi and pi / 2 as unevaluated sums of doubles.
    private static final double RADIANS_HI = 0x1.1df46a2529d39p-6;
    private static final double RADIANS_LO = 0x1.5c1d8becdd291p-62;
    private static final double DEGREES_HI = 0x1.ca5dc1a63c1f8p+5;
    private static final double DEGREES_LO = -0x1.1e7ab456405f9p-49;
    private static final double QUARTER_HI = 0x1.921fb54442d18p+0;
    private static final double QUARTER_LO = 0x1.1a62633145c07p-54;
    private static final double ROOT_HALF = 0x1.6a09e667f3bcdp-1;

    /** The largest error of one addition to a compensated heading, degrees. */
    public static final double ADDITION_ERROR = 0x1p-97;

    // From this magnitude on, neighbouring doubles are more than a quarter turn apart.
    private static final double MOST_QUARTERS = 0x1p52;

    // Up to here any number of whole turns is a double.
    private static final double MOST_TURNS = 0x1p52;

    private Degrees() {}

    /**
     * Sine of an angle, within 1.5 ulp (one of {@link Radians}, and the rounding of a correction); exact at multiples of 30
     * where it is 0, 0.5 or 1, and odd to the bit.
     *
     * @param degrees any finite number
     */
    public static double sin(double degrees) {
        return sin(degrees, 0);
    }

    /** Cosine of an angle, within 1.5 ulp; {@code cos(a) == sin(90 - a)} to the bit wherever {@code 90 - a} is exact. */
    public static double cos(double degrees) {
        return cos(degrees, 0);
    }

    /** Sine of the compensated angle {@code hi + lo}. */
    public static double sin(double hi, double lo) {
        double full = remainder(hi);
        double quarter = Math.rint(full / 90);
        return quadrant((int) quarter, full - 90 * quarter, lo);
    }

    /** Cosine of the compensated angle {@code hi + lo}. */
    public static double cos(double hi, double lo) {
        double full = remainder(hi);
        double quarter = Math.rint(full / 90);
        return quadrant((int) quarter + 1, full - 90 * quarter, lo);
    }

    // The remainder of an angle after subtracting the nearest number of whole turns; a tie goes to the even number.
    // Exact, since subtracting whole turns is where they are a double (Sterbenz).
    private static double remainder(double degrees) {
        double size = Math.abs(degrees);
        if (size <= 180) {
            return degrees;
        }
        if (size < 540) {
            return degrees - Math.copySign(360, degrees);
        }
        if (size >= MOST_TURNS) {
            return Math.IEEEremainder(degrees, 360); // many times slower
        }
        double left = degrees - 360 * Math.rint(degrees / 360);
        // Next to a tie the rounded quotient may be that of the other turn.
        return left > 180 ? left - 360 : left < -180 ? left + 360 : left;
    }

    /**
     * Adds to a compensated heading {@code hiLo[at] + hiLo[at + 1]} and reduces it to {@code (-180, 180]}. One addition
     * is off by less than {@link #ADDITION_ERROR} degree: the rounding error of a sum of two angles of up to 180 is at
     * most half an ulp of 360, 2<sup>-45</sup>, and the error carried so far is at most half an ulp of 180; only the
     * sum of these two errors is rounded, by 2<sup>-98</sup>. Subtracting a whole turn is exact (Sterbenz).
     */
    public static void add(double[] hiLo, int at, double degrees) {
        DoubleDouble.add(hiLo[at], hiLo[at + 1], remainder(degrees), 0, hiLo, at);
        double hi = hiLo[at];
        double lo = hiLo[at + 1];
        if (hi > 180 || (hi == 180 && lo > 0)) {
            DoubleDouble.add(hi, lo, -360, 0, hiLo, at);
        } else if (hi < -180 || (hi == -180 && lo <= 0)) {
            DoubleDouble.add(hi, lo, 360, 0, hiLo, at);
        }
        hiLo[at] += 0.0;
        hiLo[at + 1] += 0.0;
    }

    /**
     * Converts radians to degrees. The double nearest to {@code k * pi / 2} becomes exactly {@code 90 * k}, up to
     * {@code |k| = 2^52}; every other angle is correctly rounded, except near ties, closer than {@code 2^-100}.
     */
    public static double toDegrees(double radians) {
        double k = Math.rint(radians / QUARTER_HI);
        if (Math.abs(k) < MOST_QUARTERS && radians == quarters(k)) {
            return 90 * k + 0.0;
        }
        double product = radians * DEGREES_HI;
        if (!Double.isFinite(product)) {
            return product;
        }
        return product + (DoubleDouble.productTail(radians, DEGREES_HI, product) + radians * DEGREES_LO);
    }

    /**
     * Converts degrees to radians: the double nearest to {@code degrees * pi / 180}, except near ties, closer than
     * {@code 2^-100}.
     */
    public static double toRadians(double degrees) {
        double product = degrees * RADIANS_HI;
        return product + (DoubleDouble.productTail(degrees, RADIANS_HI, product) + degrees * RADIANS_LO);
    }

    /**
     * The heading, in {@code (-180, 180]}, of an object whose own X axis is {@code (r00, ., r20)}: exact at multiples
     * of 45 degrees, 0 if the axis is vertical.
     */
    public static double headingOf(double r00, double r20) {
        double x = r00 + 0.0;
        double left = 0.0 - r20;
        if (left == 0) {
            return x < 0 ? 180 : 0;
        }
        if (Math.abs(left) == Math.abs(x)) {
            return Math.copySign(x > 0 ? 45 : 135, left);
        }
        return x == 0 ? Math.copySign(90, left) : toDegrees(StrictMath.atan2(left, x));
    }

    // The double nearest to k quarter turns.
    private static double quarters(double k) {
        double product = k * QUARTER_HI;
        return product + (DoubleDouble.productTail(k, QUARTER_HI, product) + k * QUARTER_LO);
    }

    // sin(90 * quarter + within + lo); |within| <= 45, and subtracting 90 * quarter was exact (Sterbenz).
    private static double quadrant(int quarter, double within, double lo) {
        double sum = within + lo;
        double rest = DoubleDouble.sumTail(within, lo, sum);
        double value = (quarter & 1) == 0 ? sinWithin(sum, rest) : cosWithin(sum, rest);
        return ((quarter & 2) == 0 ? value : -value) + 0.0;
    }

    private static double sinWithin(double degrees, double lo) {
        double size = Math.abs(degrees);
        if (lo == 0 && (size == 45 || size == 30)) {
            return Math.copySign(size == 45 ? ROOT_HALF : 0.5, degrees);
        }
        double radians = degrees * RADIANS_HI;
        double tail = radiansTail(degrees, lo, radians);
        return Radians.sin(radians) + tail * Radians.cos(radians);
    }

    private static double cosWithin(double degrees, double lo) {
        if (lo == 0 && Math.abs(degrees) == 45) {
            return ROOT_HALF;
        }
        double radians = degrees * RADIANS_HI;
        double tail = radiansTail(degrees, lo, radians);
        return Radians.cos(radians) - tail * Radians.sin(radians);
    }

    private static double radiansTail(double degrees, double lo, double radians) {
        return DoubleDouble.productTail(degrees, RADIANS_HI, radians) + (degrees * RADIANS_LO + lo * RADIANS_HI);
    }
}
