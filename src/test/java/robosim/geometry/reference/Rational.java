package robosim.geometry.reference;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/** A ratio of two integers: what a double stands for, and all that plus, minus, times and over make of it. */
final class Rational implements Comparable<Rational> {
    static final Rational ZERO = new Rational(BigInteger.ZERO, BigInteger.ONE);

    final BigInteger numerator;
    final BigInteger denominator;

    private Rational(BigInteger numerator, BigInteger denominator) {
        this.numerator = numerator;
        this.denominator = denominator;
    }

    /** In lowest terms, over a positive denominator. */
    static Rational of(BigInteger over, BigInteger under) {
        // Doubles have powers of two below: their common divisor is plain to see.
        boolean binary = under.signum() > 0 && under.bitCount() == 1;
        if (binary) {
            int twos = over.signum() == 0
                    ? under.getLowestSetBit()
                    : Math.min(over.getLowestSetBit(), under.getLowestSetBit());
            return new Rational(over.shiftRight(twos), under.shiftRight(twos));
        }
        BigInteger common = over.gcd(under);
        BigInteger divisor = under.signum() < 0 ? common.negate() : common;
        return new Rational(over.divide(divisor), under.divide(divisor));
    }

    /** Exactly what a double stands for. */
    static Rational of(double value) {
        BigDecimal decimal = new BigDecimal(value);
        int places = Math.max(0, decimal.scale());
        // So many decimal places come of as many binary ones.
        return of(
                decimal.multiply(new BigDecimal(BigInteger.TWO.pow(places))).toBigIntegerExact(),
                BigInteger.TWO.pow(places));
    }

    Rational plus(Rational that) {
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
        return numerator.hashCode() ^ denominator.hashCode();
    }

    Rational max(Rational that) {
        return compareTo(that) >= 0 ? this : that;
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
