package robosim.geometry.exact;

/**
 * Sine and cosine of radians: the same bits as {@link StrictMath}, but without allocation. From JDK 21 on StrictMath
 * allocates an array at each call.
 *
 * <p>The formulae are those of K. C. Ng's kernels for sine and cosine (1993), which the contract of StrictMath names:
 * the angle is reduced to within an eighth of a turn as a sum of two doubles, {@code x + tail}, to which an odd or even
 * polynomial is applied.
 */
public final class Radians {
    // The minimax polynomials on [-pi/4, pi/4]: sin x = x + x^3 (S3 + S5 x^2 + ..), off by less than 2^-58 of its
    // value, and cos x = 1 - x^2 / 2 + x^4 (C4 + C6 x^2 + ..), off by less than 2^-58.
    private static final double S3 = -0x1.5555555555549p-3;
    private static final double S5 = 0x1.111111110f8a6p-7;
    private static final double S7 = -0x1.a01a019c161d5p-13;
    private static final double S9 = 0x1.71de357b1fe7dp-19;
    private static final double S11 = -0x1.ae5e68a2b9cebp-26;
    private static final double S13 = 0x1.5d93a5acfd57cp-33;
    private static final double C4 = 0x1.555555555554cp-5;
    private static final double C6 = -0x1.6c16c16c15177p-10;
    private static final double C8 = 0x1.a01a019cb159p-16;
    private static final double C10 = -0x1.27e4f809c52adp-22;
    private static final double C12 = 0x1.1ee9ebdb4b1c4p-29;
    private static final double C14 = -0x1.8fae9be8838d4p-37;

    // pi / 2 in pieces of 33 bits, whose products with a number of quarters below 2^20 are exact, and the double
    // nearest to the remainder after each piece.
    private static final double QUARTER_1 = 0x1.921fb544p0;
    private static final double REST_1 = 0x1.0b4611a626331p-34;
    private static final double QUARTER_2 = 0x1.0b4611a6p-34;
    private static final double REST_2 = 0x1.3198a2e037073p-69;
    private static final double QUARTER_3 = 0x1.3198a2ep-69;
    private static final double REST_3 = 0x1.b839a252049c1p-104;
    private static final double QUARTERS = 0x1.45f306dc9c883p-1; // 2 / pi

    private static final long UPPER = 0xffffffff00000000L;
    private static final double EIGHTH = cut(Math.PI / 4);
    // Up to this many quarter turns the pieces suffice; StrictMath has the same limit.
    private static final double MOST = cut(0x1p19 * Math.PI / 2);
    private static final double TINY = 0x1p-27;

    private Radians() {}

    /** {@link StrictMath#sin}, within 1 ulp; StrictMath itself is called only beyond 2<sup>19</sup> quarter turns. */
    public static double sin(double radians) {
        double size = Math.abs(radians);
        if (cut(size) <= EIGHTH) {
            return size < TINY ? radians : sine(radians);
        }
        if (!(cut(size) <= MOST)) {
            return StrictMath.sin(radians);
        }
        double value = turned(size, 0);
        return radians < 0 ? -value : value;
    }

    /** {@link StrictMath#cos}, within 1 ulp; StrictMath itself is called only beyond 2<sup>19</sup> quarter turns. */
    public static double cos(double radians) {
        double size = Math.abs(radians);
        if (cut(size) <= EIGHTH) {
            return cosine(size, 0);
        }
        return cut(size) <= MOST ? turned(size, 1) : StrictMath.cos(radians);
    }

    /** The sine of an angle plus a number of quarter turns; the angle is above an eighth of a turn. */
    private static double turned(double size, int ahead) {
        double quarters = (int) (size * QUARTERS + 0.5);
        double left = size - quarters * QUARTER_1;
        double less = quarters * REST_1;
        double x = left - less;
        // If the two cancelled, the next piece is needed. As in StrictMath, the test does not depend on the value
        // alone: below 32 quarter turns the cancellation is checked only if the upper halves of the words agree.
        boolean isNear = quarters >= 32 || cut(size) == cut(quarters * (Math.PI / 2));
        if (isNear && Math.getExponent(size) - Math.getExponent(x) > 16) {
            double before = left;
            left = before - quarters * QUARTER_2;
            less = quarters * REST_2 - ((before - left) - quarters * QUARTER_2);
            x = left - less;
            if (Math.getExponent(size) - Math.getExponent(x) > 49) {
                before = left;
                left = before - quarters * QUARTER_3;
                less = quarters * REST_3 - ((before - left) - quarters * QUARTER_3);
                x = left - less;
            }
        }
        double tail = (left - x) - less;
        int quarter = (int) quarters + ahead;
        double value = (quarter & 1) == 0 ? sine(x, tail) : cosine(x, tail);
        return (quarter & 2) == 0 ? value : -value;
    }

    private static double sine(double x) {
        double square = x * x;
        return x + square * x * (S3 + square * sineSeries(square));
    }

    private static double sine(double x, double tail) {
        if (Math.abs(x) < TINY) {
            return x;
        }
        double square = x * x;
        double cube = square * x;
        return x - ((square * (0.5 * tail - cube * sineSeries(square)) - tail) - cube * S3);
    }

    private static double sineSeries(double square) {
        return S5 + square * (S7 + square * (S9 + square * (S11 + square * S13)));
    }

    private static double cosine(double x, double tail) {
        double square = x * x;
        double series = square * (C4 + square * (C6 + square * (C8 + square * (C10 + square * (C12 + square * C14)))));
        double correction = square * series - x * tail;
        double size = cut(Math.abs(x));
        if (size < 0x1.33333p-2) {
            return 1 - (0.5 * square - correction);
        }
        // About a quarter of x, with few significant bits, so that it is subtracted from 1 and from x^2 / 2 without
        // rounding.
        double part = size > 0x1.9p-1 ? 0.28125 : 0.25 * size;
        return (1 - part) - ((0.5 * square - part) - correction);
    }

    /** The number with the lower half of its bits cleared. */
    private static double cut(double size) {
        return Double.longBitsToDouble(Double.doubleToRawLongBits(size) & UPPER);
    }
}
