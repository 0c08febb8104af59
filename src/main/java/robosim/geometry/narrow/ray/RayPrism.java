package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against an upright octagonal prism: five slabs of x, z, x + z, x - z and y, of which the plane has four. The verdict is exact. The forms and
 * their slopes are off by one rounding, the ends by two.
 */
final class RayPrism {
    private static final double U = FilterBound.bound(VectorMath.U);
    private static final StageCounters.Counter EXACT = StageCounters.counter("RayPrism");

    private RayPrism() {}

    /** In space. */
    static double distance(BeamAxis ray, double[] b, int j, RayScratch s) {
        return distance(ray, b, j, 5, s);
    }

    /** Against the octagon seen from above, of a level ray. */
    static double flatDistance(BeamAxis ray, double[] b, int j, RayScratch s) {
        return distance(ray, b, j, 4, s);
    }

    private static double distance(BeamAxis ray, double[] b, int j, int slabs, RayScratch s) {
        RayInterval in = s.interval;
        in.reset();
        clip(in, ray, b, j, 0);
        clip(in, ray, b, j, 1);
        if (slabs > 4) {
            clip(in, ray, b, j, 4);
        }
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        clip(in, ray, b, j, 2);
        clip(in, ray, b, j, 3);
        if (in.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        if (!in.isCertain()) {
            return exact(ray, b, j, slabs);
        }
        return in.face < 0 ? 0 : plane(ray, b, j, in.face, in.enter);
    }

    /** The form of a slab is the sum of two coordinates, of which this is the first. */
    private static double one(int face, double x, double y, double z) {
        return face == 1 ? z : face == 4 ? y : x;
    }

    private static double other(int face, double z) {
        return face == 2 ? z : face == 3 ? -z : 0;
    }

    private static void clip(RayInterval in, BeamAxis ray, double[] b, int j, int face) {
        double o1 = one(face, ray.ox, ray.oy, ray.oz);
        double o2 = other(face, ray.oz);
        double low = b[j + 2 * face];
        double high = b[j + 2 * face + 1];
        double offset = o1 + o2;
        double slope = one(face, ray.dx, ray.dy, ray.dz) + other(face, ray.dz);
        double toLow = low - offset;
        double toHigh = high - offset;
        boolean isExact = DoubleDouble.sumTail(o1, o2, offset) == 0
                && DoubleDouble.differenceTail(low, offset, toLow) == 0
                && DoubleDouble.differenceTail(high, offset, toHigh) == 0;
        double error = isExact ? 0 : U * (2 * Math.abs(offset) + Math.max(Math.abs(low), Math.abs(high))) + UNDERFLOW;
        in.clip(toLow, error, toHigh, error, slope, U * Math.abs(slope), face);
    }

    // Numerator and denominator keep their rounding errors, so the quotient is accurate for any slope.
    private static double plane(BeamAxis ray, double[] b, int j, int face, double t) {
        double o1 = one(face, ray.ox, ray.oy, ray.oz);
        double o2 = other(face, ray.oz);
        double d1 = one(face, ray.dx, ray.dy, ray.dz);
        double d2 = other(face, ray.dz);
        double slope = d1 + d2;
        double slopeTail = DoubleDouble.sumTail(d1, d2, slope);
        double at = b[j + 2 * face + (slope > 0 ? 0 : 1)];
        double offset = o1 + o2;
        double way = at - offset;
        double wayTail = DoubleDouble.differenceTail(at, offset, way) - DoubleDouble.sumTail(o1, o2, offset);
        double rest = Math.fma(-t, slope, way) + (wayTail - t * slopeTail);
        return ray.along(t, rest / slope);
    }

    private static double exact(BeamAxis ray, double[] b, int j, int count) {
        EXACT.count();
        double extent = 0;
        for (int i = 0; i < 2 * count; i++) {
            extent = Math.max(extent, Math.abs(b[j + i]));
        }
        ExactRay exact = new ExactRay(ray, extent);
        ExactVector o = exact.start;
        ExactVector d = exact.direction;
        ExactSlabs slabs = new ExactSlabs(exact, count);
        add(slabs, exact, b, j, o.x(), d.x());
        add(slabs, exact, b, j + 2, o.z(), d.z());
        add(slabs, exact, b, j + 4, o.x().add(o.z()), d.x().add(d.z()));
        add(slabs, exact, b, j + 6, o.x().subtract(o.z()), d.x().subtract(d.z()));
        if (count > 4) {
            add(slabs, exact, b, j + 8, o.y(), d.y());
        }
        return slabs.distance();
    }

    private static void add(ExactSlabs slabs, ExactRay ray, double[] b, int at, Dyadic offset, Dyadic slope) {
        slabs.add(ray.length(b[at]), offset, ray.length(b[at + 1]), slope);
    }
}
