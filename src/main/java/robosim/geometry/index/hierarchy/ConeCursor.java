package robosim.geometry.index.hierarchy;

import robosim.geometry.exact.BeamAxis;
import robosim.geometry.index.quadtree.LongHeap;

/**
 * Visits the objects of two hierarchies that a cone may meet, in the order of how far their bounds are within the cone, or
 * less. All is computed in floats and on the safe side. Allocates nothing once its queue has grown.
 *
 * <p>Bounds begin in a direction of the axes at a plane, which the cone reaches at a distance that is its height times a
 * factor of the cone: six directions give six lower bounds. And no point of the cone is beyond one of four planes that touch
 * it.
 */
public final class ConeCursor {
    /**
     * The share of the coordinates by which bounds are widened. With u = 2^-24: a factor, a product with it and the sum are
     * each off by u of the coordinates of the apex and of the plane times the factor; for a plane that touches the cone, three
     * coordinates of the normal, and four sums: less than 12u of the coordinates in all. This is 16u.
     */
    private static final double PAD = 0x1p-20;

    /** Coordinates below this can be multiplied by a factor as floats. */
    private static final double LARGEST = 0x1p60;

    /** The apex and bounds may all be as near as this; below, floats would underflow. */
    private static final double SMALLEST = 0x1p-60;

    /** Where the cone goes along an axis by less than this share of its length, this stands for the share. */
    private static final double FLATTEST = 0x1p-20;

    /** The factor for what the cone goes away from, so that all of it is too far. */
    private static final double NEVER = 0x1p60;

    /** No two points within coordinates are farther apart than this many times the greatest. */
    private static final double ACROSS = 4;

    /** A relative error of a few roundings to float. */
    private static final double ROUNDED = 0x1p-21;

    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;
    private static final int LINKS = Hierarchy.LINKS;

    /** The bit that is set in the links of the second hierarchy. */
    private static final int SECOND = 1 << 29;

    /** More than any entry. */
    private static final long MISSED = Long.MAX_VALUE;

    private Hierarchy first = Hierarchy.EMPTY;
    private Hierarchy second = first;
    private boolean isWhole;
    private double pad;
    private double farthest;

    // By axis: what gives the distance of a plane that bounds begin at, times the plane's coordinate, and to be added.
    private float upX;
    private float upY;
    private float upZ;
    private float atUpX;
    private float atUpY;
    private float atUpZ;
    private float downX;
    private float downY;
    private float downZ;
    private float atDownX;
    private float atDownY;
    private float atDownZ;

    // Planes through the apex that touch the cone, across e cos - u sin, given a unit vector e across the axis u.
    private final BoundsPlane left = new BoundsPlane();
    private final BoundsPlane right = new BoundsPlane();
    private final BoundsPlane above = new BoundsPlane();
    private final BoundsPlane below = new BoundsPlane();

    /** By the bits of floats of at least 0, which sort like the floats. */
    private final LongHeap queue = new LongHeap();

    /**
     * Sets a cone.
     *
     * @param most at least the greatest magnitude of any coordinate of a box in the hierarchies
     */
    public void aim(BeamAxis beam, double most) {
        double reach = Math.max(most, beam.largest());
        double ox = beam.ox;
        double oy = beam.oy;
        double oz = beam.oz;
        double cos = beam.cos;
        double sin = beam.sin;
        isWhole = !(reach < LARGEST && reach > SMALLEST);
        pad = PAD * reach;
        farthest = ACROSS * reach;
        double x = factor(beam.ux(), cos, sin);
        upX = (float) x;
        atUpX = (float) (-ox * x - pad * x);
        x = factor(-beam.ux(), cos, sin);
        downX = (float) -x;
        atDownX = (float) (ox * x - pad * x);
        double y = factor(beam.uy(), cos, sin);
        upY = (float) y;
        atUpY = (float) (-oy * y - pad * y);
        y = factor(-beam.uy(), cos, sin);
        downY = (float) -y;
        atDownY = (float) (oy * y - pad * y);
        double z = factor(beam.uz(), cos, sin);
        upZ = (float) z;
        atUpZ = (float) (-oz * z - pad * z);
        z = factor(-beam.uz(), cos, sin);
        downZ = (float) -z;
        atDownZ = (float) (oz * z - pad * z);
        setSides(beam);
    }

    /** The distance at which a cone reaches a plane across an axis, of which its own axis has a share, per height. */
    private static double factor(double share, double cos, double sin) {
        double most = share >= cos ? 1 : cos * share + sin * Math.sqrt(Math.max(0, (1 - share) * (1 + share)));
        return most >= FLATTEST ? 1 / most : most > -FLATTEST ? 1 / FLATTEST : NEVER;
    }

    private void setSides(BeamAxis beam) {
        double ux = beam.ux();
        double uy = beam.uy();
        double uz = beam.uz();
        double cos = beam.cos;
        double sin = beam.sin;
        // Across the axis: level, or along X where the axis is upright; and across both.
        double level = Math.sqrt(ux * ux + uz * uz);
        boolean isUpright = !(level > 0x1p-20);
        double ex = isUpright ? 1 : uz / level;
        double ez = isUpright ? 0 : -ux / level;
        double fx = uy * ez;
        double fy = uz * ex - ux * ez;
        double fz = -uy * ex;
        ex *= cos;
        ez *= cos;
        fx *= cos;
        fy *= cos;
        fz *= cos;
        double sx = ux * sin;
        double sy = uy * sin;
        double sz = uz * sin;
        left.set(ex - sx, -sy, ez - sz, beam.ox, beam.oy, beam.oz, pad);
        right.set(-ex - sx, -sy, -ez - sz, beam.ox, beam.oy, beam.oz, pad);
        above.set(fx - sx, fy - sy, fz - sz, beam.ox, beam.oy, beam.oz, pad);
        below.set(-fx - sx, -fy - sy, -fz - sz, beam.ox, beam.oy, beam.oz, pad);
    }

    /** Starts to search two hierarchies, which share no object. */
    public void start(Hierarchy one, Hierarchy another) {
        if (first != one || second != another) { // writing a reference is slow
            first = one;
            second = another;
        }
        queue.clear();
        one.settle();
        if (one.size() > 0) {
            queue.push(0);
        }
        another.settle();
        if (another.size() > 0) {
            queue.push(SECOND);
        }
    }

    /** The next object that the cone may meet within a limit; -1 after the last. The limit may shrink from call to call. */
    public int next(double limit) {
        int within = within(limit);
        long nearest = MISSED;
        while (true) {
            if (nearest == MISSED) {
                if (queue.isEmpty() || (!isWhole && (int) (queue.least() >>> Integer.SIZE) > within)) {
                    return -1;
                }
                nearest = queue.pop();
            }
            int link = (int) nearest;
            if (link < 0) {
                return link & ~(Integer.MIN_VALUE | SECOND);
            }
            nearest = open((link & SECOND) == 0 ? first : second, link & ~SECOND, link & SECOND, within);
            if (nearest != MISSED && !queue.isEmpty() && nearest > queue.least()) {
                queue.push(nearest);
                nearest = queue.pop();
            }
        }
    }

    /** The bits of a float that is at least a limit, with what the distances may be off by. */
    private int within(double limit) {
        return Float.floatToRawIntBits((float) (Math.min(limit, farthest) * (1 + ROUNDED) + pad));
    }

    /** Takes a node's children in, but for the nearest, which it returns. */
    private long open(Hierarchy tree, int node, int mark, int within) {
        float[] n = tree.nodes;
        int at = node * Hierarchy.STRIDE;
        int link = at + LINKS;
        long nearest = MISSED;
        for (int k = at; k < at + WIDTH * PART; k += PART, link++) {
            int key = key(n, k);
            int child = Float.floatToRawIntBits(n[link]);
            // A child that is missing is infinitely far.
            if (isWhole ? child != Hierarchy.NONE : Math.max(key - within, beyond(n, k)) <= 0) {
                long entry = (long) key << Integer.SIZE | ((child | mark) & 0xffffffffL);
                if (nearest != MISSED) {
                    queue.push(Math.max(nearest, entry));
                }
                nearest = Math.min(nearest, entry);
            }
        }
        return nearest;
    }

    /** The bits of a lower bound of the distance of bounds within the cone, at least 0. */
    private int key(float[] n, int k) {
        int x = Math.max(
                Float.floatToRawIntBits(Math.fma(n[k], upX, atUpX)),
                Float.floatToRawIntBits(Math.fma(n[k + 3], downX, atDownX)));
        int y = Math.max(
                Float.floatToRawIntBits(Math.fma(n[k + 1], upY, atUpY)),
                Float.floatToRawIntBits(Math.fma(n[k + 4], downY, atDownY)));
        int z = Math.max(
                Float.floatToRawIntBits(Math.fma(n[k + 2], upZ, atUpZ)),
                Float.floatToRawIntBits(Math.fma(n[k + 5], downZ, atDownZ)));
        return Math.max(Math.max(0, x), Math.max(y, z));
    }

    /** The bits of how far bounds are beyond one of the planes, roughly; 0 or less where they may not be. */
    private int beyond(float[] n, int k) {
        return Math.max(
                Math.max(left.beyond(n, k), right.beyond(n, k)), Math.max(above.beyond(n, k), below.beyond(n, k)));
    }
}
