package robosim.geometry;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * Rotations to some 31 digits, for comparison: a cosine and a sine of an exact angle, from their series, as pairs of
 * doubles, and products of such. Shares nothing with the product.
 */
final class Turning {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal PI =
            new BigDecimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899");

    private Turning() {}

    /** Cosine and sine of an angle in degrees: four doubles, a pair each. */
    static double[] of(BigDecimal degrees) {
        BigDecimal reduced = degrees.remainder(new BigDecimal(360));
        BigDecimal x = reduced.multiply(PI).divide(new BigDecimal(180), DIGITS);
        BigDecimal cos = BigDecimal.ZERO;
        BigDecimal sin = BigDecimal.ZERO;
        BigDecimal term = BigDecimal.ONE;
        for (int k = 0; k < 90; k++) {
            switch (k % 4) {
                case 0 -> cos = cos.add(term);
                case 1 -> sin = sin.add(term);
                case 2 -> cos = cos.subtract(term);
                default -> sin = sin.subtract(term);
            }
            term = term.multiply(x, DIGITS).divide(new BigDecimal(k + 1), DIGITS);
        }
        return new double[] {cos.doubleValue(), rest(cos), sin.doubleValue(), rest(sin)};
    }

    private static double rest(BigDecimal value) {
        return value.subtract(new BigDecimal(value.doubleValue())).doubleValue();
    }

    /** {@code sum += a * b}, of pairs; for magnitudes near 1 or with their sum far above what is added. */
    static void addProduct(double[] sum, int at, double aHi, double aLo, double bHi, double bLo) {
        double p = aHi * bHi;
        double e = Math.fma(aHi, bHi, -p) + (aHi * bLo + aLo * bHi);
        add(sum, at, p, e);
    }

    static void add(double[] sum, int at, double hi, double lo) {
        double s = sum[at] + hi;
        double v = s - sum[at];
        double e = (sum[at] - (s - v)) + (hi - v) + (sum[at + 1] + lo);
        sum[at] = s + e;
        sum[at + 1] = e - (sum[at] - s);
    }

    /** Turns the pairs at two places: {@code (a, b) <- (c a - s b, s a + c b)}. */
    static void turn(double[] pairs, int a, int b, double[] turning) {
        double[] next = new double[4];
        addProduct(next, 0, turning[0], turning[1], pairs[a], pairs[a + 1]);
        addProduct(next, 0, -turning[2], -turning[3], pairs[b], pairs[b + 1]);
        addProduct(next, 2, turning[2], turning[3], pairs[a], pairs[a + 1]);
        addProduct(next, 2, turning[0], turning[1], pairs[b], pairs[b + 1]);
        System.arraycopy(next, 0, pairs, a, 2);
        System.arraycopy(next, 2, pairs, b, 2);
    }
}
