package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The second stage of overlap tests in the plane: evaluates in pairs of doubles what a filter left in doubt.
 *
 * <p>With u = 2^-53, {@link DoubleDoubleSum} adds with an error of at most 4u^2 (2^-104) of the magnitudes. The product
 * of a pair and a double is off by at most 3u^2 of itself (the tail's product u^2, its sum 2u^2), the product of two
 * pairs by at most 7u^2 (the product of the tails u^2, the two others u^2 each, their sum and the last 2u^2 each).
 * Products of two doubles are exact, and so are differences of coordinates, which are pairs.
 */
final class DoubleDoubleOverlap {
    // The offset's cross product: two products 3u^2, the sum 4u^2. A half size times a cross product: the cross
    // product's sum 4u^2, the product 3u^2. Up to six of these are added, each with 4u^2 of the total: 31u^2. A
    // direction is no longer than 1 + 1e-9, so the total is below the direction's length times the offset plus the half
    // sizes.
    private static final double ALONG = FilterBound.bound(32 * 0x1p-106);

    // The distance of the centre beyond a side: the cross product 7u^2 of the offset; the half size times the squared
    // length (one sum 4u^2, which is its own magnitude; the product 3u^2); their sum 4u^2.
    private static final double BEYOND = FilterBound.bound(12 * 0x1p-106);

    // Squares: 7u^2 each. The squared radius is exact; times the squared length 4u^2 and 7u^2. Two sums: 4u^2.
    private static final double SQUARES = FilterBound.bound(20 * 0x1p-106);

    /** More than tails lose to underflow: about 2^-1074, each times a size of at most 2^100. */
    private static final double UNDERFLOW = 0x1p-960;

    /** The value whose sign gave the last answer. */
    final DoubleDoubleSum value = new DoubleDoubleSum();

    private final DoubleDoubleSum cross = new DoubleDoubleSum();
    private final DoubleDoubleSum square = new DoubleDoubleSum();

    /**
     * Compares two boxes' projections along the normal of the direction (gx, gz), which is one of their own axes: 1
     * apart, -1 overlapping, 0 touching or too close to tell.
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

    /** Returns the sum of the half sizes. */
    private double subtractReach(double gx, double gz, double[] row, int at) {
        double sizes = 0;
        for (int axis = 0; axis < 3; axis++) {
            double x = row[at + Leaf.ROTATION + axis];
            double z = row[at + Leaf.ROTATION + 6 + axis];
            double half = row[at + Leaf.SIZE + axis];
            sizes += half;
            if ((x == 0 && z == 0) || (x == gx && z == gz)) {
                continue; // projects to a point
            }
            cross.clear();
            cross.addProduct(x, 0, gz, 0);
            cross.addProduct(z, 0, -gx, 0);
            value.addProduct(cross.hi, cross.lo, cross.hi < 0 ? half : -half, 0);
        }
        return sizes;
    }

    /**
     * Compares a disc with a rectangle whose stored X and Z axes are exactly perpendicular: 1 apart, -1 overlapping, 0
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
        // Each distance is off by the error, so its square by twice their product plus the error squared.
        return sign(2 * error * (besideX + besideZ + error) + SQUARES * sizes + UNDERFLOW);
    }

    // |d x n| minus the half size times the squared length of the axes
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
