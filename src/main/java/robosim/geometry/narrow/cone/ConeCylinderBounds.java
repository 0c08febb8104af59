package robosim.geometry.narrow.cone;

import robosim.geometry.exact.DoubleDoubles;
import robosim.geometry.exact.VectorMath;

/**
 * Both bounds of the distance to a cylinder in a cone, in pairs of doubles: the lower from directions, the upper from
 * points. {@link ConeCylinderBracket} finds both.
 *
 * <p>For any direction n no point of the cylinder within the cone is nearer than {@code k(n) / s(n)}, where k(n) is the
 * minimum of n.x over the cylinder and s(n) its maximum over the part of the cone inside the unit sphere. Conversely,
 * no point of the cylinder within the cone is nearer than the nearest. However a direction or a point was found, its
 * bound is certain, with an allowance for the rounding of pairs.
 */
class ConeCylinderBounds {
    /** About twenty steps, each off by 2^-100 of its operands. */
    static final double ERROR = 0x1p-94;

    /** The bracket is narrow enough at this share of the distance. */
    private static final double NARROW = 0x1p-42;

    static final int NORMAL = ConeCylinderFrame.FREE;
    static final int POINT = NORMAL + 3;
    static final int RADIAL = POINT + 3;
    static final int AROUND = RADIAL + 3;
    static final int SIDE = AROUND + 3;
    static final int OUTWARD = SIDE + 3;
    static final int HEIGHT = OUTWARD + 3;
    static final int AHEAD = HEIGHT + 1;
    static final int LATERAL = AHEAD + 1;
    static final int PART = LATERAL + 1;
    static final int REST = PART + 1;
    static final int VALUE = REST + 1;
    static final int SUPPORT = VALUE + 1;
    static final int LEAN = SUPPORT + 1;
    static final int TEMPORARY = LEAN + 3;

    /** The cone and the cylinder. */
    ConeCylinderFrame f = new ConeCylinderFrame();
    /** All numbers, by the places above. */
    DoubleDoubles p = new DoubleDoubles(1);

    private double low;
    private double high;

    void start(ConeCylinderFrame frame) {
        f = frame;
        p = frame.cone.pairs;
        low = 0;
        high = Double.POSITIVE_INFINITY;
    }

    double low() {
        return low;
    }

    double high() {
        return high;
    }

    /** Records both bounds as known. */
    void take(double lower, double upper) {
        low = Math.max(low, lower);
        high = Math.min(high, upper);
    }

    boolean isSilent() {
        return low > f.farthest;
    }

    /** Whether nothing is left to do: a proved miss, or a narrow bracket. */
    boolean isDone() {
        return isSilent() || high - low <= NARROW * low;
    }

    /**
     * Computes the unit vector from the cone's axis to the point, the outward normal of the plane that touches the cone
     * there, and the distance of the point outside that plane.
     */
    final void locate() {
        p.dot(AHEAD, POINT, Cone.AXIS, TEMPORARY);
        p.set(PART, -p.get(AHEAD), -p.rest(AHEAD));
        copy(SIDE, POINT);
        p.advance(SIDE, SIDE, PART, Cone.AXIS, TEMPORARY);
        p.dot(PART, SIDE, SIDE, TEMPORARY);
        p.root(PART, PART);
        if (!(p.get(PART) > 0)) {
            boolean isX = Math.abs(f.cone.ux) < 0.7;
            p.set(SIDE, 0);
            p.set(SIDE + 1, isX ? -f.cone.uz : f.cone.ux);
            p.set(SIDE + 2, isX ? f.cone.uy : 0);
            p.set(SIDE, isX ? 0 : -f.cone.uy);
            p.dot(REST, SIDE, Cone.AXIS, TEMPORARY);
            p.negate(REST);
            p.advance(SIDE, SIDE, REST, Cone.AXIS, TEMPORARY);
            p.dot(REST, SIDE, SIDE, TEMPORARY);
            p.root(REST, REST);
            for (int k = 0; k < 3; k++) {
                p.divide(SIDE + k, SIDE + k, REST);
            }
        } else {
            for (int k = 0; k < 3; k++) {
                p.divide(SIDE + k, SIDE + k, PART);
            }
        }
        p.multiply(LATERAL, PART, Cone.COS);
        p.multiply(REST, AHEAD, Cone.SIN);
        p.subtract(LATERAL, LATERAL, REST);
        outward();
    }

    // OUTWARD = the normal of the plane that touches the cone in the direction of SIDE.
    final void outward() {
        for (int k = 0; k < 3; k++) {
            p.multiply(OUTWARD + k, SIDE + k, Cone.COS);
            p.multiply(REST, Cone.AXIS + k, Cone.SIN);
            p.subtract(OUTWARD + k, OUTWARD + k, REST);
        }
    }

    final void copy(int to, int from) {
        for (int k = 0; k < 3; k++) {
            p.set(to + k, p.get(from + k), p.rest(from + k));
        }
    }

    /** Uses the point, which is in the cylinder, as an upper bound if the cone contains it. */
    final void point() {
        if (p.get(LATERAL) <= -ERROR * f.extent && p.get(AHEAD) > 0) {
            p.dot(PART, POINT, POINT, TEMPORARY);
            p.root(PART, PART);
            high = Math.min(high, Math.nextUp(p.get(PART) + ERROR * f.extent));
        }
    }

    /** Uses the lower bound from NORMAL, which may have any length but 0. */
    final void direction() {
        double size = VectorMath.length(p.get(NORMAL), p.get(NORMAL + 1), p.get(NORMAL + 2));
        if (!(size > 0)) {
            return;
        }
        // k(n) = n.m - r |n x a| - h |n.a|
        p.dot(VALUE, NORMAL, ConeCylinderFrame.CENTER, TEMPORARY);
        p.cross(LEAN, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
        p.dot(PART, LEAN, LEAN, TEMPORARY);
        p.root(PART, PART);
        p.multiply(PART, PART, f.radius);
        p.subtract(VALUE, VALUE, PART);
        p.dot(PART, NORMAL, ConeCylinderFrame.BODY, TEMPORARY);
        p.multiply(PART, PART, ConeCylinderFrame.HALF);
        if (p.get(PART) > 0) {
            p.negate(PART);
        }
        p.add(VALUE, VALUE, PART);
        p.set(PART, -ERROR * f.extent * size);
        p.add(VALUE, VALUE, PART);
        if (!(p.get(VALUE) > 0)) {
            return;
        }
        // s(n): along the direction of the border nearest to n, or along n itself if the cone contains n
        p.dot(SUPPORT, NORMAL, Cone.AXIS, TEMPORARY);
        p.cross(LEAN, NORMAL, Cone.AXIS, TEMPORARY);
        p.dot(REST, LEAN, LEAN, TEMPORARY);
        p.root(REST, REST);
        p.multiply(PART, REST, Cone.COS);
        p.multiply(TEMPORARY, SUPPORT, Cone.SIN);
        p.subtract(PART, PART, TEMPORARY);
        if (p.get(PART) <= 0) {
            p.dot(PART, NORMAL, NORMAL, TEMPORARY);
            p.root(PART, PART);
        } else {
            p.multiply(PART, REST, Cone.SIN);
            p.multiply(SUPPORT, SUPPORT, Cone.COS);
            p.add(PART, PART, SUPPORT);
        }
        p.set(REST, ERROR * size);
        p.add(PART, PART, REST);
        if (!(p.get(PART) > 0)) {
            low = Double.POSITIVE_INFINITY;
            return;
        }
        p.divide(VALUE, VALUE, PART);
        low = Math.max(low, Math.nextDown(p.get(VALUE)));
    }
}
