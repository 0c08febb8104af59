package robosim.geometry.narrow.ray;

import robosim.geometry.exact.Dyadic;

/** A ray against an intersection of slabs in exact arithmetic: both ends of every interval are fractions. */
final class ExactSlabs {
    private final ExactRay ray;
    private final Dyadic[] nearest;
    private final Dyadic[] farthest;
    private final Dyadic[] slopes;
    private int count;
    private boolean none;

    ExactSlabs(ExactRay ray, int capacity) {
        this.ray = ray;
        nearest = new Dyadic[capacity];
        farthest = new Dyadic[capacity];
        slopes = new Dyadic[capacity];
    }

    /**
     * Adds the slab of points whose form is between low and high; along the ray the form is {@code offset + t slope}.
     */
    void add(Dyadic low, Dyadic offset, Dyadic high, Dyadic slope) {
        Dyadic toLow = low.subtract(offset);
        Dyadic toHigh = high.subtract(offset);
        int sign = slope.signum();
        if (sign == 0) {
            none |= toLow.signum() > 0 || toHigh.signum() < 0;
            return;
        }
        nearest[count] = sign > 0 ? toLow : toHigh.negate();
        farthest[count] = sign > 0 ? toHigh : toLow.negate();
        slopes[count] = slope.abs();
        count++;
    }

    /** The distance in world units to where the ray is in all slabs; 0 where it starts inside, +Infinity on a miss. */
    double distance() {
        if (none) {
            return Double.POSITIVE_INFINITY;
        }
        int last = -1;
        for (int i = 0; i < count; i++) {
            if (farthest[i].signum() < 0) {
                return Double.POSITIVE_INFINITY;
            }
            boolean later = last < 0
                    ? nearest[i].signum() > 0
                    : compare(nearest[i], slopes[i], nearest[last], slopes[last]) > 0;
            last = later ? i : last;
        }
        if (last < 0) {
            return 0;
        }
        for (int i = 0; i < count; i++) {
            if (compare(farthest[i], slopes[i], nearest[last], slopes[last]) < 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return ray.distance(nearest[last], slopes[last]);
    }

    private static int compare(Dyadic n, Dyadic d, Dyadic n2, Dyadic d2) {
        return n.multiply(d2).compareTo(n2.multiply(d));
    }
}
