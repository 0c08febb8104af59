package robosim.geometry.narrow.cone;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Dyadic;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.exact.VectorMath;

/**
 * A closed cone {@code x.d >= cos |x| |d|} about an axis d from an apex, with the queries that all kernels share; one
 * in each {@link ConeScratch}. The cosine is the stored one; the sine follows from it.
 */
public final class Cone {
    /** Indices of the unit axis, the cosine and the sine in {@link #pairs}. */
    static final int AXIS = 0;

    static final int COS = 3;
    static final int SIN = 4;

    /** The first pair that a kernel may use. */
    static final int FREE = 8;

    final DoubleDoubles pairs = new DoubleDoubles(64);
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;

    /** The unit axis. */
    double ux;

    double uy;
    double uz;
    double cos;
    double sin;

    /** Takes a beam, whose start may be moved to another height. */
    public void set(BeamAxis beam, double y) {
        ox = beam.ox;
        oy = y;
        oz = beam.oz;
        // The next leaf for the same beam, or the next beam of the same sensor.
        if (!(isSame(beam.dx, dx) && isSame(beam.dy, dy) && isSame(beam.dz, dz))) {
            setAxis(beam.dx, beam.dy, beam.dz);
        }
        if (beam.cos != cos) {
            setWidth(beam.cos);
        }
    }

    private void setAxis(double x, double y, double z) {
        dx = x;
        dy = y;
        dz = z;
        DoubleDoubles p = pairs;
        p.set(AXIS, dx);
        p.set(AXIS + 1, dy);
        p.set(AXIS + 2, dz);
        p.dot(5, AXIS, AXIS, 6);
        p.root(5, 5);
        for (int i = 0; i < 3; i++) {
            p.divide(AXIS + i, AXIS + i, 5);
        }
        ux = p.get(AXIS);
        uy = p.get(AXIS + 1);
        uz = p.get(AXIS + 2);
    }

    private void setWidth(double cosine) {
        cos = cosine;
        DoubleDoubles p = pairs;
        p.set(COS, cos);
        p.difference(5, 1, cos);
        p.difference(6, 1, -cos);
        p.multiply(5, 5, 6);
        p.root(SIN, 5);
        sin = p.get(SIN);
    }

    private static boolean isSame(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }

    /**
     * The depth in the cone of a point relative to the apex: {@code x.u - cos |x|}, negative outside. Concave; the
     * depths of two points differ by at most twice their distance.
     */
    public double depth(double x, double y, double z) {
        return x * ux + y * uy + z * uz - cos * VectorMath.length(x, y, z);
    }

    /** Whether a point relative to the apex is in the cone about d; exact. */
    static boolean holds(ExactVector x, ExactVector d, Dyadic squareCos) {
        Dyadic ahead = x.dot(d);
        return ahead.signum() >= 0
                && ahead.square().compareTo(squareCos.multiply(x.square()).multiply(d.square())) >= 0;
    }

    /**
     * Whether a sphere about m, relative to an apex outside it, meets the cone about d; exact.
     *
     * <p>It does if its centre is in the cone. Otherwise, take the direction of the border in the plane of m and d: the
     * centre must be within the radius of it and ahead along it. That is, {@code P = cos |m x d|} is at most {@code Q +
     * R} with {@code Q = sin m.d} and {@code R = r |d|}, and {@code cos m.d + sin |m x d|} is at least 0. Their squares
     * are rational.
     */
    static boolean meetsSphere(ExactVector m, Dyadic radius, ExactVector d, Dyadic squareCos) {
        if (holds(m, d, squareCos)) {
            return true;
        }
        Dyadic squareSin = Dyadic.ONE.subtract(squareCos);
        Dyadic ahead = m.dot(d);
        Dyadic cross = m.cross(d).square();
        Dyadic p = squareCos.multiply(cross);
        Dyadic q = squareSin.multiply(ahead.square());
        Dyadic r = radius.square().multiply(d.square());
        if (ahead.signum() < 0) {
            // P + |Q| <= R
            Dyadic rest = r.subtract(p).subtract(q);
            return squareSin.multiply(cross).compareTo(squareCos.multiply(ahead.square())) >= 0
                    && rest.signum() >= 0
                    && p.multiply(q).scale(2).compareTo(rest.square()) <= 0;
        }
        Dyadic over = p.subtract(q).subtract(r);
        return over.signum() <= 0 || over.square().compareTo(q.multiply(r).scale(2)) <= 0;
    }

    /**
     * Whether the segment from p to q, relative to the apex, meets the cone about d; exact.
     *
     * <p>If both ends are outside, it can only cross the cone. Then along it the quadratic {@code (x.d)^2 - cos^2 x^2
     * d^2} is concave, has its vertex between the ends, is not negative there, and that point is ahead of the apex.
     */
    static boolean touches(ExactVector p, ExactVector q, ExactVector d, Dyadic squareCos) {
        if (holds(p, d, squareCos) || holds(q, d, squareCos)) {
            return true;
        }
        ExactVector e = q.minus(p);
        Dyadic limit = squareCos.multiply(d.square());
        Dyadic start = p.dot(d);
        Dyadic rise = e.dot(d);
        Dyadic bend = rise.square().subtract(limit.multiply(e.square()));
        Dyadic slope = start.multiply(rise).subtract(limit.multiply(p.dot(e)));
        Dyadic constant = start.square().subtract(limit.multiply(p.square()));
        return bend.signum() < 0
                && slope.signum() > 0
                && bend.add(slope).signum() < 0
                && slope.square().compareTo(bend.multiply(constant)) >= 0
                && slope.multiply(rise).compareTo(start.multiply(bend)) >= 0;
    }
}
