package robosim.geometry.narrow.ray;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;

/**
 * A ray against a solid cylinder in exact arithmetic. The ray crosses the caps at fractions and the side at the roots
 * of a quadratic; the two are compared by squaring.
 */
final class ExactRayCylinder {
    private final ExactRay ray;

    /** {@code square t^2 + 2 half t + constant <= 0} inside the infinite cylinder. */
    private final Dyadic square;

    private final Dyadic half;
    private final Dyadic constant;
    private final Dyadic discriminant;

    /** Between the caps from {@code near / slope} to {@code far / slope}; with a slope of 0, everywhere or nowhere. */
    private final Dyadic near;

    private final Dyadic far;
    private final Dyadic slope;

    ExactRayCylinder(ExactRay ray, PlacedCylinder c) {
        this.ray = ray;
        ExactVector axis = ExactVector.of(c.ax, c.ay, c.az);
        ExactVector m = ray.start.minus(ray.point(c.cx, c.cy, c.cz));
        ExactVector p = ray.direction.cross(axis);
        ExactVector w = m.cross(axis);
        Dyadic limit = ray.length(c.r).square().multiply(axis.square());
        square = p.square();
        half = p.dot(w);
        constant = w.square().subtract(limit);
        discriminant = half.square().subtract(square.multiply(constant));
        Dyadic height = ray.length(c.h).multiply(axis.square());
        Dyadic offset = m.dot(axis);
        Dyadic rise = ray.direction.dot(axis);
        boolean isUp = rise.signum() >= 0;
        near = isUp ? height.negate().subtract(offset) : offset.subtract(height);
        far = isUp ? height.subtract(offset) : offset.add(height);
        slope = rise.abs();
    }

    double distance() {
        boolean isBetween = slope.signum() == 0 ? near.signum() <= 0 && far.signum() >= 0 : far.signum() >= 0;
        if (!isBetween) {
            return Double.POSITIVE_INFINITY;
        }
        if (square.signum() == 0) {
            return constant.signum() > 0 ? Double.POSITIVE_INFINITY : cap();
        }
        if (discriminant.signum() < 0 || !isBeforeExit(Dyadic.ZERO, Dyadic.ONE)) {
            return Double.POSITIVE_INFINITY;
        }
        if (slope.signum() != 0 && (!isAfterEntry(far, slope) || !isBeforeExit(near, slope))) {
            return Double.POSITIVE_INFINITY;
        }
        if (slope.signum() != 0 && near.signum() > 0 && isAfterEntry(near, slope)) {
            return cap();
        }
        return constant.signum() <= 0 ? 0 : ray.distance(constant, half.negate(), discriminant);
    }

    private double cap() {
        return slope.signum() == 0 || near.signum() <= 0 ? 0 : ray.distance(near, slope);
    }

    /** Whether {@code n / d} is at or after the smaller root. */
    private boolean isAfterEntry(Dyadic n, Dyadic d) {
        Dyadic past = square.multiply(n).add(half.multiply(d));
        return past.signum() >= 0 || past.square().compareTo(d.square().multiply(discriminant)) <= 0;
    }

    /** Whether {@code n / d} is at or before the larger root. */
    private boolean isBeforeExit(Dyadic n, Dyadic d) {
        Dyadic past = square.multiply(n).add(half.multiply(d));
        return past.signum() <= 0 || past.square().compareTo(d.square().multiply(discriminant)) <= 0;
    }
}
