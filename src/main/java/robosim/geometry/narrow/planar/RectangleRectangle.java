package robosim.geometry.narrow.planar;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Two rectangles, the projections of upright boxes: {@link ZonogonZonogon} with fewer axes, as {@code
 * robosim.geometry.bench.SeparatingAxes} measures.
 */
public final class RectangleRectangle {
    // With u = 2^-53 and n a stored direction, no longer than 1 + 1e-9 (the Cauchy-Schwarz inequality bounds the sums
    // of products): the offset along n is rounded three times, so off by 3u (|dx| + |dz|). A cross product is rounded
    // twice, so off by 2u, its product with a half size once, and the sum of three of these twice: 5u of the half
    // sizes. The last difference preserves its sign. The 2^-26 cover squares of u, the directions' lengths and the
    // bound's own rounding.
    private static final double SLACK = 1 + 0x1p-26;
    private static final double OFFSET = FilterBound.bound(SLACK * 3 * 0x1p-53);
    private static final double HALVES = FilterBound.bound(SLACK * 5 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter ALIGNED = StageCounters.counter("RectangleRectangle aligned");
    private static final StageCounters.Counter FINE = StageCounters.counter("RectangleRectangle fine");
    private static final StageCounters.Counter EXACT = StageCounters.counter("RectangleRectangle");

    private RectangleRectangle() {}

    /** Whether they touch or overlap; exact. */
    public static boolean touch(double[] a, int i, double[] b, int j, DoubleDoubleOverlap fine) {
        double dx = a[i] - b[j];
        double dz = a[i + 2] - b[j + 2];
        double aHalfX = a[i + 3];
        double aHalfZ = a[i + 5];
        double bHalfX = b[j + 3];
        double bHalfZ = b[j + 5];
        double doubt =
                OFFSET * (Math.abs(dx) + Math.abs(dz)) + HALVES * (aHalfX + aHalfZ + bHalfX + bHalfZ) + UNDERFLOW;
        double aux = a[i + 6];
        double auz = a[i + 12];
        double avx = a[i + 8];
        double avz = a[i + 14];
        double bux = b[j + 6];
        double buz = b[j + 12];
        double bvx = b[j + 8];
        double bvz = b[j + 14];
        double uu = Math.abs(aux * buz - auz * bux);
        double uv = Math.abs(aux * bvz - auz * bvx);
        double vu = Math.abs(avx * buz - avz * bux);
        double vv = Math.abs(avx * bvz - avz * bvx);
        double aCross = Math.abs(aux * avz - auz * avx);
        double bCross = Math.abs(bux * bvz - buz * bvx);
        // The gap between the rectangles along the normal of each side; negative where their projections overlap.
        double gap1 = Math.abs(dx * auz - dz * aux) - (aHalfZ * aCross + bHalfX * uu + bHalfZ * uv);
        double gap2 = Math.abs(dx * avz - dz * avx) - (aHalfX * aCross + bHalfX * vu + bHalfZ * vv);
        double gap3 = Math.abs(dx * buz - dz * bux) - (bHalfZ * bCross + aHalfX * uu + aHalfZ * vu);
        double gap4 = Math.abs(dx * bvz - dz * bvx) - (bHalfX * bCross + aHalfX * uv + aHalfZ * vv);
        double gap = Math.max(Math.max(gap1, gap2), Math.max(gap3, gap4));
        if (gap > doubt) {
            return false;
        }
        if (gap < -doubt) {
            return true;
        }
        if (DiscRectangle.isAligned(a, i) && DiscRectangle.isAligned(b, j)) {
            return alignedTouch(a, i, b, j);
        }
        FINE.count();
        int side1 = gap1 < -doubt ? -1 : fine.along(aux, auz, a, i, b, j);
        int side2 = gap2 < -doubt ? -1 : fine.along(avx, avz, a, i, b, j);
        int side3 = gap3 < -doubt ? -1 : fine.along(bux, buz, a, i, b, j);
        int side4 = gap4 < -doubt ? -1 : fine.along(bvx, bvz, a, i, b, j);
        int side = Math.max(Math.max(side1, side2), Math.max(side3, side4));
        return side == 0 ? exactTouch(a, i, b, j) : side < 0;
    }

    private static boolean alignedTouch(double[] a, int i, double[] b, int j) {
        ALIGNED.count();
        return reach(a[i], b[j], DiscRectangle.alignedX(a, i), DiscRectangle.alignedX(b, j))
                && reach(a[i + 2], b[j + 2], DiscRectangle.alignedZ(a, i), DiscRectangle.alignedZ(b, j));
    }

    private static boolean exactTouch(double[] a, int i, double[] b, int j) {
        EXACT.count();
        return ExactPolygon.of(LeafKind.UPRIGHT_BOX, a, i).touches(ExactPolygon.of(LeafKind.UPRIGHT_BOX, b, j));
    }

    // |p - q| <= h + k
    private static boolean reach(double p, double q, double h, double k) {
        return Dyadic.signOfSum(Math.max(p, q), -Math.min(p, q), -h, -k) <= 0;
    }
}
