package robosim.geometry.exact;

/**
 * Arithmetic on double-doubles: numbers that are the unevaluated sum of two doubles, {@code hi + lo} with {@code |lo|
 * <= ulp(hi) / 2}: some 106 bits. A result is written to {@code out[at]} (hi) and {@code out[at + 1]} (lo); nothing is
 * allocated.
 *
 * <p>Not exact: {@code add} and {@code subtract} are off by at most {@code 2^-104} of the sum of the operands'
 * magnitudes, {@code multiply}, {@code divide} and {@code sqrt} by at most {@code 2^-100} of the result, as long as
 * nothing overflows and no intermediate product is below {@code 2^-960}.
 */
public final class DoubleDouble {
    private DoubleDouble() {}

    /** The rounding error of {@code sum = a + b}: {@code a + b == sum + tail}, exact unless something overflows. */
    public static double sumTail(double a, double b, double sum) {
        double bVirtual = sum - a;
        double aVirtual = sum - bVirtual;
        return (a - aVirtual) + (b - bVirtual);
    }

    /** The rounding error of {@code difference = a - b}. */
    public static double differenceTail(double a, double b, double difference) {
        return sumTail(a, -b, difference);
    }

    /**
     * The rounding error of {@code product = a * b}: exact unless it overflows or falls below {@code 2^-1074}.
     */
    public static double productTail(double a, double b, double product) {
        return Math.fma(a, b, -product);
    }

    /** The exact {@code a + b}. */
    public static void sum(double a, double b, double[] out, int at) {
        double s = a + b;
        out[at] = s;
        out[at + 1] = sumTail(a, b, s);
    }

    /** The exact {@code a * b}. */
    public static void product(double a, double b, double[] out, int at) {
        double p = a * b;
        out[at] = p;
        out[at + 1] = productTail(a, b, p);
    }

    public static void add(double aHi, double aLo, double bHi, double bLo, double[] out, int at) {
        double s = aHi + bHi;
        double e = sumTail(aHi, bHi, s);
        double t = aLo + bLo;
        double f = sumTail(aLo, bLo, t);
        e += t;
        double s1 = s + e;
        e = e - (s1 - s) + f;
        settle(s1, e, out, at);
    }

    public static void subtract(double aHi, double aLo, double bHi, double bLo, double[] out, int at) {
        add(aHi, aLo, -bHi, -bLo, out, at);
    }

    public static void multiply(double aHi, double aLo, double bHi, double bLo, double[] out, int at) {
        double p = aHi * bHi;
        double e = productTail(aHi, bHi, p);
        e += aHi * bLo + aLo * bHi;
        settle(p, e, out, at);
    }

    /** {@code a / b} for {@code b} other than zero. */
    public static void divide(double aHi, double aLo, double bHi, double bLo, double[] out, int at) {
        double q = aHi / bHi;
        multiply(bHi, bLo, q, 0, out, at);
        subtract(aHi, aLo, out[at], out[at + 1], out, at);
        double rest = out[at] / bHi;
        settle(q, rest, out, at);
    }

    /** The square root of {@code a >= 0}. */
    public static void sqrt(double aHi, double aLo, double[] out, int at) {
        if (!(aHi > 0)) {
            out[at] = aHi == 0 ? 0 : Double.NaN;
            out[at + 1] = 0;
            return;
        }
        double root = Math.sqrt(aHi);
        double square = root * root;
        double rest = (aHi - square) - productTail(root, root, square) + aLo;
        settle(root, rest / (2 * root), out, at);
    }

    /** {@code a * b - c * d}, within two ulp of the result even under cancellation (Kahan; Jeannerod et al. 2013). */
    public static double differenceOfProducts(double a, double b, double c, double d) {
        double cd = c * d;
        double tail = Math.fma(-c, d, cd);
        return Math.fma(a, b, -cd) + tail;
    }

    /** {@code a * b + c * d}, within two ulp of the result even under cancellation. */
    public static double sumOfProducts(double a, double b, double c, double d) {
        return differenceOfProducts(a, b, -c, d);
    }

    // |hi| >= |lo| or hi is zero
    private static void settle(double hi, double lo, double[] out, int at) {
        double s = hi + lo;
        out[at] = s;
        out[at + 1] = lo - (s - hi);
    }
}
