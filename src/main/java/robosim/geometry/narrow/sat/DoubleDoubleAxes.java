package robosim.geometry.narrow.sat;

import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * The second stage of {@link MovingAxes}: when the gap along one axis closes, in pairs of doubles.
 *
 * <p>Where doubles lose 32 units of 2^-53 of the magnitudes, pairs lose as many units of about 2^-102. Coordinates and
 * edges are exact (a prism's corners are sums of three numbers), a cross product is off by 2^-99 of its parts and the
 * dot products by 2^-98: in all less than 2^-94, or {@link #SHARE} of the bound in doubles. Tails lost to underflow,
 * each below 2^-1074, are covered by {@link #LOST} of the coordinates and of 1, times the axis and 1.
 */
final class DoubleDoubleAxes {
    /** Numbers of axes: a normal of the first or of the second body, by its index there. */
    static final int FIRST = 0;

    static final int SECOND = 64;

    /** Added to these: the normal of an edge in the plane of the body's first normal. */
    static final int IN_PLANE = 32;

    /** The cross product of edge p of the first and edge q of the second: this plus 8 p + q. */
    static final int ACROSS_BOTH = 128;

    static final double SHARE = 0x1p-46;
    static final double LOST = 0x1p-1000;

    private final DoubleDoubleBody mover = new DoubleDoubleBody();
    private final DoubleDoubleBody rest = new DoubleDoubleBody();
    private final DoubleDoubleSum[] axis = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum[] p = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum[] q = DoubleDoubleSum.array(3);
    private final DoubleDoubleSum gap = new DoubleDoubleSum();
    private final DoubleDoubleSum closing = new DoubleDoubleSum();

    private double dx;
    private double dy;
    private double dz;
    private double lost;

    /** Takes the leaves, relative to an origin. */
    void load(AxisBody.Mode mode, Leaf a, Leaf b, double ox, double oy, double oz) {
        mover.load(mode, a, ox, oy, oz);
        rest.load(mode, b, ox, oy, oz);
    }

    /** Takes the displacement, and a bound of all coordinates. */
    void move(double moveX, double moveY, double moveZ, double size) {
        dx = moveX;
        dy = moveY;
        dz = moveZ;
        lost = LOST * (1 + size + Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
    }

    /**
     * The time at which a gap closes, rounded down; NaN in doubt.
     *
     * @param ahead whether the mover lies ahead of the other along the axis, or behind it
     * @param gapError error bound of the gap in doubles
     * @param speedError error bound of the speed in doubles
     */
    double time(int number, boolean ahead, double gapError, double speedError, AxisBody first, AxisBody second) {
        find(number, first, second);
        mover.project(axis);
        rest.project(axis);
        gap.set(ahead ? mover.lo : rest.lo);
        gap.subtract(ahead ? rest.hi : mover.hi);
        closing.clear();
        addSpeed(axis[0], dx);
        addSpeed(axis[1], dy);
        addSpeed(axis[2], dz);
        if (ahead) {
            closing.negate();
        }
        double least = lost * (1 + Math.abs(axis[0].hi) + Math.abs(axis[1].hi) + Math.abs(axis[2].hi));
        return DoubleDoubleSum.floorQuotient(gap, SHARE * gapError + least, closing, SHARE * speedError + least);
    }

    private void addSpeed(DoubleDoubleSum n, double d) {
        if (d != 0) {
            closing.addProduct(n.hi, n.lo, d, 0);
            closing.plain &= n.plain;
        }
    }

    private void find(int number, AxisBody first, AxisBody second) {
        if (number >= ACROSS_BOTH) {
            mover.edge((number - ACROSS_BOTH) / 8, p);
            rest.edge((number - ACROSS_BOTH) % 8, q);
            cross(p, q, axis);
            return;
        }
        boolean isFirst = number < SECOND;
        DoubleDoubleBody fine = isFirst ? mover : rest;
        AxisBody body = isFirst ? first : second;
        int index = number % SECOND;
        if (index < IN_PLANE) {
            normal(fine, body, index, axis);
        } else {
            // The normal overwrites p and q.
            normal(fine, body, 0, axis);
            q[0].set(axis[0]);
            q[1].set(axis[1]);
            q[2].set(axis[2]);
            fine.edge(index - IN_PLANE, p);
            cross(p, q, axis);
        }
    }

    private void normal(DoubleDoubleBody fine, AxisBody body, int index, DoubleDoubleSum[] out) {
        int recipe = body.recipe[index];
        if (recipe >= AxisBody.CROSS) {
            fine.edge((recipe - AxisBody.CROSS) / 8, p);
            fine.edge((recipe - AxisBody.CROSS) % 8, q);
            cross(p, q, out);
        } else if (recipe >= AxisBody.ALONG) {
            fine.edge(recipe - AxisBody.ALONG, out);
        } else if (recipe >= AxisBody.ACROSS) {
            fine.edge(recipe - AxisBody.ACROSS, p);
            out[0].set(p[2]);
            out[0].negate();
            out[1].clear();
            out[2].set(p[0]);
        } else {
            for (int m = 0; m < 3; m++) {
                out[m].clear();
                out[m].add(body.normal[3 * index + m], 0);
            }
        }
    }

    private static void cross(DoubleDoubleSum[] u, DoubleDoubleSum[] v, DoubleDoubleSum[] out) {
        for (int m = 0; m < 3; m++) {
            DoubleDoubleSum a = u[(m + 1) % 3];
            DoubleDoubleSum b = u[(m + 2) % 3];
            DoubleDoubleSum c = v[(m + 1) % 3];
            DoubleDoubleSum d = v[(m + 2) % 3];
            out[m].clear();
            out[m].addProduct(a.hi, a.lo, d.hi, d.lo);
            out[m].addProduct(-b.hi, -b.lo, c.hi, c.lo);
            out[m].plain &= a.plain && b.plain && c.plain && d.plain;
        }
    }
}
