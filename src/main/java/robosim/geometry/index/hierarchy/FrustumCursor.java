package robosim.geometry.index.hierarchy;

import java.util.Arrays;

/**
 * Follows many rays from one place through a {@link Hierarchy} at once, nearer children first: visits every object that one of
 * the rays may meet, and perhaps some more. All is computed in floats and on the safe side. Allocates nothing once its stack
 * has grown.
 *
 * <p>The rays are within four planes through the place, on two sides of their middle direction each: along the way from a
 * ray to the next one, so that the pixels of a camera are enclosed tightly, and across it. No ray reaches a box sooner than
 * the middle direction reaches the plane across it that touches the box.
 */
public final class FrustumCursor {
    /**
     * The share of the coordinates by which bounds are widened. With u = 2^-24: three coordinates of a normal, its product
     * with the place, and three sums are off by 14u of the coordinates in all. This is 32u.
     */
    private static final double PAD = 0x1p-19;

    /** Coordinates below this can be multiplied as floats. */
    private static final double LARGEST = 0x1p60;

    /** The place and bounds may all be as near as this; below, floats would underflow. */
    private static final double SMALLEST = 0x1p-60;

    /** Added to what the rays enclose, as a slope: more than the roundings of doubles. */
    private static final double WIDER = 0x1p-40;

    /** The smallest component of the middle direction, so that missing children are infinitely far. */
    private static final double FLATTEST = 0x1p-40;

    /** A relative error of a few roundings to float. */
    private static final double ROUNDED = 0x1p-21;

    /** The most rays. */
    public static final int MOST = 64;

    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;
    private static final int LINKS = Hierarchy.LINKS;

    /** More than any key; its lower half is below 0, as of an object. */
    private static final long MISSED = Long.MAX_VALUE;

    private Hierarchy tree = Hierarchy.EMPTY;

    /** What is still to be looked at, as in a {@link RayCursor}. */
    private long[] stack = new long[Hierarchy.STACK];

    private int depth;
    private boolean isWhole;
    private double pad;

    private final BoundsPlane ahead = new BoundsPlane();
    private final BoundsPlane left = new BoundsPlane();
    private final BoundsPlane right = new BoundsPlane();
    private final BoundsPlane above = new BoundsPlane();
    private final BoundsPlane below = new BoundsPlane();

    // Where the rays begin.
    private double ox;
    private double oy;
    private double oz;

    // The middle direction, and two that are perpendicular to it and to each other.
    private double ax;
    private double ay;
    private double az;
    private double ex;
    private double ey;
    private double ez;
    private double fx;
    private double fy;
    private double fz;

    /** How far each ray goes along the middle direction, and its slopes along the other two. */
    private final double[] along = new double[MOST];

    private final double[] slopesE = new double[MOST];
    private final double[] slopesF = new double[MOST];

    // What the slopes are between.
    private double leastE;
    private double mostE;
    private double leastF;
    private double mostF;

    /**
     * Takes the directions of some rays, for any number of places and hierarchies.
     *
     * @param x unit vectors, {@link #MOST} of them; those after the first so many do not count
     * @param narrow the least cosine of the angle between a ray and the middle direction, above 0
     * @return false where the rays spread farther than that
     */
    public boolean enclose(double[] x, double[] y, double[] z, int count, double narrow) {
        ax = 0;
        ay = 0;
        az = 0;
        for (int k = 0; k < count; k++) {
            ax += x[k];
            ay += y[k];
            az += z[k];
        }
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        if (!(length > 0.5 * narrow * count)) { // else they go all ways
            return false;
        }
        ax /= length;
        ay /= length;
        az /= length;
        int other = count > 1 ? 1 : 0;
        takeSides(x[other] - x[0], y[other] - y[0], z[other] - z[0]);
        slopes(x, y, z);
        leastE = Double.POSITIVE_INFINITY;
        mostE = Double.NEGATIVE_INFINITY;
        leastF = leastE;
        mostF = mostE;
        double least = 1;
        for (int k = 0; k < count; k++) {
            least = along[k] < least ? along[k] : least;
            leastE = slopesE[k] < leastE ? slopesE[k] : leastE;
            mostE = slopesE[k] > mostE ? slopesE[k] : mostE;
            leastF = slopesF[k] < leastF ? slopesF[k] : leastF;
            mostF = slopesF[k] > mostF ? slopesF[k] : mostF;
        }
        return least >= narrow;
    }

    /** A loop for each of three, which the compiler turns into vector instructions. */
    private void slopes(double[] x, double[] y, double[] z) {
        project(x, y, z, ax, ay, az, along);
        project(x, y, z, ex, ey, ez, slopesE);
        project(x, y, z, fx, fy, fz, slopesF);
        divide(slopesE, along);
        divide(slopesF, along);
    }

    private static void project(double[] x, double[] y, double[] z, double ax, double ay, double az, double[] out) {
        for (int k = 0; k < MOST; k++) {
            out[k] = x[k] * ax + y[k] * ay + z[k] * az;
        }
    }

    private static void divide(double[] numbers, double[] by) {
        for (int k = 0; k < MOST; k++) {
            numbers[k] /= by[k];
        }
    }

    /** Takes the direction from a ray to the next one for one of the two across the middle; any where there is none. */
    private void takeSides(double x, double y, double z) {
        double along = x * ax + y * ay + z * az;
        ex = x - along * ax;
        ey = y - along * ay;
        ez = z - along * az;
        double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        if (!(length > 0x1p-30)) {
            boolean isUpright = Math.abs(ay) > 0.5;
            ex = isUpright ? 0 : az;
            ey = isUpright ? -az : 0;
            ez = isUpright ? ay : -ax;
            length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        }
        ex /= length;
        ey /= length;
        ez /= length;
        fx = ay * ez - az * ey;
        fy = az * ex - ax * ez;
        fz = ax * ey - ay * ex;
    }

    /**
     * Sets where the rays begin.
     *
     * @param most at least the greatest magnitude of any coordinate of a box in the hierarchies
     */
    public void aim(double x, double y, double z, double most) {
        ox = x;
        oy = y;
        oz = z;
        double reach = Math.max(most, Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz))));
        isWhole = !(reach < LARGEST && reach > SMALLEST);
        pad = PAD * reach;
        ahead.set(steep(ax), steep(ay), steep(az), ox, oy, oz, pad);
        side(left, ex, ey, ez, mostE);
        side(right, -ex, -ey, -ez, -leastE);
        side(above, fx, fy, fz, mostF);
        side(below, -fx, -fy, -fz, -leastF);
    }

    private static double steep(double component) {
        return Math.abs(component) < FLATTEST ? FLATTEST : component;
    }

    /** A plane that no ray is beyond: their slopes along a direction are at most so much. */
    private void side(BoundsPlane to, double nx, double ny, double nz, double most) {
        double slope = most + WIDER;
        double scale = 1 / Math.sqrt(1 + slope * slope);
        to.set((nx - slope * ax) * scale, (ny - slope * ay) * scale, (nz - slope * az) * scale, ox, oy, oz, pad);
    }

    /** Starts to follow the rays through a hierarchy. */
    public void start(Hierarchy through) {
        if (tree != through) { // writing a reference is slow
            tree = through;
        }
        through.settle();
        stack[0] = 0;
        depth = through.size() == 0 ? 0 : 1;
    }

    /**
     * The next object whose bounds a ray may meet within a limit; -1 after the last. The limit may shrink from call to call.
     */
    public int next(double limit) {
        float[] n = tree.nodes;
        int within = within(limit);
        while (depth > 0) {
            long nearest = stack[--depth];
            if ((int) (nearest >>> Integer.SIZE) > within && !isWhole) {
                continue;
            }
            while ((int) nearest >= 0) {
                nearest = open(n, (int) nearest * Hierarchy.STRIDE, within);
            }
            if (nearest != MISSED) {
                return (int) nearest & Integer.MAX_VALUE;
            }
        }
        return -1;
    }

    /** Takes a node's children onto the stack, but for the nearest, which it returns. */
    private long open(float[] n, int at, int within) {
        if (depth + WIDTH > stack.length) {
            stack = Arrays.copyOf(stack, 2 * stack.length);
        }
        long nearest = MISSED;
        for (int child = 0; child < WIDTH; child++) {
            int k = at + PART * child;
            int key = Math.max(0, ahead.beyond(n, k));
            int link = Float.floatToRawIntBits(n[at + LINKS + child]);
            if (isWhole ? link != Hierarchy.NONE : key <= within && isBetween(n, k)) {
                long entry = (long) key << Integer.SIZE | (link & 0xffffffffL);
                if (nearest != MISSED) {
                    stack[depth++] = Math.max(nearest, entry);
                }
                nearest = Math.min(nearest, entry);
            }
        }
        return nearest;
    }

    private boolean isBetween(float[] n, int k) {
        return Math.max(
                        Math.max(left.beyond(n, k), right.beyond(n, k)),
                        Math.max(above.beyond(n, k), below.beyond(n, k)))
                <= 0;
    }

    /** The bits of a float that is at least a limit, with what the distances may be off by; below those of infinity. */
    private int within(double limit) {
        double most = limit * (1 + ROUNDED) + pad;
        return Float.floatToRawIntBits(most < Float.MAX_VALUE ? (float) most : Float.MAX_VALUE);
    }
}
