package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against a solid sphere. The verdict is exact: with m the centre relative to the start, the ray hits where
 * {@code m . d >= 0} and {@code |m x d|^2 <= r^2 |d|^2}.
 */
final class RaySphere {
    private static final double U = Filter.bound(VectorMath.U);

    /** Offset 1u for each factor, square 1u, two sums 2u; the squared radius and the difference add 2u. */
    private static final double INSIDE_ERROR = 7 * U;

    /** Offset 1u, product 1u, two sums 2u. */
    private static final double AHEAD_ERROR = 5 * U;

    /** A component of m x d: offset 1u, product 1u, difference 1u. */
    private static final double ASIDE_ERROR = 4 * U;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RaySphere");

    private RaySphere() {}

    static double distance(
            double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j, RayScratch s) {
        double mx = b[j] - ox;
        double my = b[j + 1] - oy;
        double mz = b[j + 2] - oz;
        double r = b[j + 3];
        double outside = mx * mx + my * my + mz * mz - r * r;
        double outsideError = INSIDE_ERROR * (mx * mx + my * my + mz * mz + r * r) + UNDERFLOW;
        if (outside < -outsideError) {
            return 0;
        }
        double ahead = mx * dx + my * dy + mz * dz;
        double aheadSize = Math.abs(mx * dx) + Math.abs(my * dy) + Math.abs(mz * dz);
        boolean isOutside = outside > outsideError;
        if (isOutside && ahead < -(AHEAD_ERROR * aheadSize + UNDERFLOW)) {
            return Double.POSITIVE_INFINITY;
        }
        double wx = my * dz - mz * dy;
        double wy = mz * dx - mx * dz;
        double wz = mx * dy - my * dx;
        double px = ASIDE_ERROR * (Math.abs(my * dz) + Math.abs(mz * dy));
        double py = ASIDE_ERROR * (Math.abs(mz * dx) + Math.abs(mx * dz));
        double pz = ASIDE_ERROR * (Math.abs(mx * dy) + Math.abs(my * dx));
        double ww = wx * wx + wy * wy + wz * wz;
        double dd = dx * dx + dy * dy + dz * dz;
        double chord = r * r * dd - ww;
        double chordError = px * (2 * Math.abs(wx) + px)
                + py * (2 * Math.abs(wy) + py)
                + pz * (2 * Math.abs(wz) + pz)
                + 6 * U * (r * r * dd + ww)
                + UNDERFLOW;
        if (chord < -chordError) {
            return Double.POSITIVE_INFINITY;
        }
        if (isOutside && chord > chordError && ahead > AHEAD_ERROR * aheadSize + UNDERFLOW) {
            double distance = surface(ox, oy, oz, dx, dy, dz, b, j, (ahead - Math.sqrt(chord)) / dd, s);
            if (distance >= 0) {
                return distance;
            }
        }
        return exact(ox, oy, oz, dx, dy, dz, b, j);
    }

    // One Newton step from near the entry: relative to that point, only the radius can cancel.
    private static double surface(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double[] b,
            int j,
            double t,
            RayScratch s) {
        double r = b[j + 3];
        double qx = RayBox.moved(ox, b[j], t, dx);
        double qy = RayBox.moved(oy, b[j + 1], t, dy);
        double qz = RayBox.moved(oz, b[j + 2], t, dz);
        double square = qx * qx + qy * qy + qz * qz;
        double inward = -(qx * dx + qy * dy + qz * dz);
        double inwardError = 5 * U * (Math.abs(qx * dx) + Math.abs(qy * dy) + Math.abs(qz * dz));
        double dd = dx * dx + dy * dy + dz * dz;
        double correction = (square - r * r) / (2 * inward);
        double certain = inward - inwardError;
        // The square is off by 7u (its parts by 2u for each factor), the step by the quadratic term that Newton leaves.
        double error = (5 * U * (square + r * r) + Math.abs(correction) * inwardError + correction * correction * dd)
                / certain;
        double distance = VectorMath.along(t, correction, dx, dy, dz);
        double largest =
                Math.max(Math.max(VectorMath.largest(ox, oy, oz), VectorMath.largest(b[j], b[j + 1], b[j + 2])), r);
        double length = Math.sqrt(dd);
        if (certain > 0 && VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        if (!(Math.abs(correction) * dd < 0.25 * certain)) {
            return -1;
        }
        RayRefine refine = s.refine;
        refine.place(ox, oy, oz, dx, dy, dz, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.sphere(r);
        double size = 2 * (square + r * r) + 4 * Math.abs(t) * length * r;
        double slope = 2 * (inward - correction * dd);
        error = RayRefine.error(left, size, slope, 2 * inwardError + 8 * U * inward, dd);
        distance = VectorMath.along(t, correction + left / slope, dx, dy, dz);
        return VectorMath.isFine(error * length, distance, largest) ? distance : -1;
    }

    private static double exact(double ox, double oy, double oz, double dx, double dy, double dz, double[] b, int j) {
        EXACT.count();
        double extent = Math.max(VectorMath.largest(b[j], b[j + 1], b[j + 2]), b[j + 3]);
        ExactRay ray = new ExactRay(ox, oy, oz, dx, dy, dz, extent);
        ExactVector m = ray.point(b, j).minus(ray.start);
        return distance(ray, m, m.square().subtract(ray.length(b[j + 3]).square()));
    }

    /**
     * The distance to a sphere whose centre is at m from the start of an exact ray; the start is outside, and {@code
     * outside} is its power.
     */
    static double distance(ExactRay ray, ExactVector m, Dyadic outside) {
        if (outside.signum() <= 0) {
            return 0;
        }
        Dyadic ahead = m.dot(ray.direction);
        Dyadic chord = ahead.square().subtract(ray.direction.square().multiply(outside));
        return ahead.signum() <= 0 || chord.signum() < 0
                ? Double.POSITIVE_INFINITY
                : ray.distance(outside, ahead, chord);
    }
}
