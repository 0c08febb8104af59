package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/** A ratio of two integers: what a double stands for, and all that plus, minus, times and over make of it. */
final class Rational implements Comparable<Rational> {
    /** Bits of a denominator from which it is worth the time to look for common divisors. */
    private static final int LONG = 1024;

    static final Rational ZERO = new Rational(BigInteger.ZERO, BigInteger.ONE);

    final BigInteger numerator;
    final BigInteger denominator;

    private Rational(BigInteger numerator, BigInteger denominator) {
        this.numerator = numerator;
        this.denominator = denominator;
    }

    /** Over a positive denominator: in lowest terms where that is a power of two, or long. */
    static Rational of(BigInteger over, BigInteger under) {
        if (under.signum() == 0) {
            throw new ArithmeticException("a denominator must not be 0");
        }
        if (under.signum() < 0) {
            return of(over.negate(), under.negate());
        }
        if (over.signum() == 0) {
            return ZERO;
        }
        // Doubles have powers of two below: their common divisor is plain to see.
        int twos = Math.min(over.getLowestSetBit(), under.getLowestSetBit());
        BigInteger numerator = over.shiftRight(twos);
        BigInteger denominator = under.shiftRight(twos);
        // To find the common divisor of others takes longer than some sums and products of longer numbers.
        if (denominator.bitLength() <= LONG || denominator.bitCount() == 1) {
            return new Rational(numerator, denominator);
        }
        BigInteger common = numerator.gcd(denominator);
        return new Rational(numerator.divide(common), denominator.divide(common));
    }

    /** Exactly what a double stands for. */
    static Rational of(double value) {
        BigDecimal decimal = new BigDecimal(value);
        int places = Math.max(0, decimal.scale());
        // So many decimal places come of as many binary ones.
        BigInteger power = BigInteger.ONE.shiftLeft(places);
        return of(decimal.multiply(new BigDecimal(power)).toBigIntegerExact(), power);
    }

    Rational plus(Rational that) {
        if (denominator.equals(that.denominator)) {
            return of(numerator.add(that.numerator), denominator);
        }
        return of(
                numerator.multiply(that.denominator).add(that.numerator.multiply(denominator)),
                denominator.multiply(that.denominator));
    }

    Rational minus(Rational that) {
        return plus(that.negate());
    }

    Rational times(Rational that) {
        return of(numerator.multiply(that.numerator), denominator.multiply(that.denominator));
    }

    Rational over(Rational that) {
        return of(numerator.multiply(that.denominator), denominator.multiply(that.numerator));
    }

    Rational negate() {
        return new Rational(numerator.negate(), denominator);
    }

    Rational square() {
        return times(this);
    }

    int signum() {
        return numerator.signum();
    }

    @Override
    public int compareTo(Rational that) {
        return numerator.multiply(that.denominator).compareTo(that.numerator.multiply(denominator));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Rational that && compareTo(that) == 0;
    }

    @Override
    public int hashCode() {
        BigInteger common = numerator.gcd(denominator);
        return numerator.divide(common).hashCode() ^ denominator.divide(common).hashCode();
    }

    Rational max(Rational that) {
        return compareTo(that) >= 0 ? this : that;
    }

    /** The least multiple of a positive whole number that makes this whole too. */
    BigInteger commonDenominator(BigInteger other) {
        return denominator.equals(other) ? other : other.multiply(denominator.divide(other.gcd(denominator)));
    }

    /** This times a whole number, which makes it whole. */
    BigInteger timesWhole(BigInteger scale) {
        BigInteger[] parts = numerator.multiply(scale).divideAndRemainder(denominator);
        if (parts[1].signum() != 0) {
            throw new ArithmeticException(this + " times " + scale + " is not whole");
        }
        return parts[0];
    }

    BigDecimal toDecimal(MathContext digits) {
        return new BigDecimal(numerator).divide(new BigDecimal(denominator), digits);
    }

    /** Dot product. */
    static Rational dot(Rational[] a, Rational[] b) {
        Rational sum = ZERO;
        for (int k = 0; k < a.length; k++) {
            sum = sum.plus(a[k].times(b[k]));
        }
        return sum;
    }

    static Rational[] minus(Rational[] a, Rational[] b) {
        Rational[] difference = new Rational[a.length];
        for (int k = 0; k < a.length; k++) {
            difference[k] = a[k].minus(b[k]);
        }
        return difference;
    }

    @Override
    public String toString() {
        return numerator + "/" + denominator;
    }
}
