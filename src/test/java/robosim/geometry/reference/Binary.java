package robosim.geometry.reference;

import java.math.BigInteger;

/** An integer times a power of two: what a double stands for, and all that plus, minus and times make of it. */
final class Binary implements Quantity {
    private static final Binary ZERO = new Binary(BigInteger.ZERO, 0);

    private final BigInteger digits;
    private final int power;

    private Binary(BigInteger digits, int power) {
        this.digits = digits;
        this.power = power;
    }

    static Binary of(double value) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            throw new IllegalArgumentException("value must be finite (got: " + value + ")");
        }
        if (value == 0) {
            return ZERO;
        }
        // A long holds every digit once the exponent is taken off; the last step of a double is 2^-1074.
        int power = Math.max(Math.getExponent(value), -1022) - 52;
        long bits = Double.doubleToLongBits(value);
        long digits = bits & (1L << 52) - 1;
        if ((bits >>> 52 & 0x7ff) != 0) {
            digits += 1L << 52;
        }
        while ((digits & 1) == 0) {
            digits >>= 1;
            power++;
        }
        return new Binary(BigInteger.valueOf(bits < 0 ? -digits : digits), power);
    }

    @Override
    public Quantity plus(Quantity that) {
        Binary other = (Binary) that;
        if (digits.signum() == 0) {
            return other;
        }
        if (other.digits.signum() == 0) {
            return this;
        }
        int common = Math.min(power, other.power);
        return new Binary(digits.shiftLeft(power - common).add(other.digits.shiftLeft(other.power - common)), common);
    }

    @Override
    public Quantity minus(Quantity that) {
        return plus(that.negate());
    }

    @Override
    public Quantity times(Quantity that) {
        Binary other = (Binary) that;
        BigInteger product = digits.multiply(other.digits);
        return product.signum() == 0 ? ZERO : new Binary(product, Math.addExact(power, other.power));
    }

    @Override
    public Quantity negate() {
        return new Binary(digits.negate(), power);
    }

    @Override
    public int signum() {
        return digits.signum();
    }

    @Override
    public boolean isPlainlyNotZero() {
        return digits.signum() != 0;
    }

    @Override
    public String toString() {
        return digits + " * 2^" + power;
    }
}
