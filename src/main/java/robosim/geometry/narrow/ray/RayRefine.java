package robosim.geometry.narrow.ray;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

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
    static final double ERROR = FilterBound.bound(0x1p-94);

    private static final double U = FilterBound.bound(VectorMath.U);

    private static final int TIME = 0;
    private static final int TEMPORARY = 1; // uses the next pair too
    private static final int SIDE = 3;
    private static final int PLACE = 4;
    private static final int NORMAL = 7;
    private static final int FIRST = 10;
    private static final int SECOND = 13;
    private static final int OUT = 16;

    private final DoubleDoubles p = new DoubleDoubles(20);
    private BeamAxis ray = new BeamAxis();
    private double time;
    private double tail;

    /** Sets a point of a ray relative to c: {@code o - c + (t + tail) d}. */
    void place(BeamAxis beam, double cx, double cy, double cz, double t, double itsTail) {
        ray = beam;
        time = t;
        tail = itsTail;
        p.difference(TIME, time, -tail);
        p.difference(PLACE, ray.ox, cx);
        p.difference(PLACE + 1, ray.oy, cy);
        p.difference(PLACE + 2, ray.oz, cz);
        p.set(FIRST, ray.dx);
        p.set(FIRST + 1, ray.dy);
        p.set(FIRST + 2, ray.dz);
        p.advance(PLACE, PLACE, TIME, FIRST, TEMPORARY);
    }

    /** The residual of {@code x.(k x l) - half i.(k x l)} for columns i, k, l of a box from that of a face, {@code half} signed. */
    double boxFace(double[] b, int j, int face, double half) {
        int r = j + Leaf.ROTATION;
        column(b, r + (face + 1) % 3, FIRST);
        column(b, r + (face + 2) % 3, SECOND);
        p.cross(NORMAL, FIRST, SECOND, TEMPORARY);
        column(b, r + face, FIRST);
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
    double side(PlacedCylinder c) {
        axis(c);
        p.cross(NORMAL, PLACE, FIRST, TEMPORARY);
        p.dot(OUT, NORMAL, NORMAL, TEMPORARY);
        p.dot(SIDE, FIRST, FIRST, TEMPORARY);
        p.multiply(SIDE, SIDE, c.r);
        p.multiply(SIDE, SIDE, c.r);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /** The residual of {@code x.a - half a.a}, {@code half} signed. */
    double cap(PlacedCylinder c, double half) {
        axis(c);
        p.dot(OUT, PLACE, FIRST, TEMPORARY);
        p.dot(SIDE, FIRST, FIRST, TEMPORARY);
        p.multiply(SIDE, SIDE, half);
        p.subtract(OUT, OUT, SIDE);
        return p.get(OUT);
    }

    /**
     * The distance after a step of {@code -left / slope}, from a residual whose terms have the given size; below 0 where it is
     * not certainly accurate.
     *
     * @param bend half the second derivative, 0 for a plane
     * @param largest the largest coordinate or size
     */
    double settled(double left, double size, double slope, double slopeError, double bend, double largest) {
        double certain = Math.abs(slope) - slopeError;
        if (!(certain > 0)) {
            return -1;
        }
        double step = Math.abs(left) / certain;
        double error = (ERROR * size + step * (slopeError + 2 * U * certain) + step * step * bend) / certain;
        double distance = ray.along(time, tail - left / slope);
        return VectorMath.isFine(error * ray.length(), distance, largest) ? distance : -1;
    }

    private void axis(PlacedCylinder c) {
        p.set(FIRST, c.ax);
        p.set(FIRST + 1, c.ay);
        p.set(FIRST + 2, c.az);
    }

    private void column(double[] b, int at, int out) {
        p.set(out, b[at]);
        p.set(out + 1, b[at + 3]);
        p.set(out + 2, b[at + 6]);
    }
}
