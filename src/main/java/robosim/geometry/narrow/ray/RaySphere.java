package robosim.geometry.narrow.ray;

import static robosim.geometry.exact.VectorMath.UNDERFLOW;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * A ray against a solid sphere. The verdict is exact: with m the centre relative to the start, the ray hits where
 * {@code m . d >= 0} and {@code |m x d|^2 <= r^2 |d|^2}.
 */
final class RaySphere {
    private static final double U = FilterBound.bound(VectorMath.U);

    /** Offset 1u for each factor, square 1u, two sums 2u; the squared radius and the difference add 2u. */
    private static final double INSIDE_ERROR = 7 * U;

    /** Offset 1u, product 1u, two sums 2u. */
    private static final double AHEAD_ERROR = 5 * U;

    /** A component of m x d: offset 1u, product 1u, difference 1u. */
    private static final double ASIDE_ERROR = 4 * U;

    private static final StageCounters.Counter EXACT = StageCounters.counter("RaySphere");

    private RaySphere() {}

    static double distance(BeamAxis ray, double[] b, int j, RayScratch s) {
        double mx = b[j] - ray.ox;
        double my = b[j + 1] - ray.oy;
        double mz = b[j + 2] - ray.oz;
        double r = b[j + 3];
        double outside = mx * mx + my * my + mz * mz - r * r;
        double outsideError = INSIDE_ERROR * (mx * mx + my * my + mz * mz + r * r) + UNDERFLOW;
        if (outside < -outsideError) {
            return 0;
        }
        double ahead = mx * ray.dx + my * ray.dy + mz * ray.dz;
        double aheadSize = Math.abs(mx * ray.dx) + Math.abs(my * ray.dy) + Math.abs(mz * ray.dz);
        boolean isOutside = outside > outsideError;
        if (isOutside && ahead < -(AHEAD_ERROR * aheadSize + UNDERFLOW)) {
            return Double.POSITIVE_INFINITY;
        }
        double wx = my * ray.dz - mz * ray.dy;
        double wy = mz * ray.dx - mx * ray.dz;
        double wz = mx * ray.dy - my * ray.dx;
        double px = ASIDE_ERROR * (Math.abs(my * ray.dz) + Math.abs(mz * ray.dy));
        double py = ASIDE_ERROR * (Math.abs(mz * ray.dx) + Math.abs(mx * ray.dz));
        double pz = ASIDE_ERROR * (Math.abs(mx * ray.dy) + Math.abs(my * ray.dx));
        double ww = wx * wx + wy * wy + wz * wz;
        double dd = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
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
            double distance = surface(ray, b, j, (ahead - Math.sqrt(chord)) / dd, s);
            if (distance >= 0) {
                return distance;
            }
        }
        return exact(ray, b, j);
    }

    // One Newton step from near the entry: relative to that point, only the radius can cancel.
    private static double surface(BeamAxis ray, double[] b, int j, double t, RayScratch s) {
        double r = b[j + 3];
        double qx = RayBox.moved(ray.ox, b[j], t, ray.dx);
        double qy = RayBox.moved(ray.oy, b[j + 1], t, ray.dy);
        double qz = RayBox.moved(ray.oz, b[j + 2], t, ray.dz);
        double square = qx * qx + qy * qy + qz * qz;
        double inward = -(qx * ray.dx + qy * ray.dy + qz * ray.dz);
        double inwardError = 5 * U * (Math.abs(qx * ray.dx) + Math.abs(qy * ray.dy) + Math.abs(qz * ray.dz));
        double dd = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        double correction = (square - r * r) / (2 * inward);
        double certain = inward - inwardError;
        // The square is off by 7u (its parts by 2u for each factor), the step by the quadratic term that Newton leaves.
        double error = (5 * U * (square + r * r) + Math.abs(correction) * inwardError + correction * correction * dd)
                / certain;
        double distance = ray.along(t, correction);
        double largest = Math.max(Math.max(ray.largest(), VectorMath.largest(b[j], b[j + 1], b[j + 2])), r);
        double length = Math.sqrt(dd);
        if (certain > 0 && VectorMath.isFine(error * length, distance, largest)) {
            return distance;
        }
        if (!(Math.abs(correction) * dd < 0.25 * certain)) {
            return -1;
        }
        RayRefine refine = s.refine;
        refine.place(ray, b[j], b[j + 1], b[j + 2], t, correction);
        double left = refine.sphere(r);
        double size = 2 * (square + r * r) + 4 * Math.abs(t) * length * r;
        double slope = 2 * (inward - correction * dd);
        return refine.settled(left, size, -slope, 2 * inwardError + 8 * U * inward, dd, largest);
    }

    private static double exact(BeamAxis ray, double[] b, int j) {
        EXACT.count();
        double extent = Math.max(VectorMath.largest(b[j], b[j + 1], b[j + 2]), b[j + 3]);
        ExactRay exact = new ExactRay(ray, extent);
        ExactVector m = exact.point(b, j).minus(exact.start);
        return distance(exact, m, m.square().subtract(exact.length(b[j + 3]).square()));
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
