package robosim.geometry.exact;

/**
 * Lengths and largest coordinates of plain vectors, the unit roundoff, and the conversion between a ray's parameter and
 * a distance.
 */
public final class VectorMath {
    /** The unit roundoff: the largest relative error of one double operation. */
    public static final double U = 0x1p-53;

    /**
     * An upper bound of the errors that underflow may add to a decision: fewer than 2^10 products are off by 2^-1075
     * each, and later factors are below 2^210.
     */
    public static final double UNDERFLOW = 0x1p-800;

    /** Below this the squares of a distance's components may underflow; above it no square that matters does. */
    public static final double TINY = 0x1p-450;

    /** The factor that makes tiny numbers large enough to be squared; a power of two, so that nothing is rounded. */
    public static final double ENLARGED = 0x1p500;

    /** The same for numbers down to the least double, 2^-1074; what is below {@link #TINY} comes to 2^500 by it. */
    private static final double LARGEST = 0x1p950;

    /** The double nearest to one over the root of 2. */
    public static final double HALF_ROOT = 0.7071067811865476;

    private VectorMath() {}

    /** The square root of the sum of two squares, for arguments of at least 0, however small. */
    public static double legs(double x, double z) {
        if (x + z < TINY) {
            double ex = x * LARGEST;
            double ez = z * LARGEST;
            return Math.sqrt(ex * ex + ez * ez) / LARGEST;
        }
        return Math.sqrt(x * x + z * z);
    }

    /** The length of a vector, however small; as {@link #length} where that is not. */
    public static double anyLength(double x, double y, double z) {
        if (largest(x, y, z) < TINY) {
            return length(x * LARGEST, y * LARGEST, z * LARGEST) / LARGEST;
        }
        return length(x, y, z);
    }

    /**
     * A number, negated if {@code sign} is negative; without a branch, which would be mispredicted half of the time.
     */
    public static double signed(double number, double sign) {
        return Double.longBitsToDouble(
                Double.doubleToRawLongBits(number) ^ (Double.doubleToRawLongBits(sign) & Long.MIN_VALUE));
    }

    /** {@code positive} or {@code negative}, by the sign of a number; also without a branch. */
    public static double pick(double number, double positive, double negative) {
        long isNegative = Double.doubleToRawLongBits(number) >> (Long.SIZE - 1);
        return Double.longBitsToDouble((Double.doubleToRawLongBits(positive) & ~isNegative)
                | (Double.doubleToRawLongBits(negative) & isNegative));
    }

    public static double largest(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    public static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /**
     * The distance in world units at the parameter {@code t + tail} of a direction, with about one rounding: the length
     * of the direction and its product with t are computed to some 100 bits.
     */
    public static double along(double t, double tail, double dx, double dy, double dz) {
        double xx = dx * dx;
        double yy = dy * dy;
        double zz = dz * dz;
        double xy = xx + yy;
        double square = xy + zz;
        double dropped = DoubleDouble.sumTail(xx, yy, xy)
                + DoubleDouble.sumTail(xy, zz, square)
                + (DoubleDouble.productTail(dx, dx, xx)
                        + DoubleDouble.productTail(dy, dy, yy)
                        + DoubleDouble.productTail(dz, dz, zz));
        double length = Math.sqrt(square);
        double lengthTail = (Math.fma(-length, length, square) + dropped) / (2 * length);
        double whole = t * length;
        double rest = DoubleDouble.productTail(t, length, whole) + (tail * length + t * lengthTail);
        return Math.max(0, whole + rest);
    }

    /**
     * Whether an error is small enough for a distance: at most 3 ulp of the largest of the distance and the
     * coordinates, so that after the last rounding the distance is within 4 ulp of that maximum.
     */
    public static boolean isFine(double error, double distance, double largestCoordinate) {
        return error <= 3 * Math.ulp(Math.max(distance, largestCoordinate));
    }
}
