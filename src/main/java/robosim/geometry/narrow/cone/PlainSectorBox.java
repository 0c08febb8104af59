package robosim.geometry.narrow.cone;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * Where an upright box is nearest within a sector of the plane, in plain doubles and in the box's own frame: {@link
 * PlainConeBox} with two axes, whose derivation holds here too. In place of faces and edges there are sides, each nearest
 * where the sector's border crosses its line, and corners.
 *
 * <p>If the sector does not hold the box's nearest point, the nearest in it is on a side that is seen, where it is the nearest
 * in the sector of the side's whole line. So if these are all certainly beyond the ends of their sides, nothing is in the
 * sector.
 */
final class PlainSectorBox {
    static final int UNSURE = 0;
    static final int BEYOND = 1;
    /** The sector holds the box's nearest point. */
    static final int HELD = 2;
    /** The sector's border crosses a side there. */
    static final int CROSSED = 3;

    /** As in {@link PlainConeBox}, where the depth of a point in the cone is what counts. */
    private static final double ERROR = FilterBound.bound(0x1p-40);

    private static final double ASKEW = 0x1p-46;
    private static final double LEAST_SINE = 0x1p-6;
    private static final double LEAST_RATE = 0x1p-12;

    /** How far the nearest point must be inside or outside, or beyond the end of a side, for certain: a share of the size. */
    private static final double CLEAR = FilterBound.bound(0x1p-24);

    private static final double STEEPEST = 32;

    private double cos;
    private double sin;
    private double limit;

    /** Sum of the magnitudes of all that enters. */
    private double size;

    private double least;
    private double error;

    /** The side that is crossed, as its two corners in a box's numbering. */
    private int from;

    private int to;

    /** What is known of a box. */
    int look(Cone cone, double[] row, int j, double most) {
        cos = cone.cos;
        sin = cone.sin;
        limit = most;
        int r = j + Leaf.ROTATION;
        double ax = row[r];
        double az = row[r + 6];
        double bx = row[r + 2];
        double bz = row[r + 8];
        double mx = row[j] - cone.ox;
        double mz = row[j + 2] - cone.oz;
        double a = mx * ax + mz * az;
        double b = mx * bx + mz * bz;
        double halfA = row[j + 3];
        double halfB = row[j + 5];
        size = Math.abs(a) + Math.abs(b) + halfA + halfB;
        error = ERROR * size;
        if (!(Math.abs(ax * ax + az * az - 1) < ASKEW
                && Math.abs(bx * bx + bz * bz - 1) < ASKEW
                && Math.abs(ax * bx + az * bz) < ASKEW
                && cos > LEAST_SINE
                && sin > LEAST_SINE
                && size > 0x1p-100
                && size < 0x1p100
                && error < 0x1p-20 * size)) {
            return UNSURE;
        }
        double lowA = a - halfA;
        double highA = a + halfA;
        double lowB = b - halfB;
        double highB = b + halfB;
        double p = lowA > 0 ? lowA : highA < 0 ? highA : 0;
        double q = lowB > 0 ? lowB : highB < 0 ? highB : 0;
        double length = Math.sqrt(p * p + q * q);
        if (!(length > 0x1p-10 * size)) {
            return UNSURE;
        }
        if (length - 8 * error > limit) {
            return BEYOND;
        }
        double ua = cone.ux * ax + cone.uz * az;
        double ub = cone.ux * bx + cone.uz * bz;
        double ahead = p * ua + q * ub;
        double depth = ahead - cos * length;
        if (depth > CLEAR * size) {
            // off the axis by more than what does not matter
            double off = p * ub - q * ua;
            least = length;
            return off * off > 48 * error * size ? HELD : UNSURE;
        }
        if (!(depth < -CLEAR * size)) {
            return UNSURE;
        }
        int known = BEYOND;
        if (p != 0) {
            known = side(p, halfA, lowB, highB, ua, ub);
            from = p > 0 ? 0 : 1;
            to = from + 4;
        }
        if (known == BEYOND && q != 0) {
            known = side(q, halfB, lowA, highA, ub, ua);
            from = q > 0 ? 0 : 4;
            to = from + 1;
        }
        return known;
    }

    /** What a side tells, at a bound across one axis and from low to high along the other. */
    private int side(double at, double half, double low, double high, double across, double along) {
        double toward = at > 0 ? across : -across;
        if (toward >= cos) {
            return BEYOND; // nearest straight on, where the box is not
        }
        double aside = Math.abs(along);
        double rate = cos * toward + sin * aside;
        if (rate < LEAST_RATE) {
            return rate < -LEAST_RATE ? BEYOND : UNSURE;
        }
        double distance = Math.abs(at) / rate;
        if (distance - 4 * (1 / rate + 1) * error > limit) {
            return BEYOND;
        }
        double foot = distance * (cos - sin * toward / aside) * along;
        double in = Math.min(foot - low, high - foot);
        if (in < -CLEAR * size / rate) {
            return BEYOND;
        }
        double apart = 48 / rate * error * size;
        double off = distance * sin;
        if (!(in > 0 && in * in > apart && 4 * half * half > apart && off * off > apart && 1 / rate <= STEEPEST)) {
            return UNSURE;
        }
        least = distance;
        return CROSSED;
    }

    int from() {
        return from;
    }

    int to() {
        return to;
    }

    /** What the crossing's distance must not exceed. */
    double atMost() {
        return least + 2 * error;
    }
}
