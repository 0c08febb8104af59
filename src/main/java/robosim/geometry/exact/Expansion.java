package robosim.geometry.exact;

/**
 * Exact arithmetic on expansions: sums of doubles that do not overlap, smallest first, in an array with a separate
 * length (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates"). Zeros
 * are left out; the number zero has length 0.
 *
 * <p>Exact only if nothing over- or underflows: before multiplying, check every input with {@link #fits}, and use
 * {@link Dyadic} if it returns false.
 */
public final class Expansion {
    private Expansion() {}

    /**
     * Whether a double is safe from over- and underflow in polynomials of a given degree in differences of such
     * doubles.
     *
     * <p>A double of magnitude {@code 2^-k} or more is a whole multiple of {@code 2^(-k - 52)}; a product of {@code
     * degree} of them is a multiple of {@code 2^(-degree * (k + 52))}, and so is every part of every intermediate
     * expansion. None is lost while that is at least {@code 2^-1074}, and none overflows below {@code 2^1000}.
     */
    public static boolean fits(double value, int degree) {
        if (value == 0) {
            return true;
        }
        int exponent = Math.getExponent(value);
        return exponent >= 53 - 1074 / degree && exponent <= 1000 / degree - 4;
    }

    /** Writes {@code a - b} to an array of at least 2 elements and returns the length. */
    public static int difference(double a, double b, double[] h) {
        double d = a - b;
        return pair(d, DoubleDouble.differenceTail(a, b, d), h);
    }

    /** Adds a double to an expansion in place and returns the new length, at most one more. */
    public static int grow(double[] e, int n, double b) {
        double q = b;
        int length = 0;
        for (int i = 0; i < n; i++) {
            double sum = q + e[i];
            double tail = DoubleDouble.sumTail(q, e[i], sum);
            q = sum;
            if (tail != 0) {
                e[length++] = tail;
            }
        }
        if (q != 0) {
            e[length++] = q;
        }
        return length;
    }

    /** Writes {@code e + f} to another array of at least {@code n + m} elements and returns the length. */
    public static int sum(double[] e, int n, double[] f, int m, double[] h) {
        int i = 0;
        int j = 0;
        int length = 0;
        double q = 0;
        for (int k = 0; k < n + m; k++) {
            boolean takeE = j == m || (i < n && Math.abs(e[i]) < Math.abs(f[j]));
            double next = takeE ? e[i++] : f[j++];
            double sum = q + next;
            double tail = DoubleDouble.sumTail(q, next, sum);
            q = sum;
            if (tail != 0) {
                h[length++] = tail;
            }
        }
        if (q != 0) {
            h[length++] = q;
        }
        return length;
    }

    /** Writes {@code e * b} to another array of at least {@code 2 * n} elements and returns the length. */
    public static int scale(double[] e, int n, double b, double[] h) {
        int length = 0;
        double q = 0;
        for (int i = 0; i < n; i++) {
            double product = e[i] * b;
            double low = DoubleDouble.productTail(e[i], b, product);
            double sum = q + low;
            double tail = DoubleDouble.sumTail(q, low, sum);
            if (tail != 0) {
                h[length++] = tail;
            }
            q = product + sum;
            tail = sum - (q - product);
            if (tail != 0) {
                h[length++] = tail;
            }
        }
        if (q != 0) {
            h[length++] = q;
        }
        return length;
    }

    /** Writes {@code e * f} to another array of at least {@code 2 * n * m} elements and returns the length. */
    public static int product(double[] e, int n, double[] f, int m, double[] h) {
        double[] part = new double[2 * n];
        double[] before = new double[2 * n * m];
        int length = 0;
        for (int j = 0; j < m; j++) {
            int partLength = scale(e, n, f[j], part);
            System.arraycopy(h, 0, before, 0, length);
            length = sum(before, length, part, partLength, h);
        }
        return length;
    }

    /** Changes the sign in place. */
    public static void negate(double[] e, int n) {
        for (int i = 0; i < n; i++) {
            e[i] = -e[i];
        }
    }

    /** The sign of an expansion: that of its largest part. */
    public static int sign(double[] e, int n) {
        for (int i = n - 1; i >= 0; i--) {
            if (e[i] != 0) {
                return e[i] > 0 ? 1 : -1;
            }
        }
        return 0;
    }

    private static int pair(double hi, double lo, double[] h) {
        int length = 0;
        if (lo != 0) {
            h[length++] = lo;
        }
        if (hi != 0) {
            h[length++] = hi;
        }
        return length;
    }
}
