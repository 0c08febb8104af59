package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubleSum;

/**
 * The time at which a translated sphere, or a disc in the plane, hits a corner, an edge or a face: in double-doubles,
 * rounded down. Everything is relative to the sphere's centre at the start; the feature lies outside the sphere and is
 * known to be hit.
 *
 * <p>A coordinate is off by 2^-102 of the magnitudes that it is made of, a product by 2^-100 and a sum by 2^-104: 2^-92,
 * named {@link #SHARE}, of the sums of magnitudes covers all that is made of up to six such. What is lost to underflow is
 * below 2^-1074 times six factors below 2^102 at most, and covered by {@link #LOST}.
 */
final class DoubleDoubleBall {
    static final double SHARE = 0x1p-92;
    static final double LOST = 0x1p-460;

    /** Below this, sizes and motions go to the exact arithmetic. */
    private static final double MINUTE = 0x1p-100;

    /** The corner, or a point on the edge or face. */
    final DoubleDoubleSum[] point = DoubleDoubleSum.array(3);

    /** The edge's direction or the face's normal. */
    final DoubleDoubleSum[] along = DoubleDoubleSum.array(3);

    final DoubleDoubleSum radius = new DoubleDoubleSum();

    /** At least the sum of the magnitudes that the point's coordinates are made of. */
    double size;

    /** The same of {@link #along}. */
    double alongSize;

    private final DoubleDoubleSum[] crossed = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum[] way = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum beyond = new DoubleDoubleSum();
    private final DoubleDoubleSum ahead = new DoubleDoubleSum();
    private final DoubleDoubleSum square = new DoubleDoubleSum();
    private final DoubleDoubleSum chord = new DoubleDoubleSum();
    private final DoubleDoubleSum aside = new DoubleDoubleSum();
    private final DoubleDoubleSum work = new DoubleDoubleSum();
    private final double[] root = new double[2];

    private double dx;
    private double dy;
    private double dz;
    private double span;

    /** The ball; its radius is the sum of two. */
    void move(double r, double more, double x, double y, double z) {
        radius.clear();
        radius.add(r, 0);
        radius.add(more, 0);
        dx = x;
        dy = y;
        dz = z;
        span = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
    }

    private boolean isMinute() {
        return !(size + radius.hi > MINUTE && span > MINUTE);
    }

    /** Time of contact with the corner {@link #point}; NaN in doubt. */
    double corner() {
        if (isMinute()) {
            return Double.NaN;
        }
        setWay();
        dot(point, point, beyond);
        dot(point, way, ahead);
        dot(way, way, square);
        multiply(radius, radius, work);
        beyond.subtract(work);
        multiply(work, square, chord);
        // The chord, squared: r^2 d^2 - |q x d|^2.
        cross(point, way, crossed);
        dot(crossed, crossed, aside);
        chord.subtract(aside);
        double r = radius.hi;
        double eAside = SHARE * size * span;
        double eChord = SHARE * (r * r * square.hi + aside.hi) + 6 * (Math.sqrt(aside.hi) + eAside) * eAside;
        return root(SHARE * (size * size + r * r), SHARE * size * span, eChord);
    }

    /**
     * Time of contact with the line along an edge through {@link #point}: all lengths are multiplied by the edge's, e, as
     * everything is crossed with it; the chord, squared, is e^2 (r^2 |d x e|^2 - ((q x d).e)^2).
     */
    double edge() {
        if (isMinute()) {
            return Double.NaN;
        }
        setWay();
        cross(point, way, crossed);
        dot(crossed, along, aside);
        multiply(aside, aside, work);
        aside.set(work);
        cross(way, along, way);
        cross(point, along, crossed);
        dot(crossed, crossed, beyond);
        dot(crossed, way, ahead);
        dot(way, way, square);
        dot(along, along, chord);
        DoubleDoubleSum edgeSquare = crossed[0];
        edgeSquare.set(chord);
        DoubleDoubleSum reach = crossed[1];
        multiply(radius, radius, reach);
        multiply(reach, edgeSquare, work);
        beyond.subtract(work);
        multiply(reach, square, chord);
        chord.subtract(aside);
        double r = radius.hi;
        double eDet = SHARE * size * span * alongSize;
        double eChord = SHARE * (r * r * span * span * alongSize * alongSize + aside.hi)
                + 2 * (Math.sqrt(aside.hi) + eDet) * eDet;
        work.set(chord);
        multiply(work, edgeSquare, chord);
        double moment = size * alongSize;
        double reached = r * alongSize;
        return root(
                SHARE * (moment * moment + reached * reached),
                SHARE * moment * span * alongSize,
                eChord * edgeSquare.hi + SHARE * Math.abs(work.hi) * alongSize * alongSize);
    }

    /** Time of contact with the plane, or in the plane the line, through {@link #point} with the normal {@link #along}. */
    double face() {
        if (isMinute()) {
            return Double.NaN;
        }
        setWay();
        dot(along, along, square);
        sqrt(square, work);
        multiply(radius, work, beyond);
        dot(along, point, ahead);
        beyond.add(ahead);
        beyond.negate();
        dot(along, way, chord);
        chord.negate();
        double r = radius.hi;
        double eLength = SHARE * alongSize * alongSize / work.hi;
        return DoubleDoubleSum.floorQuotient(
                beyond, SHARE * alongSize * (size + r) + r * eLength + LOST, chord, SHARE * alongSize * span + LOST);
    }

    // beyond / (ahead + sqrt(chord)): not the difference of ahead and the root, which would cancel.
    private double root(double eBeyond, double eAhead, double eChord) {
        double e = eChord + LOST;
        if (!(chord.hi > 2 * e)) {
            return Double.NaN;
        }
        sqrt(chord, work);
        ahead.add(work);
        double eRoot = e / work.hi + 0x1p-98 * work.hi;
        return DoubleDoubleSum.floorQuotient(beyond, eBeyond + LOST, ahead, eAhead + eRoot + LOST);
    }

    private void setWay() {
        set(way[0], dx);
        set(way[1], dy);
        set(way[2], dz);
    }

    static void set(DoubleDoubleSum sum, double value) {
        sum.clear();
        sum.add(value, 0);
    }

    private void sqrt(DoubleDoubleSum value, DoubleDoubleSum out) {
        DoubleDouble.sqrt(value.hi, value.lo, root, 0);
        out.hi = root[0];
        out.lo = root[1];
        out.plain = value.plain && root[1] == 0;
    }

    private static void multiply(DoubleDoubleSum p, DoubleDoubleSum q, DoubleDoubleSum out) {
        out.clear();
        addProduct(p, q, 1, out);
    }

    private static void addProduct(DoubleDoubleSum p, DoubleDoubleSum q, int sign, DoubleDoubleSum out) {
        if (p.hi != 0 && q.hi != 0) {
            out.addProduct(sign * p.hi, sign * p.lo, q.hi, q.lo);
            out.plain &= p.plain && q.plain;
        }
    }

    private static void dot(DoubleDoubleSum[] p, DoubleDoubleSum[] q, DoubleDoubleSum out) {
        out.clear();
        for (int k = 0; k < 3; k++) {
            addProduct(p[k], q[k], 1, out);
        }
    }

    private final DoubleDoubleSum[] product = DoubleDoubleSum.array(3);

    /** Writes the cross product; {@code out} may be one of the factors. */
    void cross(DoubleDoubleSum[] p, DoubleDoubleSum[] q, DoubleDoubleSum[] out) {
        for (int k = 0; k < 3; k++) {
            int m = k == 2 ? 0 : k + 1;
            int n = k == 0 ? 2 : k - 1;
            product[k].clear();
            addProduct(p[m], q[n], 1, product[k]);
            addProduct(p[n], q[m], -1, product[k]);
        }
        for (int k = 0; k < 3; k++) {
            out[k].set(product[k]);
        }
    }
}
