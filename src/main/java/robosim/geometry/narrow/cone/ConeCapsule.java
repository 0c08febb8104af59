package robosim.geometry.narrow.cone;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.exact.VectorMath;

/**
 * The distance from a cone's apex, outside a capsule, to the part of the capsule inside the cone, as a lower bound.
 *
 * <p>The part of the cone up to a given distance is convex, so the points of the segment whose ball reaches into it
 * form an interval. Hence the distance of the ball about a point, as for {@link ConeSphere}, first falls and then rises
 * along the segment; its minimum is found by golden-section search in doubles.
 *
 * <p>The answer is certified by a plane, in pairs of doubles. For a direction n, every point x of the capsule has n.x
 * of at least {@code min n.x - r |n|}, the minimum taken over the segment, and every point of the cone at distance s
 * has n.x of at most {@code s k(n)}, where k(n) is the maximum of n.y over the unit vectors y in the cone. So nothing
 * is nearer than the quotient. With n from the nearest point to the point on the segment, made perpendicular to the
 * segment if that is between its ends, the error of the bound is the square of the error of n.
 */
final class ConeCapsule {
    /** Steps of the golden-section search; each leaves 0.618 of the interval, all together 2^-52 of the segment. */
    private static final int STEPS = 75;

    private static final double GOLDEN = 0.6180339887498949;

    /** How far around the point that doubles give pairs search first: it is within 2^-26 where the minimum is sharp. */
    private static final double NEAR = 0x1p-22;

    /** And then: it is the less exact the flatter the minimum is. What the steps leave of this is 2^-58. */
    private static final double WIDE = 0x1p-6;

    /** More than the rounding of a sum of two lengths and a radius. */
    private static final double FARTHER = 1 + 0x1p-48;

    /** The required width of the bracket, as a share of the distance; wider ones are refined in pairs of doubles. */
    private static final double TIGHT = 0x1p-41;

    /** The error of a numerator in pairs of doubles, as a share of its terms: about ten steps of 2^-102 to 2^-100. */
    private static final double PAIRS_ERROR = 0x1p-92;

    /** The tilt of the plane where the border is grazed; it may lose as large a share of the sizes and the offset. */
    private static final double TILT = 0x1p-45;

    private static final StageCounters.Counter REFINED = StageCounters.counter("ConeCapsule.refined");

    private static final int M = Cone.FREE;
    private static final int A = M + 3;
    private static final int X = A + 3;
    private static final int G = X + 3;
    private static final int N = G + 3;
    private static final int CROSS = N + 3;
    private static final int AHEAD = CROSS + 3;
    private static final int ASIDE = AHEAD + 1;
    private static final int ALONG = ASIDE + 1;
    private static final int PAST = ALONG + 1;
    private static final int SHARE = PAST + 1;
    private static final int SUM = SHARE + 1;
    private static final int TEMPORARY = SUM + 1; // uses the next two too

    private Cone cone = new Cone();

    // The segment in doubles: its middle relative to the apex, and the vector from there to an end.
    private double mx;
    private double my;
    private double mz;
    private double hx;
    private double hy;
    private double hz;
    private double half;
    private double r;

    /** The distance of the farthest point of the capsule, if only by rounding more: what is not nearer is a miss. */
    private double farthest;

    /** More than that. */
    private double far;

    /** The distance of a point inside the cone, an upper bound; +Infinity where none is known. */
    private double upper;

    /** Whether the last point is beside the cone, neither in it nor behind it. */
    private boolean isBeside;

    /** A lower bound of the distance; +Infinity where the capsule is proved to be outside the cone. */
    double distance(Cone in, double[] b, int j, double ax, double ay, double az) {
        take(in, b, j, ax, ay, az);
        double t = search(-1, 1);
        double lower = certify(t, 0);
        if (isOpen(lower)) {
            REFINED.count();
            lower = Math.max(lower, certifyAround(t, NEAR));
        }
        if (isOpen(lower)) {
            // Searches only come close to an end; at it, the plane need not be perpendicular to the segment.
            lower = Math.max(lower, certify(t < 0 ? -1 : 1, 0));
        }
        if (isOpen(lower)) {
            lower = Math.max(lower, certifyAround(t, WIDE));
        }
        return lower > farthest ? Double.POSITIVE_INFINITY : lower;
    }

    /** The bound from the best point within so much of {@code t}, in pairs of doubles. */
    private double certifyAround(double t, double around) {
        double rest = refine(t, Math.max(-1 - t, -around), Math.min(1 - t, around));
        double lower = certify(t, rest);
        return isOpen(lower) ? Math.max(lower, Math.max(certifyCrossing(t, rest), certifyGrazing(t, rest))) : lower;
    }

    private boolean isOpen(double lower) {
        return lower <= farthest && (upper == Double.POSITIVE_INFINITY || upper - lower > TIGHT * upper);
    }

    private void take(Cone in, double[] b, int j, double ax, double ay, double az) {
        cone = in;
        DoubleDoubles p = cone.pairs;
        p.difference(M, b[j], cone.ox);
        p.difference(M + 1, b[j + 1], cone.oy);
        p.difference(M + 2, b[j + 2], cone.oz);
        p.set(A, ax);
        p.set(A + 1, ay);
        p.set(A + 2, az);
        r = b[j + 3];
        half = b[j + 4];
        mx = p.get(M);
        my = p.get(M + 1);
        mz = p.get(M + 2);
        hx = half * ax;
        hy = half * ay;
        hz = half * az;
        double sum = VectorMath.length(mx, my, mz) + VectorMath.length(hx, hy, hz) + r;
        farthest = FARTHER * sum;
        far = 2 * sum;
        upper = Double.POSITIVE_INFINITY;
    }

    /** The point of the segment, from -1 to 1, whose ball is nearest. */
    private double search(double from, double to) {
        double low = from;
        double high = to;
        double first = high - GOLDEN * (high - low);
        double second = low + GOLDEN * (high - low);
        double atFirst = about(first);
        double atSecond = about(second);
        for (int step = 0; step < STEPS; step++) {
            if (atFirst <= atSecond) {
                high = second;
                second = first;
                atSecond = atFirst;
                first = high - GOLDEN * (high - low);
                atFirst = about(first);
            } else {
                low = first;
                first = second;
                atFirst = atSecond;
                second = low + GOLDEN * (high - low);
                atSecond = about(second);
            }
        }
        double best = atFirst <= atSecond ? first : second;
        double least = Math.min(atFirst, atSecond);
        // If the minimum is at an end, a plane perpendicular to the segment would be wrong.
        if (about(-1) <= least) {
            return -1;
        }
        return about(1) <= least ? 1 : best;
    }

    /**
     * The distance of the ball about a point; for a ball outside the cone, larger than these and rising with the gap.
     */
    private double about(double t) {
        double x = mx + t * hx;
        double y = my + t * hy;
        double z = mz + t * hz;
        double ahead = x * cone.ux + y * cone.uy + z * cone.uz;
        double aside =
                VectorMath.length(y * cone.uz - z * cone.uy, z * cone.ux - x * cone.uz, x * cone.uy - y * cone.ux);
        double past = aside * cone.cos - ahead * cone.sin;
        double length = VectorMath.length(x, y, z);
        if (past <= 0) {
            return length - r;
        }
        double along = ahead * cone.cos + aside * cone.sin;
        double gap = along < 0 ? length : past;
        return gap > r ? far + gap : along - Math.sqrt((r - past) * (r + past));
    }

    /** The same near a point in pairs of doubles. */
    private double refine(double t, double from, double to) {
        double low = from;
        double high = to;
        double first = high - GOLDEN * (high - low);
        double second = low + GOLDEN * (high - low);
        int order = 0;
        for (int step = 0; step < STEPS; step++) {
            order = compare(t, first, second);
            if (order <= 0) {
                high = second;
                second = first;
                first = high - GOLDEN * (high - low);
            } else {
                low = first;
                first = second;
                second = low + GOLDEN * (high - low);
            }
        }
        return order <= 0 ? first : second;
    }

    private int compare(double t, double first, double second) {
        DoubleDoubles p = cone.pairs;
        boolean isFirstMet = place(t, first);
        double one = p.get(ALONG);
        double oneRest = p.rest(ALONG);
        boolean isSecondMet = place(t, second);
        if (isFirstMet != isSecondMet) {
            return isFirstMet ? -1 : 1;
        }
        double difference = (one - p.get(ALONG)) + (oneRest - p.rest(ALONG));
        return difference < 0 ? -1 : 1;
    }

    /**
     * Computes the point {@code t + rest} in pairs: X, AHEAD, ASIDE, PAST; and in ALONG the distance of its ball, or
     * how far the ball is outside the cone. Answers whether the ball reaches into the cone.
     */
    private boolean place(double t, double rest) {
        DoubleDoubles p = cone.pairs;
        p.difference(SHARE, t, -rest);
        p.multiply(SHARE, SHARE, half);
        p.advance(X, M, SHARE, A, TEMPORARY);
        p.dot(AHEAD, X, Cone.AXIS, TEMPORARY);
        p.cross(CROSS, X, Cone.AXIS, TEMPORARY);
        p.dot(ASIDE, CROSS, CROSS, TEMPORARY);
        p.root(ASIDE, ASIDE);
        p.multiply(PAST, ASIDE, Cone.COS);
        p.multiply(TEMPORARY, AHEAD, Cone.SIN);
        p.subtract(PAST, PAST, TEMPORARY);
        p.multiply(ALONG, AHEAD, Cone.COS);
        p.multiply(TEMPORARY, ASIDE, Cone.SIN);
        p.add(ALONG, ALONG, TEMPORARY);
        p.set(SUM, r);
        boolean isWithin = p.get(PAST) <= 0;
        isBeside = !isWithin && p.get(ALONG) >= 0;
        if (!isBeside) {
            // In the cone, or behind it: then the cone's nearest point is its apex, which is outside the capsule.
            p.dot(ALONG, X, X, TEMPORARY);
            p.root(ALONG, ALONG);
            if (isWithin) {
                p.subtract(ALONG, ALONG, SUM);
            }
            return isWithin;
        }
        p.subtract(TEMPORARY, SUM, PAST);
        if (p.get(TEMPORARY) < 0) {
            p.set(ALONG, p.get(PAST), p.rest(PAST));
            return false;
        }
        p.add(TEMPORARY + 1, SUM, PAST);
        p.multiply(SHARE, TEMPORARY, TEMPORARY + 1);
        p.root(SHARE, SHARE); // how far before the foot on the border the ball begins
        p.subtract(ALONG, ALONG, SHARE);
        return true;
    }

    /** The lower bound from the plane suggested by {@code t + rest}; takes {@link #upper} down to the distance there. */
    private double certify(double t, double rest) {
        DoubleDoubles p = cone.pairs;
        boolean isMet = place(t, rest);
        if (isMet) {
            upper = Math.min(upper, Math.max(0, p.get(ALONG)));
        }
        if (!isBeside) {
            for (int k = 0; k < 3; k++) {
                p.set(N + k, p.get(X + k), p.rest(X + k));
            }
        } else {
            if (!isMet) {
                p.set(SHARE, 0);
            }
            tilt();
        }
        return bound(t + rest);
    }

    /** The same where the segment crosses the border and is too thin for the ball to decide: the plane along it. */
    private double certifyCrossing(double t, double rest) {
        DoubleDoubles p = cone.pairs;
        place(t, rest);
        if (!(p.get(ASIDE) > 0)) {
            return 0; // on the axis
        }
        for (int k = 0; k < 3; k++) {
            p.multiply(TEMPORARY, Cone.AXIS + k, AHEAD);
            p.subtract(CROSS + k, X + k, TEMPORARY);
            p.divide(CROSS + k, CROSS + k, ASIDE); // e
        }
        p.dot(SUM, CROSS, A, TEMPORARY);
        p.dot(G, Cone.AXIS, A, TEMPORARY);
        // The vector perpendicular to the segment: its part along the border comes from the segment's part out of it,
        // and vice versa.
        p.multiply(SHARE, SUM, Cone.COS);
        p.multiply(TEMPORARY, G, Cone.SIN);
        p.subtract(SHARE, SHARE, TEMPORARY);
        p.multiply(PAST, G, Cone.COS);
        p.multiply(TEMPORARY, SUM, Cone.SIN);
        p.add(PAST, PAST, TEMPORARY);
        if (p.get(SHARE) < 0) {
            p.negate(SHARE);
        }
        if (p.get(PAST) < 0) {
            p.negate(PAST);
        }
        tilt();
        return bound(t + rest);
    }

    /** The same where the ball about the point almost touches the border: the plane there, slightly tilted. */
    private double certifyGrazing(double t, double rest) {
        place(t, rest);
        if (!(cone.pairs.get(ASIDE) > 0)) {
            return 0;
        }
        cone.pairs.set(SHARE, TILT);
        cone.pairs.set(PAST, 1);
        tilt();
        return bound(t + rest);
    }

    /** N from SHARE and PAST: n = share (cos u + sin e) + past (cos e - sin u), where e points from the axis u to X. */
    private void tilt() {
        DoubleDoubles p = cone.pairs;
        p.multiply(G, SHARE, Cone.COS);
        p.multiply(TEMPORARY, PAST, Cone.SIN);
        p.subtract(G, G, TEMPORARY);
        p.multiply(G + 1, SHARE, Cone.SIN);
        p.multiply(TEMPORARY, PAST, Cone.COS);
        p.add(G + 1, G + 1, TEMPORARY);
        p.divide(G + 1, G + 1, ASIDE); // e = (x - ahead u) / aside
        p.multiply(TEMPORARY, AHEAD, G + 1);
        p.subtract(G, G, TEMPORARY);
        for (int k = 0; k < 3; k++) {
            p.multiply(N + k, X + k, G + 1);
            p.multiply(TEMPORARY, Cone.AXIS + k, G);
            p.add(N + k, N + k, TEMPORARY);
        }
    }

    /**
     * {@code (min n.x - r |n|) / k(n)} minus its error bound; 0 where the plane proves nothing, over far where it
     * proves a miss.
     */
    private double bound(double place) {
        DoubleDoubles p = cone.pairs;
        if (Math.abs(place) < 1 && half > 0) { // between the ends: perpendicular to the segment
            p.dot(SUM, N, A, TEMPORARY);
            p.dot(SHARE, A, A, TEMPORARY);
            p.divide(SUM, SUM, SHARE);
            p.negate(SUM);
            p.advance(N, N, SUM, A, TEMPORARY);
        }
        p.dot(SHARE, N, N, TEMPORARY);
        p.root(SHARE, SHARE);
        double length = p.get(SHARE);
        p.dot(AHEAD, N, Cone.AXIS, TEMPORARY);
        p.cross(CROSS, N, Cone.AXIS, TEMPORARY);
        p.dot(ASIDE, CROSS, CROSS, TEMPORARY);
        p.root(ASIDE, ASIDE);
        p.multiply(PAST, ASIDE, Cone.COS);
        p.multiply(TEMPORARY, AHEAD, Cone.SIN);
        p.subtract(PAST, PAST, TEMPORARY);
        // k(n): the length of n where n is in the cone, else its part along the nearest direction of the border.
        if (p.get(PAST) <= 0) {
            p.set(PAST, length, p.rest(SHARE));
        } else {
            p.multiply(PAST, AHEAD, Cone.COS);
            p.multiply(TEMPORARY, ASIDE, Cone.SIN);
            p.add(PAST, PAST, TEMPORARY);
        }
        p.dot(SUM, N, M, TEMPORARY);
        p.dot(G, N, A, TEMPORARY);
        p.multiply(G, G, half);
        if (p.get(G) < 0) {
            p.negate(G);
        }
        p.subtract(SUM, SUM, G);
        p.multiply(SHARE, SHARE, r);
        p.subtract(SUM, SUM, SHARE);
        double least = p.get(SUM) - PAIRS_ERROR * length * far;
        double most = p.get(PAST) + PAIRS_ERROR * length;
        if (!(least > 0) || !(length > 0)) {
            return 0;
        }
        if (!(most > 0) || least > most * far) {
            return 2 * far;
        }
        p.divide(SUM, SUM, PAST);
        double error = p.get(SUM) * PAIRS_ERROR * (length / most) + PAIRS_ERROR * far * (length / most);
        return Math.max(0, Math.nextDown((p.get(SUM) - error) * (1 - 0x1p-52)));
    }
}
