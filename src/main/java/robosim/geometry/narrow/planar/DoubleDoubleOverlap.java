package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.exact.Filter;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The second stage of overlaps in the plane: the value of which a filter could not tell the sign, in pairs of doubles.
 *
 * <p>With u = 2^-53, {@link DoubleDoubleSum} adds with an error of at most 4u^2 of the magnitudes (2^-104), and multiplies a pair
 * by a double with one of at most 3u^2 of the product (the tail's product u^2, its sum 2u^2), two pairs with one of at
 * most 7u^2 (the product of the tails u^2, the two others u^2 each, their sum and the last 2u^2 each); products of two
 * doubles are without error. Differences of coordinates are pairs without error.
 */
final class DoubleDoubleOverlap {
    // The offset's cross product: two products 3u^2, the sum 4u^2. A half size times a cross product: the cross
    // product's sum 4u^2, the product 3u^2. Up to six of these are added, with 4u^2 of all each: 31u^2. A direction is
    // no longer than 1 + 1e-9, so that all is less than the direction's length times the offset and the half sizes.
    private static final double ALONG = Filter.bound(32 * 0x1p-106);

    // How far the centre is beyond a side: the cross product 7u^2 of the offset; the half size times the squared length
    // (one sum 4u^2, which is its own magnitude; the product 3u^2); their sum 4u^2.
    private static final double BEYOND = Filter.bound(12 * 0x1p-106);

    // Of squares: each 7u^2; the radius's square is exact and times the squared length 4u^2 and 7u^2; two sums 4u^2.
    private static final double SQUARES = Filter.bound(20 * 0x1p-106);

    /** More than what tails lose to underflow: some 2^-1074, each times a size of at most 2^100. */
    private static final double UNDERFLOW = 0x1p-960;

    /** What the last answer was told by. */
    final DoubleDoubleSum value = new DoubleDoubleSum();

    private final DoubleDoubleSum cross = new DoubleDoubleSum();
    private final DoubleDoubleSum square = new DoubleDoubleSum();

    /**
     * How two boxes' projections lie to each other, seen along the normal of the direction (gx, gz), one of their own
     * axes: 1 apart, -1 overlapping, 0 touching or too close to tell.
     */
    int along(double gx, double gz, double[] a, int i, double[] b, int j) {
        double dx = a[i] - b[j];
        double dz = a[i + 2] - b[j + 2];
        value.clear();
        value.addProduct(dx, DoubleDouble.differenceTail(a[i], b[j], dx), gz, 0);
        value.addProduct(dz, DoubleDouble.differenceTail(a[i + 2], b[j + 2], dz), -gx, 0);
        if (value.hi < 0) {
            value.negate();
        }
        double sizes = Math.abs(dx) + Math.abs(dz) + subtractReach(gx, gz, a, i) + subtractReach(gx, gz, b, j);
        return sign(ALONG * sizes * (Math.abs(gx) + Math.abs(gz)) + UNDERFLOW);
    }

    /** Answers the sum of the half sizes. */
    private double subtractReach(double gx, double gz, double[] row, int at) {
        double sizes = 0;
        for (int axis = 0; axis < 3; axis++) {
            double x = row[at + Leaf.ROTATION + axis];
            double z = row[at + Leaf.ROTATION + 6 + axis];
            double half = row[at + Leaf.SIZE + axis];
            sizes += half;
            if ((x == 0 && z == 0) || (x == gx && z == gz)) {
                continue; // seen as a point
            }
            cross.clear();
            cross.addProduct(x, 0, gz, 0);
            cross.addProduct(z, 0, -gx, 0);
            value.addProduct(cross.hi, cross.lo, cross.hi < 0 ? half : -half, 0);
        }
        return sizes;
    }

    /**
     * How a disc lies to a rectangle whose own X and Z are square to each other as stored: 1 apart, -1 overlapping, 0
     * touching or too close to tell.
     */
    int discRectangle(double px, double pz, double r, double[] row, int at) {
        double c = row[at + 6];
        double s = row[at + 8];
        double dx = px - row[at];
        double dz = pz - row[at + 2];
        double dxTail = DoubleDouble.differenceTail(px, row[at], dx);
        double dzTail = DoubleDouble.differenceTail(pz, row[at + 2], dz);
        square.clear();
        square.addProduct(c, 0, c, 0);
        square.addProduct(s, 0, s, 0);
        beyond(dx, dxTail, c, dz, dzTail, -s, row[at + 3]);
        double besideX = Math.max(0, cross.hi);
        double tailX = cross.hi > 0 ? cross.lo : 0;
        beyond(dx, dxTail, s, dz, dzTail, c, row[at + 5]);
        double besideZ = Math.max(0, cross.hi);
        double tailZ = cross.hi > 0 ? cross.lo : 0;
        double error = BEYOND * (Math.abs(dx) + Math.abs(dz) + row[at + 3] + row[at + 5]) + UNDERFLOW;
        value.clear();
        value.addProduct(besideX, tailX, besideX, tailX);
        value.addProduct(besideZ, tailZ, besideZ, tailZ);
        double near = r * r;
        double sizes = value.hi + near;
        value.addProduct(square.hi, square.lo, -near, -DoubleDouble.productTail(r, r, near));
        // Either distance is off by the error, so its square by twice the distance times that, and the error's square.
        return sign(2 * error * (besideX + besideZ + error) + SQUARES * sizes + UNDERFLOW);
    }

    // |d x n| less the half size times the squared length of the axes
    private void beyond(double dx, double dxTail, double nx, double dz, double dzTail, double nz, double half) {
        cross.clear();
        cross.addProduct(dx, dxTail, nx, 0);
        cross.addProduct(dz, dzTail, nz, 0);
        if (cross.hi < 0) {
            cross.negate();
        }
        cross.addProduct(square.hi, square.lo, -half, 0);
    }

    private int sign(double doubt) {
        return value.hi > doubt ? 1 : value.hi < -doubt ? -1 : 0;
    }
}
