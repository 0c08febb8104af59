package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.VectorMath;

/**
 * A ray in exact arithmetic, for cases that a kernel's filter leaves in doubt. Distances are rounded once, at the end.
 *
 * <p>All coordinates are first scaled by one power of two, so that nothing overflows or underflows when an exact result
 * becomes a pair of doubles.
 */
public final class ExactRay {
    private final int power;
    private final double dx;
    private final double dy;
    private final double dz;
    public final ExactVector start;
    public final ExactVector direction;

    /** A ray for objects no larger, and no farther from the origin, than {@code extent}. */
    public ExactRay(double ox, double oy, double oz, double dx, double dy, double dz, double extent) {
        double size = Math.max(extent, VectorMath.largest(ox, oy, oz));
        power = size == 0 ? 0 : -Math.getExponent(size);
        this.dx = dx;
        this.dy = dy;
        this.dz = dz;
        start = ExactVector.of(ox, oy, oz).scale(power);
        direction = ExactVector.of(dx, dy, dz);
    }

    /** The same along a beam. */
    ExactRay(BeamAxis ray, double extent) {
        this(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, extent);
    }

    /** A coordinate or a size in this ray's scale. */
    public Dyadic length(double value) {
        return Dyadic.of(value).scale(power);
    }

    /** The nearest double to a length in world units, given in this ray's scale. */
    public double unscaled(Dyadic length) {
        return length.scale(-power).doubleValue();
    }

    /** A point in this ray's scale: the three numbers from {@code at} on. */
    public ExactVector point(double[] row, int at) {
        return ExactVector.of(row, at, 1).scale(power);
    }

    /** A point in this ray's scale. */
    ExactVector point(double x, double y, double z) {
        return ExactVector.of(x, y, z).scale(power);
    }

    /** The distance in world units to {@code n / d} along the ray, both positive. */
    double distance(Dyadic n, Dyadic d) {
        int up = exponent(n);
        int down = exponent(d);
        double[] pair = new double[6];
        pair(n.scale(-up), pair, 0);
        pair(d.scale(-down), pair, 2);
        DoubleDouble.divide(pair[0], pair[1], pair[2], pair[3], pair, 4);
        return along(pair[4], pair[5], up - down);
    }

    /** The distance in world units to {@code c / (b + sqrt(square))} along the ray; all at least 0 and c positive. */
    double distance(Dyadic c, Dyadic b, Dyadic square) {
        int unit = Math.max(exponent(b), Math.floorDiv(exponent(square), 2) + 1);
        double[] pair = new double[8];
        pair(square.scale(-2 * unit), pair, 0);
        DoubleDouble.sqrt(pair[0], pair[1], pair, 0);
        pair(b.scale(-unit), pair, 2);
        DoubleDouble.add(pair[0], pair[1], pair[2], pair[3], pair, 0);
        int up = exponent(c);
        pair(c.scale(-up), pair, 4);
        DoubleDouble.divide(pair[4], pair[5], pair[0], pair[1], pair, 6);
        return along(pair[6], pair[7], up - unit);
    }

    private double along(double t, double tail, int scale) {
        int exponent = scale - power;
        if (Math.abs(exponent) < 400) {
            return VectorMath.along(Math.scalb(t, exponent), Math.scalb(tail, exponent), dx, dy, dz);
        }
        return Math.scalb(VectorMath.along(t, tail, dx, dy, dz), exponent);
    }

    private static void pair(Dyadic value, double[] out, int at) {
        double hi = value.doubleValue();
        out[at] = hi;
        out[at + 1] = value.subtract(Dyadic.of(hi)).doubleValue();
    }

    /** The approximate binary logarithm of a value; for 0, far below all others. */
    private static int exponent(Dyadic value) {
        if (value.signum() == 0) {
            return -100_000;
        }
        int shift = 0;
        double image = value.doubleValue();
        while (Math.abs(image) < 0x1p-900) {
            shift += 900;
            image = value.scale(shift).doubleValue();
        }
        while (Double.isInfinite(image)) {
            shift -= 900;
            image = value.scale(shift).doubleValue();
        }
        return Math.getExponent(image) - shift;
    }
}
