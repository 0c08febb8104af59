package robosim.geometry.narrow.gjk;

import robosim.geometry.exact.DoubleDoubles;

/**
 * Up to four points of a difference set a - b, and the point of least norm of their hull: {@link Simplex} in
 * double-doubles, for simplices so thin, or so near the origin, that doubles are not accurate enough.
 *
 * <p>The points are differences of doubles and known exactly. A double-double operation is off by 2^-100 of its terms,
 * so a side that spans a sine of 2^-50, as rounding makes of points meant to be collinear, still has its direction to
 * some 50 bits and its nearest point to some 50 bits of its size.
 */
final class DoubleDoubleSimplex {
    /** A side this flat (squared sine) is replaced by its edges. */
    private static final double FLAT = 0x1p-180;

    // Indexes of the registers; a vector takes three.
    private static final int POINTS = 0; // four
    private static final int EDGE = 12;
    private static final int OTHER = 15;
    private static final int NORMAL = 18;
    private static final int FOOT = 21;
    private static final int CROSS = 24;
    private static final int WEIGHT = 27; // four
    private static final int FOUND = 31; // four
    private static final int SQUARE = 35;
    private static final int SHARE = 36;
    private static final int SUM = 37;
    private static final int LENGTH = 38;
    private static final int SHORTEST = 39;
    private static final int NORM = 40;
    private static final int TEMPORARY = 41; // and the next
    private static final int NUMBERS = 43;

    /** Direction of the point of least norm; its length has no meaning. */
    double vx;

    double vy;
    double vz;

    private final DoubleDoubles p = new DoubleDoubles(NUMBERS);
    private final double[] pointsA = new double[12];
    private final double[] pointsB = new double[12];
    private final double[] weight = new double[4];
    private int count;
    private boolean any;

    void clear() {
        count = 0;
        p.set(NORM, Double.MAX_VALUE);
    }

    /** Adds the difference of two points found; returns false if it is there already. */
    boolean add(Support a, Support b) {
        int at = POINTS + 3 * count;
        p.difference(at, a.x, b.x);
        p.difference(at + 1, a.y, b.y);
        p.difference(at + 2, a.z, b.z);
        for (int k = 0; k < count; k++) {
            if (isSame(at, POINTS + 3 * k)) {
                return false;
            }
        }
        pointsA[3 * count] = a.x;
        pointsA[3 * count + 1] = a.y;
        pointsA[3 * count + 2] = a.z;
        pointsB[3 * count] = b.x;
        pointsB[3 * count + 1] = b.y;
        pointsB[3 * count + 2] = b.z;
        count++;
        return true;
    }

    private boolean isSame(int u, int v) {
        for (int k = 0; k < 3; k++) {
            if (p.get(u + k) != p.get(v + k) || p.rest(u + k) != p.rest(v + k)) {
                return false;
            }
        }
        return true;
    }

    /** Keeps the part of the simplex that is nearest to the origin; returns false if that is no nearer than before. */
    boolean reduce() {
        int newest = count - 1;
        any = false;
        if (count == 4 && holdsOrigin()) {
            return true;
        }
        corner(newest);
        for (int k = 0; k < newest; k++) {
            edge(k, newest);
        }
        for (int k = 0; k < newest; k++) {
            for (int m = k + 1; m < newest; m++) {
                side(k, m, newest);
            }
        }
        if (!isLess(SHORTEST, NORM)) {
            return false;
        }
        p.set(NORM, p.get(SHORTEST), p.rest(SHORTEST));
        compact();
        return true;
    }

    private boolean isLess(int i, int j) {
        return p.get(i) < p.get(j) || (p.get(i) == p.get(j) && p.rest(i) < p.rest(j));
    }

    /** The distance of the point of least norm from the origin, to within a rounding. */
    double length() {
        return Math.sqrt(p.get(NORM));
    }

    double a(int axis) {
        return mean(pointsA, axis);
    }

    double b(int axis) {
        return mean(pointsB, axis);
    }

    private double mean(double[] points, int axis) {
        double sum = 0;
        for (int k = 0; k < count; k++) {
            sum += weight[k] * points[3 * k + axis];
        }
        return sum;
    }

    private void corner(int c) {
        clearWeights();
        p.set(WEIGHT + c, 1);
        if (offer()) {
            read();
        }
    }

    private void edge(int c, int d) {
        p.subtractVector(EDGE, POINTS + 3 * d, POINTS + 3 * c);
        p.dot(SQUARE, EDGE, EDGE, TEMPORARY);
        p.dot(SHARE, POINTS + 3 * c, EDGE, TEMPORARY);
        p.negate(SHARE);
        // Strictly between its ends.
        p.subtract(SUM, SQUARE, SHARE);
        if (!(p.get(SHARE) > 0 && p.get(SUM) > 0)) {
            return;
        }
        clearWeights();
        p.divide(WEIGHT + d, SHARE, SQUARE);
        p.divide(WEIGHT + c, SUM, SQUARE);
        if (offer()) {
            read();
        }
    }

    private void side(int c, int d, int e) {
        int corner = POINTS + 3 * c;
        p.subtractVector(EDGE, POINTS + 3 * d, corner);
        p.subtractVector(OTHER, POINTS + 3 * e, corner);
        p.cross(NORMAL, EDGE, OTHER, TEMPORARY);
        p.dot(SQUARE, NORMAL, NORMAL, TEMPORARY);
        if (!(p.get(SQUARE) > FLAT * square(EDGE) * square(OTHER))) {
            return;
        }
        // The weights are w.n / n.n with w the area that the origin spans with an edge, seen along n.
        clearWeights();
        area(WEIGHT + c, POINTS + 3 * d, POINTS + 3 * e);
        area(WEIGHT + d, POINTS + 3 * e, corner);
        area(WEIGHT + e, corner, POINTS + 3 * d);
        if (!(p.get(WEIGHT + c) > 0 && p.get(WEIGHT + d) > 0 && p.get(WEIGHT + e) > 0)) {
            return;
        }
        normalize();
        p.dot(SHARE, corner, NORMAL, TEMPORARY);
        double sign = p.get(SHARE) < 0 ? -1 : 1;
        if (offer()) {
            vx = sign * p.get(NORMAL);
            vy = sign * p.get(NORMAL + 1);
            vz = sign * p.get(NORMAL + 2);
        }
    }

    private double square(int vector) {
        double x = p.get(vector);
        double y = p.get(vector + 1);
        double z = p.get(vector + 2);
        return x * x + y * y + z * z;
    }

    private void area(int i, int from, int to) {
        p.cross(CROSS, from, to, TEMPORARY);
        p.dot(i, CROSS, NORMAL, TEMPORARY);
    }

    /** Normalizes the weights to a sum of 1. */
    private void normalize() {
        p.set(SUM, 0);
        for (int k = 0; k < 4; k++) {
            p.add(SUM, SUM, WEIGHT + k);
        }
        for (int k = 0; k < 4; k++) {
            p.divide(WEIGHT + k, WEIGHT + k, SUM);
        }
    }

    private void clearWeights() {
        for (int k = 0; k < 4; k++) {
            p.set(WEIGHT + k, 0);
        }
    }

    /** Adopts a part of the simplex if its nearest point is the nearest so far. */
    private boolean offer() {
        foot();
        p.dot(LENGTH, FOOT, FOOT, TEMPORARY);
        if (any && !isLess(LENGTH, SHORTEST)) {
            return false;
        }
        any = true;
        p.set(SHORTEST, p.get(LENGTH), p.rest(LENGTH));
        for (int k = 0; k < 4; k++) {
            p.set(FOUND + k, p.get(WEIGHT + k), p.rest(WEIGHT + k));
        }
        return true;
    }

    private void foot() {
        for (int axis = 0; axis < 3; axis++) {
            p.set(FOOT + axis, 0);
        }
        for (int k = 0; k < count; k++) {
            p.advance(FOOT, FOOT, WEIGHT + k, POINTS + 3 * k, TEMPORARY);
        }
    }

    private void read() {
        vx = p.get(FOOT);
        vy = p.get(FOOT + 1);
        vz = p.get(FOOT + 2);
    }

    /** Removes the points that have no weight. */
    private void compact() {
        int left = 0;
        for (int k = 0; k < count; k++) {
            if (p.get(FOUND + k) > 0) {
                for (int axis = 0; axis < 3; axis++) {
                    int from = POINTS + 3 * k + axis;
                    p.set(POINTS + 3 * left + axis, p.get(from), p.rest(from));
                    pointsA[3 * left + axis] = pointsA[3 * k + axis];
                    pointsB[3 * left + axis] = pointsB[3 * k + axis];
                }
                weight[left] = p.get(FOUND + k);
                left++;
            }
        }
        count = left;
    }

    /** Whether the origin is in the tetrahedron; the norm is then that of the point given by the weights. */
    private boolean holdsOrigin() {
        volume(WEIGHT, 1, 2, 3);
        volume(WEIGHT + 1, 0, 3, 2);
        volume(WEIGHT + 2, 0, 1, 3);
        volume(WEIGHT + 3, 0, 2, 1);
        int positive = 0;
        int negative = 0;
        for (int k = 0; k < 4; k++) {
            positive += p.get(WEIGHT + k) > 0 ? 1 : 0;
            negative += p.get(WEIGHT + k) < 0 ? 1 : 0;
        }
        if (positive != 4 && negative != 4) {
            return false;
        }
        normalize();
        offer();
        p.set(NORM, p.get(SHORTEST), p.rest(SHORTEST));
        compact();
        return true;
    }

    private void volume(int i, int c, int d, int e) {
        p.cross(CROSS, POINTS + 3 * d, POINTS + 3 * e, TEMPORARY);
        p.dot(i, POINTS + 3 * c, CROSS, TEMPORARY);
    }
}
