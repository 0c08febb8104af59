package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.LeafKind;

/** A disc and a rectangle, the projection of an upright box. */
public final class DiscRectangle {
    // With u = 2^-53: a coordinate in the rectangle's frame is off by 3u of |dx| + |dz|, the half size times the
    // squared length by 3u; their difference, and that of the result and this bound, add 1u each. A direction is no
    // longer than 1 + 1e-9.
    private static final double OFFSET = FilterBound.bound(5.01 * 0x1p-53);

    // The squared radius times the squared length is off by 4u, the sum of the two other squares by 2u; adding this
    // bound costs 1u.
    private static final double SQUARES = FilterBound.bound(5.01 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    /** From this many radii away, the error of the difference is no more than that of the distance to the centre. */
    private static final double MANY = 16;

    private static final StageCounters.Counter FINE = StageCounters.counter("DiscRectangle fine");
    private static final StageCounters.Counter EXACT = StageCounters.counter("DiscRectangle");

    private DiscRectangle() {}

    /** Whether the stored X and Z axes are exactly perpendicular, as they are for every heading. */
    public static boolean isSquare(double[] row, int at) {
        return row[at + 6] == row[at + 14] && row[at + 8] == -row[at + 12];
    }

    /** Whether the box's own axes are exactly the world's axes. */
    static boolean isAligned(double[] row, int at) {
        double c = row[at + 6];
        double s = row[at + 8];
        return isSquare(row, at) && ((s == 0 && Math.abs(c) == 1) || (c == 0 && Math.abs(s) == 1));
    }

    /** Half the extent in x of an aligned rectangle. */
    public static double alignedX(double[] row, int at) {
        return row[at + 8] == 0 ? row[at + 3] : row[at + 5];
    }

    /** Half the extent in z of an aligned rectangle. */
    public static double alignedZ(double[] row, int at) {
        return row[at + 8] == 0 ? row[at + 5] : row[at + 3];
    }

    /** Whether they touch or overlap; exact. */
    public static boolean touch(double px, double pz, double r, double[] row, int at, DoubleDoubleOverlap fine) {
        int sure = sure(px, pz, r, row[at], row[at + 2], row[at + 3], row[at + 5], row[at + 6], row[at + 8]);
        if (sure != 0) {
            return sure < 0;
        }
        FINE.count();
        int side = fine.discRectangle(px, pz, r, row, at);
        return side == 0 ? doubtfulTouch(px, pz, r, row, at) : side < 0;
    }

    /**
     * Whether they touch, for a rectangle given by its numbers and the cosine and sine of its heading: negative where
     * they do, positive where they do not, 0 where doubles cannot tell.
     */
    public static int sure(
            double px, double pz, double r, double cx, double cz, double hx, double hz, double c, double s) {
        double dx = px - cx;
        double dz = pz - cz;
        double square = c * c + s * s;
        double doubt = OFFSET * (Math.abs(dx) + Math.abs(dz) + hx + hz) + UNDERFLOW;
        double beyondX = Math.abs(dx * c - dz * s) - hx * square;
        double beyondZ = Math.abs(dx * s + dz * c) - hz * square;
        double leastX = positive(beyondX - doubt);
        double leastZ = positive(beyondZ - doubt);
        double near = r * r * square;
        double slack = SQUARES * near + UNDERFLOW;
        double least = leastX * leastX + leastZ * leastZ;
        if (least > (near + slack) + SQUARES * least) {
            return 1;
        }
        double mostX = positive(beyondX + doubt);
        double mostZ = positive(beyondZ + doubt);
        double most = mostX * mostX + mostZ * mostZ;
        return most < (near - slack) - SQUARES * most || (mostX == 0 && mostZ == 0) ? -1 : 0;
    }

    /** The number, or 0 if it is negative; exact and branch-free. */
    private static double positive(double number) {
        return (number + Math.abs(number)) / 2;
    }

    private static boolean doubtfulTouch(double px, double pz, double r, double[] row, int at) {
        EXACT.count();
        if (isAligned(row, at)) {
            double hx = alignedX(row, at);
            double hz = alignedZ(row, at);
            boolean beyondX = isBeyond(px, row[at], hx, 0);
            boolean beyondZ = isBeyond(pz, row[at + 2], hz, 0);
            if (!(beyondX && beyondZ)) {
                return !isBeyond(px, row[at], hx, r) && !isBeyond(pz, row[at + 2], hz, r);
            }
        }
        return exactTouch(px, pz, r, row, at);
    }

    // |p - c| > h + r
    private static boolean isBeyond(double p, double c, double h, double r) {
        double left = p > c ? p : c;
        double right = p > c ? c : p;
        return Dyadic.signOfSum(left, -right, -h, -r) > 0;
    }

    private static boolean exactTouch(double px, double pz, double r, double[] row, int at) {
        return ExactPolygon.of(LeafKind.UPRIGHT_BOX, row, at).touchesDisc(px, pz, r);
    }

    /** The distance; 0 in contact. Accurate to three ulp plus 2^-98 of the offset and the sizes. */
    public static double distance(double px, double pz, double r, double[] row, int at, PlanarScratch scratch) {
        if (touch(px, pz, r, row, at, scratch.fine)) {
            return 0;
        }
        double c = row[at + 6];
        double s = row[at + 8];
        double beyondX = Math.max(0, gap(px, pz, row, at, c, -s, row[at + 3]));
        double beyondZ = Math.max(0, gap(px, pz, row, at, s, c, row[at + 5]));
        double square = c * c + s * s;
        if (beyondX + beyondZ < VectorMath.TINY) {
            return Math.max(0, VectorMath.legs(beyondX, beyondZ) / Math.sqrt(square) - r);
        }
        double toCenter = Math.sqrt((beyondX * beyondX + beyondZ * beyondZ) / square);
        // Otherwise the difference would be only as accurate as the radius.
        return toCenter > MANY * r ? toCenter - r : powerDistance(px, pz, r, row, at, scratch.planarPairs);
    }

    // (d - r)(d + r) / (d + r), with the product computed from the squares in pairs of doubles.
    private static double powerDistance(double px, double pz, double r, double[] row, int at, DoubleDoubles p) {
        double c = row[at + 6];
        double s = row[at + 8];
        p.difference(0, px, row[at]);
        p.difference(1, pz, row[at + 2]);
        p.product(2, c, c);
        p.product(3, s, s);
        p.add(2, 2, 3);
        squareBeyond(p, 4, c, -s, row[at + 3]);
        squareBeyond(p, 5, s, c, row[at + 5]);
        p.add(4, 4, 5);
        p.divide(4, 4, 2);
        double toCenter = Math.sqrt(p.get(4));
        p.product(5, r, r);
        p.subtract(4, 4, 5);
        return Math.max(0, p.get(4) / (toCenter + r));
    }

    // The squared product of the centre's distance beyond a side and the length of the side's normal; 0 inside.
    private static void squareBeyond(DoubleDoubles p, int out, double nx, double nz, double half) {
        int temporary = 6;
        p.multiply(out, 0, nx);
        p.multiply(temporary, 1, nz);
        p.add(out, out, temporary);
        if (p.get(out) < 0) {
            p.negate(out);
        }
        p.multiply(temporary, 2, half);
        p.subtract(out, out, temporary);
        if (p.get(out) < 0) {
            p.set(out, 0);
        }
        p.multiply(out, out, out);
    }

    /**
     * The signed distance of (px, pz) beyond a side with normal (nx, nz) and half size h, times the normal's length:
     * {@code |(p - c) . n| - h n . n}, within an ulp or two even under cancellation.
     */
    public static double gap(double px, double pz, double[] row, int at, double nx, double nz, double h) {
        return gap(px, pz, row[at], row[at + 2], nx, nz, h);
    }

    public static double gap(double px, double pz, double cx, double cz, double nx, double nz, double h) {
        double dx = px - cx;
        double dxTail = DoubleDouble.differenceTail(px, cx, dx);
        double dz = pz - cz;
        double dzTail = DoubleDouble.differenceTail(pz, cz, dz);
        double p = dx * nx;
        double q = dz * nz;
        double offset = p + q;
        double offsetTail = DoubleDouble.sumTail(p, q, offset)
                + DoubleDouble.productTail(dx, nx, p)
                + DoubleDouble.productTail(dz, nz, q)
                + (dxTail * nx + dzTail * nz);
        double xx = nx * nx;
        double zz = nz * nz;
        double square = xx + zz;
        double squareTail = DoubleDouble.sumTail(xx, zz, square)
                + DoubleDouble.productTail(nx, nx, xx)
                + DoubleDouble.productTail(nz, nz, zz);
        double reach = h * square;
        double reachTail = DoubleDouble.productTail(h, square, reach) + h * squareTail;
        double far = Math.abs(offset);
        double farTail = VectorMath.signed(offsetTail, offset + 0.0);
        double gap = far - reach;
        return gap + (DoubleDouble.differenceTail(far, reach, gap) + (farTail - reachTail));
    }
}
