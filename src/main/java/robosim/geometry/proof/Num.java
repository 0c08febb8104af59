package robosim.geometry.proof;

import java.math.BigInteger;

/**
 * An exact number, {@code m * 2^e}. Sums, differences and products are exact; {@link #rootUp} and {@link #overUp} are exact or
 * slightly above, so that a bound made with them can only fail a check, never pass one.
 */
record Num(BigInteger m, int e) implements Comparable<Num> {
    static final Num ZERO = new Num(BigInteger.ZERO, 0);
    static final Num ONE = new Num(BigInteger.ONE, 0);

    /** Bits of a result that has to be rounded. */
    private static final int BITS = 256;

    static Num of(double v) {
        if (v == 0) {
            return ZERO;
        }
        long bits = Double.doubleToRawLongBits(v);
        int exponent = (int) ((bits >> 52) & 0x7ff);
        long mantissa = (bits & 0xfffffffffffffL) | (exponent == 0 ? 0 : 1L << 52);
        int even = Long.numberOfTrailingZeros(mantissa);
        return new Num(BigInteger.valueOf((v < 0 ? -mantissa : mantissa) >> even), Math.max(exponent, 1) - 1075 + even);
    }

    Num plus(Num o) {
        if (m.signum() == 0 || o.m.signum() == 0) {
            return m.signum() == 0 ? o : this;
        }
        int shift = e - o.e;
        return shift >= 0 ? new Num(m.shiftLeft(shift).add(o.m), o.e) : new Num(m.add(o.m.shiftLeft(-shift)), e);
    }

    Num minus(Num o) {
        return plus(o.negate());
    }

    Num times(Num o) {
        return m.signum() == 0 || o.m.signum() == 0 ? ZERO : new Num(m.multiply(o.m), e + o.e);
    }

    Num negate() {
        return new Num(m.negate(), e);
    }

    Num abs() {
        return m.signum() < 0 ? negate() : this;
    }

    Num square() {
        return times(this);
    }

    Num twice() {
        return new Num(m, e + 1);
    }

    int sign() {
        return m.signum();
    }

    @Override
    public int compareTo(Num o) {
        return m.signum() == o.m.signum() ? minus(o).sign() : Integer.compare(m.signum(), o.m.signum());
    }

    /** The square root, or slightly more. */
    Num rootUp() {
        if (m.signum() < 0) {
            throw new ArithmeticException("a root must be of a number of at least 0 (got: " + this + ")");
        }
        int shift = Math.max(0, 2 * BITS - m.bitLength());
        shift += (e - shift) & 1;
        BigInteger wide = m.shiftLeft(shift);
        BigInteger root = wide.sqrt();
        return new Num(root.multiply(root).equals(wide) ? root : root.add(BigInteger.ONE), (e - shift) / 2);
    }

    /** The quotient by a positive number, or slightly more. */
    Num overUp(Num o) {
        int shift = Math.max(0, BITS + o.m.bitLength() - m.bitLength());
        BigInteger[] parts = m.shiftLeft(shift).divideAndRemainder(o.m);
        return new Num(parts[1].signum() > 0 ? parts[0].add(BigInteger.ONE) : parts[0], e - shift - o.e);
    }

    double approximately() {
        int drop = Math.max(0, m.bitLength() - 60);
        return Math.scalb((double) m.shiftRight(drop).longValue(), e + drop);
    }
}
