package robosim.geometry.narrow.ray;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.Filter;
import robosim.geometry.exact.VectorMath;

/**
 * The last correction of a ray's parameter in pairs of doubles, for distances that plain doubles leave uncertain: the
 * residual of the surface's equation at a point of the ray, to about 97 bits of its terms.
 */
final class RayRefine {
    /**
     * The error bound of a residual in pairs of doubles, as a share of the sum of its terms' magnitudes: about ten
     * successive steps of 2^-102 to 2^-100, few of which are ever at their worst. A tenth of it changes no distance: it
     * decides only whether one is accurate enough, and there it is about 2^-41 of the ulp in question.
     */
    static final double ERROR = Filter.bound(0x1p-94);

    private static final double U = Filter.bound(VectorMath.U);

    private static final int TIME = 0;
    private static final int TEMPORARY = 1; // uses the next pair too
    private static final int SIDE = 3;
    private static final int PLACE = 4;
    private static final int NORMAL = 7;
    private static final int FIRST = 10;
    private static final int SECOND = 13;
    private static final int OUT = 16;

    private final DoubleDoubles p = new DoubleDoubles(20);

    /** Sets a point of the ray relative to c: {@code o - c + (t + tail) d}. */
    void place(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double cx,
            double cy,
            double cz,
            double t,
            double tail) {
        p.difference(TIME, t, -tail);
        p.difference(PLACE, ox, cx);
        p.difference(PLACE + 1, oy, cy);
        p.difference(PLACE + 2, oz, cz);
        p.set(FIRST, dx);
        p.set(FIRST + 1, dy);
        p.set(FIRST + 2, dz);
        p.advance(PLACE, PLACE, TIME, FIRST, TEMPORARY);
    }

    /** The residual of {@code x.(k x l) - half i.(k x l)} for columns i, k, l of a box, {@code half} signed. */
    double boxFace(double[] b, int i, int k, int l, double half) {
        column(b, k, FIRST);
        column(b, l, SECOND);
        p.cross(NORMAL, FIRST, SECOND, TEMPORARY);
        column(b, i, FIRST);
        p.dot(SIDE, FIRST, NORMAL, TEMPORARY);
        p.multiply(SIDE, SIDE, half);
        p.dot(OUT, PLACE, NORMAL, TEMPORARY);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /** The residual of {@code x.n} for the normal of a triangle whose first corner is the origin of x. */
    double trianglePlane(double[] t, int j) {
        for (int i = 0; i < 3; i++) {
            p.difference(FIRST + i, t[j + 3 + i], t[j + i]);
            p.difference(SECOND + i, t[j + 6 + i], t[j + i]);
        }
        p.cross(NORMAL, FIRST, SECOND, TEMPORARY);
        p.dot(OUT, PLACE, NORMAL, TEMPORARY);
        return p.get(OUT);
    }

    /** The residual of {@code x.x - r^2}. */
    double sphere(double r) {
        p.product(SIDE, r, r);
        p.dot(OUT, PLACE, PLACE, TEMPORARY);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /** The residual of {@code |x x a|^2 - r^2 a.a}. */
    double side(double ax, double ay, double az, double r) {
        axis(ax, ay, az);
        p.cross(NORMAL, PLACE, FIRST, TEMPORARY);
        p.dot(OUT, NORMAL, NORMAL, TEMPORARY);
        p.dot(SIDE, FIRST, FIRST, TEMPORARY);
        p.multiply(SIDE, SIDE, r);
        p.multiply(SIDE, SIDE, r);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /** The residual of {@code x.a - half a.a}, {@code half} signed. */
    double cap(double ax, double ay, double az, double half) {
        axis(ax, ay, az);
        p.dot(OUT, PLACE, FIRST, TEMPORARY);
        p.dot(SIDE, FIRST, FIRST, TEMPORARY);
        p.multiply(SIDE, SIDE, half);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /**
     * The error bound of the parameter after a step of {@code rest / slope}, from a residual whose terms have the given
     * size; {@code bend} is half the second derivative, 0 for a plane.
     */
    static double error(double rest, double size, double slope, double slopeError, double bend) {
        double certain = Math.abs(slope) - slopeError;
        double step = Math.abs(rest) / certain;
        return certain > 0
                ? (ERROR * size + step * (slopeError + 2 * U * certain) + step * step * bend) / certain
                : Double.POSITIVE_INFINITY;
    }

    private void axis(double ax, double ay, double az) {
        p.set(FIRST, ax);
        p.set(FIRST + 1, ay);
        p.set(FIRST + 2, az);
    }

    private void column(double[] b, int at, int out) {
        p.set(out, b[at]);
        p.set(out + 1, b[at + 3]);
        p.set(out + 2, b[at + 6]);
    }
}
