package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against an upright octagonal prism: five slabs of x, z, x + z, x - z and y. The verdict is exact. The forms and
 * their slopes are off by one rounding, the ends by two.
 */
final class RayPrism {
    private static final double U = Filter.bound(VectorMath.U);
    private static final StageCounters.Counter EXACT = StageCounters.counter("RayPrism");

    private RayPrism() {}

    static double distance(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        clip(in, b[j], b[j + 1], ox, 0, dx, 0, 0);
        clip(in, b[j + 2], b[j + 3], oz, 0, dz, 0, 1);
        clip(in, b[j + 8], b[j + 9], oy, 0, dy, 0, 4);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clip(in, b[j + 4], b[j + 5], ox, oz, dx, dz, 2);
        clip(in, b[j + 6], b[j + 7], ox, -oz, dx, -dz, 3);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        if (!in.isCertain()) {
            return exact(ox, oy, oz, dx, dy, dz, b, j);
        }
        return in.face < 0 ? 0 : plane(ox, oy, oz, dx, dy, dz, b, j, in.face, in.enter);
    }

    private static void clip(
            RayInterval in, double low, double high, double o1, double o2, double d1, double d2, int id) {
        double offset = o1 + o2;
        double slope = d1 + d2;
        double toLow = low - offset;
        double toHigh = high - offset;
        boolean isExact = DoubleDouble.sumTail(o1, o2, offset) == 0
                && DoubleDouble.differenceTail(low, offset, toLow) == 0
                && DoubleDouble.differenceTail(high, offset, toHigh) == 0;
        double error = isExact ? 0 : U * (2 * Math.abs(offset) + Math.max(Math.abs(low), Math.abs(high))) + UNDERFLOW;
        in.clip(toLow, error, toHigh, error, slope, U * Math.abs(slope), id);
    }

    // Numerator and denominator keep their rounding errors, so the quotient is accurate for any slope.
    private static double plane(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, int face, double t) {
        double o1 = face == 1 ? oz : face == 4 ? oy : ox;
        double o2 = face == 2 ? oz : face == 3 ? -oz : 0;
        double d1 = face == 1 ? dz : face == 4 ? dy : dx;
        double d2 = face == 2 ? dz : face == 3 ? -dz : 0;
        double slope = d1 + d2;
        double slopeTail = DoubleDouble.sumTail(d1, d2, slope);
        double at = b[j + 2 * face + (slope > 0 ? 0 : 1)];
        double offset = o1 + o2;
        double way = at - offset;
        double wayTail = DoubleDouble.differenceTail(at, offset, way) - DoubleDouble.sumTail(o1, o2, offset);
        double rest = Math.fma(-t, slope, way) + (wayTail - t * slopeTail);
        return VectorMath.along(t, rest / slope, dx, dy, dz);
    }

    private static double exact(double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j) {
        EXACT.count();
        double extent = 0;
        for (int i = 0; i < 10; i++) {
            extent = Math.max(extent, Math.abs(b[j + i]));
        }
        ExactRay ray = new ExactRay(ox, oy, oz, dx, dy, dz, extent);
        ExactVector o = ray.start;
        ExactVector d = ray.direction;
        ExactSlabs slabs = new ExactSlabs(ray, 5);
        add(slabs, ray, b, j, o.x(), d.x());
        add(slabs, ray, b, j + 2, o.z(), d.z());
        add(slabs, ray, b, j + 4, o.x().add(o.z()), d.x().add(d.z()));
        add(slabs, ray, b, j + 6, o.x().subtract(o.z()), d.x().subtract(d.z()));
        add(slabs, ray, b, j + 8, o.y(), d.y());
        return slabs.distance();
    }

    private static void add(ExactSlabs slabs, ExactRay ray, double[] b, int at, Dyadic offset, Dyadic slope) {
        slabs.add(ray.length(b[at]), offset, ray.length(b[at + 1]), slope);
    }
}
