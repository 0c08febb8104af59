package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.planar.DiscDisc;

/** A ray and a disc in the plane. */
public final class RayDisc {
    // In u = 2^-53. The square of the offset, already rounded once, is off by 4u of itself, the squared radius by 1u.
    private static final double START = FilterBound.bound(4.01 * 0x1p-53);

    // A product of the offset and the direction: offset 1u, product 1u, sum 1u.
    private static final double PRODUCT = FilterBound.bound(3.01 * 0x1p-53);

    // r^2 |u|^2: squares 1u each, sum 1u, product 1u. On the other side: subtracting the bound 1u, twice, and squaring;
    // and 1u for adding this bound.
    private static final double REACH = FilterBound.bound(8.01 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RayDisc");

    private RayDisc() {}

    /** Distance in world units; whether it hits is exact. */
    public static double distance(BeamAxis ray, double cx, double cz, double r) {
        double mx = cx - ray.ox;
        double mz = cz - ray.oz;
        double square = mx * mx + mz * mz;
        double rr = r * r;
        double doubt = START * (square + rr) + UNDERFLOW;
        if (square < rr - doubt || (!(square > rr + doubt) && DiscDisc.touch(ray.ox, ray.oz, 0, cx, cz, r))) {
            return 0;
        }
        // The start is outside, so a line that hits the disc does so on one side of the start.
        double ahead = mx * ray.dx + mz * ray.dz;
        double aheadSlack = PRODUCT * (Math.abs(mx * ray.dx) + Math.abs(mz * ray.dz)) + UNDERFLOW;
        if (ahead < -aheadSlack) {
            return Double.POSITIVE_INFINITY;
        }
        double length = ray.dx * ray.dx + ray.dz * ray.dz;
        double aside = Math.abs(ray.dx * mz - ray.dz * mx);
        double slack = PRODUCT * (Math.abs(ray.dx * mz) + Math.abs(ray.dz * mx)) + UNDERFLOW;
        double least = atLeastZero(aside - slack);
        double reach = rr * length;
        if (least * least > reach + (REACH * reach + UNDERFLOW)) {
            return Double.POSITIVE_INFINITY;
        }
        double most = aside + slack;
        if (!(most * most < reach - (REACH * reach + UNDERFLOW) && ahead > aheadSlack) && !exactHit(ray, cx, cz, r)) {
            return Double.POSITIVE_INFINITY;
        }
        return entry(ray, cx, cz, r);
    }

    // From outside; a tangent counts as a hit.
    private static boolean exactHit(BeamAxis ray, double cx, double cz, double r) {
        EXACT.count();
        Dyadic mx = Dyadic.difference(cx, ray.ox);
        Dyadic mz = Dyadic.difference(cz, ray.oz);
        Dyadic dx = Dyadic.of(ray.dx);
        Dyadic dz = Dyadic.of(ray.dz);
        if (mx.multiply(dx).add(mz.multiply(dz)).signum() < 0) {
            return false;
        }
        Dyadic aside = dx.multiply(mz).subtract(dz.multiply(mx));
        Dyadic reach = Dyadic.of(r).square().multiply(dx.square().add(dz.square()));
        return aside.square().compareTo(reach) <= 0;
    }

    /**
     * Where a ray that is known to hit from outside enters.
     *
     * <p>Uses (m m - r r) / (ahead + half chord) instead of the textbook difference of the two. The power of the start
     * and the half chord include their tails, so that a disc grazed from afar is as accurate as a near one.
     */
    static double entry(BeamAxis ray, double cx, double cz, double r) {
        double power = atLeastZero(DiscDisc.squareGap(ray.ox, ray.oz, cx, cz, r, 0));
        double mx = cx - ray.ox;
        double mxTail = DoubleDouble.differenceTail(cx, ray.ox, mx);
        double mz = cz - ray.oz;
        double mzTail = DoubleDouble.differenceTail(cz, ray.oz, mz);
        double length = Math.sqrt(ray.dx * ray.dx + ray.dz * ray.dz);
        double ahead = atLeastZero((mx * ray.dx + mz * ray.dz) / length);
        double p = ray.dx * mz;
        double q = ray.dz * mx;
        double aside = p - q;
        double asideTail = DoubleDouble.differenceTail(p, q, aside)
                + DoubleDouble.productTail(ray.dx, mz, p)
                - DoubleDouble.productTail(ray.dz, mx, q)
                + (ray.dx * mzTail - ray.dz * mxTail);
        double chord = halfChordSquare(aside, asideTail, ray.dx, ray.dz, r) / (length * length);
        double way = ahead + Math.sqrt(atLeastZero(chord));
        return way > 0 ? power / way : 0;
    }

    /** For numbers that are rarely negative: branch prediction makes this faster than {@code Math.max}. */
    private static double atLeastZero(double number) {
        return number > 0 ? number : 0;
    }

    // r^2 |u|^2 - aside^2 as (r |u| - |aside|)(r |u| + |aside|), with the direction's length in twice the precision.
    private static double halfChordSquare(double aside, double asideTail, double ux, double uz, double r) {
        double xx = ux * ux;
        double zz = uz * uz;
        double square = xx + zz;
        double squareTail = DoubleDouble.sumTail(xx, zz, square)
                + DoubleDouble.productTail(ux, ux, xx)
                + DoubleDouble.productTail(uz, uz, zz);
        double length = Math.sqrt(square);
        double root = length * length;
        double lengthTail =
                ((square - root) - DoubleDouble.productTail(length, length, root) + squareTail) / (2 * length);
        double reach = r * length;
        double reachTail = DoubleDouble.productTail(r, length, reach) + r * lengthTail;
        double side = Math.abs(aside);
        double sideTail = VectorMath.signed(asideTail, aside + 0.0);
        double rest = reach - side;
        rest += DoubleDouble.differenceTail(reach, side, rest) + (reachTail - sideTail);
        return rest * (reach + side);
    }
}
