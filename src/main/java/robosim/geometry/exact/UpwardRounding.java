package robosim.geometry.exact;

/** Sums, products and the reach of turned shapes along an axis, rounded up, and exact where nothing needs rounding. */
public final class UpwardRounding {
    // Six roundings of a sum of products of numbers that are not negative, and one for this product itself.
    private static final double OUTWARD = 1 + 0x1p-49;

    private UpwardRounding() {}

    /** {@code a + b}, rounded up. */
    public static double sum(double a, double b) {
        double sum = a + b;
        return up(sum, DoubleDouble.sumTail(a, b, sum));
    }

    /**
     * The next double above a number if its tail is above 0; without a branch, which would be mispredicted half of the
     * time.
     */
    private static double up(double number, double tail) {
        long isUp = Double.doubleToLongBits(0.0 - tail) >> (Long.SIZE - 1);
        long from = Double.doubleToRawLongBits(number + 0.0);
        long next = from + ((from >> (Long.SIZE - 1)) | 1);
        return Double.longBitsToDouble((Double.doubleToRawLongBits(number) & ~isUp) | (next & isUp));
    }

    // Of numbers that are not negative.
    private static double product(double a, double b) {
        double product = a * b;
        if (a == 0 || b == 0 || a == 1 || b == 1) {
            return product;
        }
        // Below this the rounding error of the product may itself be rounded.
        return up(product, product < 0x1p-960 ? 1 : Math.fma(a, b, -product));
    }

    /**
     * Half the extent of a box along a world axis.
     *
     * @param halves   its half sizes from {@code size} on
     * @param rotation one row of its rotation, the one of the world axis, from {@code row} on
     */
    public static double ofBox(double[] halves, int size, double[] rotation, int row) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum = sum(sum, product(halves[size + axis], Math.abs(rotation[row + axis])));
        }
        return sum;
    }

    /**
     * Half the extent of a capsule along a world axis.
     *
     * @param half  half the length of its segment
     * @param along the part of its axis along that world axis
     */
    public static double ofCapsule(double radius, double half, double along) {
        return sum(product(half, Math.abs(along)), radius);
    }

    /**
     * Half the extent of a cylinder along a world axis.
     *
     * @param half   half its height
     * @param along  the part of its axis along that world axis; {@code p} and {@code q} are the other two
     * @param length of its axis, which may be off 1 by rounding
     */
    public static double ofCylinder(double radius, double half, double along, double p, double q, double length) {
        double rim = radius * (Math.sqrt(p * p + q * q) / length);
        double sum = (half * Math.abs(along) + rim) * OUTWARD;
        return sum == 0 ? (radius == 0 && half == 0 ? 0 : Double.MIN_VALUE) : Math.nextUp(sum);
    }
}
