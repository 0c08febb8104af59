package robosim.geometry.exact;

import java.math.BigInteger;
import org.jspecify.annotations.Nullable;

/**
 * A number {@code mantissa * 2^exponent}, held exactly; immutable.
 *
 * <p>The slow but certain way to decide a sign; kernels use it only when a filter in plain doubles is inconclusive.
 * Every finite double is such a number, and sums, differences and products are exact at any magnitude.
 */
public final class Dyadic implements Comparable<Dyadic> {
    public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);
    public static final Dyadic ONE = new Dyadic(BigInteger.ONE, 0);

    private static final int LEAST_EXPONENT = -1074;

    private final BigInteger mantissa;
    private final int exponent;

    private Dyadic(BigInteger mantissa, int exponent) {
        this.mantissa = mantissa;
        this.exponent = exponent;
    }

    /**
     * The value of a double.
     *
     * @throws IllegalArgumentException if it is NaN or infinite
     */
    public static Dyadic of(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("value must be finite (got: " + value + ")");
        }
        if (value == 0) {
            return ZERO;
        }
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
        long fraction = Double.doubleToRawLongBits(value) & 0xF_FFFF_FFFF_FFFFL;
        long whole = Math.abs(value) >= Double.MIN_NORMAL ? fraction | 0x10_0000_0000_0000L : fraction;
        int zeros = Long.numberOfTrailingZeros(whole);
        long odd = whole >> zeros;
        return new Dyadic(BigInteger.valueOf(value < 0 ? -odd : odd), exponent + zeros);
    }

    /** The difference {@code a - b} of two doubles, without rounding. */
    public static Dyadic difference(double a, double b) {
        return of(a).subtract(of(b));
    }

    /** The product {@code a * b} of two doubles, without rounding. */
    public static Dyadic product(double a, double b) {
        return of(a).multiply(of(b));
    }

    public Dyadic add(Dyadic other) {
        if (mantissa.signum() == 0) {
            return other;
        }
        if (other.mantissa.signum() == 0) {
            return this;
        }
        int common = Math.min(exponent, other.exponent);
        return new Dyadic(at(common).add(other.at(common)), common);
    }

    public Dyadic subtract(Dyadic other) {
        return add(other.negate());
    }

    public Dyadic multiply(Dyadic other) {
        if (mantissa.signum() == 0 || other.mantissa.signum() == 0) {
            return ZERO;
        }
        return new Dyadic(mantissa.multiply(other.mantissa), Math.addExact(exponent, other.exponent));
    }

    public Dyadic square() {
        return multiply(this);
    }

    /** This number times {@code 2^power}. */
    public Dyadic scale(int power) {
        return mantissa.signum() == 0 ? this : new Dyadic(mantissa, Math.addExact(exponent, power));
    }

    public Dyadic negate() {
        return new Dyadic(mantissa.negate(), exponent);
    }

    public Dyadic abs() {
        return mantissa.signum() < 0 ? negate() : this;
    }

    public Dyadic min(Dyadic other) {
        return compareTo(other) <= 0 ? this : other;
    }

    public Dyadic max(Dyadic other) {
        return compareTo(other) >= 0 ? this : other;
    }

    /** The square root of a number that is not negative, in so many bits: off by less than 2^(1 - bits) of itself. */
    public Dyadic root(int bits) {
        int left = 2 * bits - mantissa.bitLength();
        left += exponent - left & 1; // the exponent that remains must be even
        return signum() == 0 ? this : new Dyadic(mantissa.shiftLeft(left).sqrt(), (exponent - left) / 2);
    }

    /** This number divided by one that is not 0, in so many bits: off by less than 2^(2 - bits) of the quotient. */
    public Dyadic over(Dyadic divisor, int bits) {
        Dyadic n = cut(2 * bits);
        Dyadic d = divisor.cut(bits);
        return signum() == 0
                ? this
                : new Dyadic(n.mantissa.divide(d.mantissa), Math.subtractExact(n.exponent, d.exponent));
    }

    /** This number with so many bits: the lower ones cut off, or zeros appended. */
    private Dyadic cut(int bits) {
        int left = bits - mantissa.abs().bitLength();
        BigInteger magnitude = mantissa.abs().shiftLeft(left);
        return new Dyadic(signum() < 0 ? magnitude.negate() : magnitude, exponent - left);
    }

    /** The smallest n with {@code |this| < 2^n}; unless this number is 0, its magnitude is at least half of that. */
    public int magnitude() {
        return exponent + mantissa.abs().bitLength();
    }

    public int signum() {
        return mantissa.signum();
    }

    @Override
    public int compareTo(Dyadic other) {
        int sign = signum();
        int otherSign = other.signum();
        if (sign != otherSign || sign == 0) {
            return Integer.compare(sign, otherSign);
        }
        int top = exponent + mantissa.abs().bitLength();
        int otherTop = other.exponent + other.mantissa.abs().bitLength();
        if (top != otherTop) {
            return top > otherTop ? sign : -sign;
        }
        int common = Math.min(exponent, other.exponent);
        return at(common).compareTo(other.at(common));
    }

    /** The nearest double, ties to even; infinite if beyond the largest finite one. */
    public double doubleValue() {
        int step = step();
        BigInteger magnitude = mantissa.abs();
        int drop = step - exponent;
        long whole = shift(magnitude, -drop).longValue();
        if (drop > 0 && magnitude.testBit(drop - 1)) {
            boolean tie = magnitude.getLowestSetBit() == drop - 1;
            if (!tie || (whole & 1) != 0) {
                whole++;
            }
        }
        return signum() * scaled(whole, step);
    }

    /**
     * Sign of {@code a + b + c}, exact, without allocation in all ordinary cases.
     */
    public static int signOfSum(double a, double b, double c) {
        return signOfSum(a, b, c, 0);
    }

    /** Sign of {@code a + b + c + d}, exact, without allocation in all ordinary cases. */
    public static int signOfSum(double a, double b, double c, double d) {
        // The exact sum of a and b is s + e; adding c to (e, s) gives three parts that do not overlap, and so on
        // (Shewchuk
        // 1997, 2.4).
        double s = a + b;
        double e = DoubleDouble.sumTail(a, b, s);
        double q = c + e;
        double low = DoubleDouble.sumTail(c, e, q);
        double high = q + s;
        double middle = DoubleDouble.sumTail(q, s, high);
        double q1 = d + low;
        double h1 = DoubleDouble.sumTail(d, low, q1);
        double q2 = q1 + middle;
        double h2 = DoubleDouble.sumTail(q1, middle, q2);
        double q3 = q2 + high;
        double h3 = DoubleDouble.sumTail(q2, high, q3);
        if (!(Math.abs(q3) + Math.abs(h3) < Double.POSITIVE_INFINITY)) {
            return of(a).add(of(b)).add(of(c)).add(of(d)).signum();
        }
        return sign(q3, h3, h2, h1);
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Dyadic dyadic && compareTo(dyadic) == 0;
    }

    @Override
    public int hashCode() {
        if (mantissa.signum() == 0) {
            return 0;
        }
        int zeros = mantissa.getLowestSetBit();
        return 31 * mantissa.shiftRight(zeros).hashCode() + exponent + zeros;
    }

    @Override
    public String toString() {
        return mantissa + " * 2^" + exponent;
    }

    // Parts that do not overlap, largest first: the first that is not zero has the sign of the sum.
    private static int sign(double a, double b, double c, double d) {
        double leading = a != 0 ? a : b != 0 ? b : c != 0 ? c : d;
        return leading > 0 ? 1 : leading < 0 ? -1 : 0;
    }

    private BigInteger at(int lower) {
        return shift(mantissa, exponent - lower);
    }

    private static BigInteger shift(BigInteger value, int left) {
        return left == 0 ? value : value.shiftLeft(left);
    }

    // The exponent of the last bit of a double of this magnitude.
    private int step() {
        return Math.max(exponent + mantissa.abs().bitLength() - 53, LEAST_EXPONENT);
    }

    private static double scaled(long whole, int step) {
        if (whole == 0) {
            return 0;
        }
        // Two factors, because 2^step itself may not be a double.
        int half = Math.max(Math.min(step, 2 * Double.MAX_EXPONENT) / 2, LEAST_EXPONENT / 2);
        int rest = Math.max(Math.min(step, 2 * Double.MAX_EXPONENT) - half, LEAST_EXPONENT / 2);
        return StrictMath.scalb((double) whole, half) * StrictMath.scalb(1.0, rest);
    }
}
