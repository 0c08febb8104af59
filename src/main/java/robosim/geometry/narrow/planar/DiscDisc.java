package robosim.geometry.narrow.planar;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/** Two discs in the plane. */
public final class DiscDisc {
    // The differences and the sum of the radii are each rounded once, which counts twice in their squares. The squares
    // are rounded once, the sum of squares once more. So each side is off by 4 roundings of 2^-53; the comparison adds
    // one.
    private static final double FILTER = FilterBound.bound(5.01 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    // With u = 2^-53 and M the sum of the three squares: the tails added to the difference of squares are at most 5u M
    // (sum u, difference u, squares u, coordinates 2u), so five additions lose 25u^2 M. The terms from the coordinates'
    // tails are off by 6u^2 M, and the omitted squares of these tails are u^2 M. The last addition preserves the sign.
    private static final double FINE = FilterBound.bound(33 * 0x1p-106);

    private static final StageCounters.Counter FINER = StageCounters.counter("DiscDisc fine");
    private static final StageCounters.Counter EXACT = StageCounters.counter("DiscDisc");

    private DiscDisc() {}

    /** Whether they touch or overlap; exact. */
    public static boolean touch(double ax, double az, double ar, double bx, double bz, double br) {
        double dx = ax - bx;
        double dz = az - bz;
        double r = ar + br;
        double apart = dx * dx + dz * dz;
        double near = r * r;
        double doubt = FILTER * (apart + near) + UNDERFLOW;
        if (apart > near + doubt) {
            return false;
        }
        if (apart < near - doubt) {
            return true;
        }
        FINER.count();
        double gap = squareGap(ax, az, bx, bz, ar, br);
        double fineDoubt = FINE * (apart + near) + UNDERFLOW;
        return gap < -fineDoubt || (!(gap > fineDoubt) && exactTouch(ax, az, ar, bx, bz, br));
    }

    private static boolean exactTouch(double ax, double az, double ar, double bx, double bz, double br) {
        EXACT.count();
        Dyadic dx = Dyadic.difference(ax, bx);
        Dyadic dz = Dyadic.difference(az, bz);
        Dyadic r = Dyadic.of(ar).add(Dyadic.of(br));
        return dx.square().add(dz.square()).compareTo(r.square()) <= 0;
    }

    /** The distance; 0 in contact. */
    public static double distance(double ax, double az, double ar, double bx, double bz, double br) {
        if (touch(ax, az, ar, bx, bz, br)) {
            return 0;
        }
        double dx = ax - bx;
        double dz = az - bz;
        double r = ar + br;
        if (Math.abs(dx) + Math.abs(dz) < VectorMath.TINY) { // otherwise the squares would underflow
            double k = VectorMath.ENLARGED;
            return distance(ax * k, az * k, ar * k, bx * k, bz * k, br * k) / k;
        }
        // (d - r)(d + r), with the tails of the differences and squares: accurate to an ulp even for two large circles
        // that nearly touch.
        double apart = Math.sqrt(dx * dx + dz * dz);
        return Math.max(0, squareGap(ax, az, bx, bz, ar, br) / (apart + r));
    }

    /** {@code |a - b|^2 - (ar + br)^2}, within an ulp or two even under cancellation. */
    public static double squareGap(double ax, double az, double bx, double bz, double ar, double br) {
        double dx = ax - bx;
        double dxTail = DoubleDouble.differenceTail(ax, bx, dx);
        double dz = az - bz;
        double dzTail = DoubleDouble.differenceTail(az, bz, dz);
        double r = ar + br;
        double rTail = DoubleDouble.sumTail(ar, br, r);
        double xx = dx * dx;
        double zz = dz * dz;
        double rr = r * r;
        double sum = xx + zz;
        double gap = sum - rr;
        double tail = DoubleDouble.sumTail(xx, zz, sum)
                + DoubleDouble.differenceTail(sum, rr, gap)
                + DoubleDouble.productTail(dx, dx, xx)
                + DoubleDouble.productTail(dz, dz, zz)
                - DoubleDouble.productTail(r, r, rr)
                + 2 * (dx * dxTail + dz * dzTail - r * rTail);
        return gap + tail;
    }
}
