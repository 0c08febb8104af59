package robosim.geometry.index.hierarchy;

import java.util.Arrays;
import robosim.geometry.exact.BeamAxis;

/**
 * Follows a ray through a {@link Hierarchy}, nearer children first. Where the ray enters a child is computed in floats,
 * and is a lower bound: the bounds are widened by more than the floats can be off by. Allocates nothing once its stack has
 * grown.
 */
public final class RayCursor {
    /**
     * The share of the coordinates by which bounds are widened. With u = 2^-24: the inverse of the direction is off by u of
     * the way to a plane, the start times the inverse by u of itself, and the sum by u of the way: less than 4u of the
     * coordinates of the start and of the plane. This is 16u.
     */
    private static final double PAD = 0x1p-20;

    /** Coordinates below this can be multiplied by an inverse of a direction as floats. */
    private static final double LARGEST = 0x1p60;

    /** Coordinates of the start and bounds may all be as small as this; below, floats would underflow. */
    private static final double SMALLEST = 0x1p-60;

    /**
     * The smallest component of a direction. A smaller one is taken for this: over any way through the world, the two
     * differ by less than the widening.
     */
    private static final double FLATTEST = 0x1p-40;

    /** A relative error of a few roundings to float. */
    private static final double ROUNDED = 0x1p-21;

    /** A box that all bounds meet, but for those of a missing child. */
    private static final double[] EVERYWHERE = {
        -Float.MAX_VALUE, -Float.MAX_VALUE, -Float.MAX_VALUE, Float.MAX_VALUE, Float.MAX_VALUE, Float.MAX_VALUE
    };

    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;
    private static final int LINKS = Hierarchy.LINKS;

    /** More than any key; its lower half is below 0, as of an object. */
    private static final long MISSED = Long.MAX_VALUE;

    private Hierarchy tree = Hierarchy.EMPTY;
    /**
     * What is still to be looked at: links in the lower halves, and above them where the ray enters, as the bits of floats of at
     * least 0, which sort like the floats.
     */
    private long[] stack = new long[Hierarchy.STACK];

    private int depth;
    /** Whether coordinates are beyond what floats can tell apart, so that every object is visited. */
    private boolean isWhole;

    private final BoxCursor all = new BoxCursor();

    // The inverse direction; and for each axis what gives the parameter of the near and of the far plane when it is
    // added to
    // a plane times the inverse.
    private float ix;
    private float iy;
    private float iz;
    private float nearX;
    private float nearY;
    private float nearZ;
    private float farX;
    private float farY;
    private float farZ;

    private double pad;

    /**
     * Sets a ray, for any number of hierarchies one after the other.
     *
     * @param most at least the greatest magnitude of any coordinate of a box in them
     */
    public void aim(BeamAxis ray, double most) {
        double reach = Math.max(most, ray.largest());
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        isWhole = !(reach < LARGEST && reach > SMALLEST);
        pad = PAD * reach;
        double x = inverse(ray.ux());
        double y = inverse(ray.uy());
        double z = inverse(ray.uz());
        ix = (float) x;
        iy = (float) y;
        iz = (float) z;
        double wide = pad * Math.abs(x);
        nearX = (float) (-ox * x - wide);
        farX = (float) (-ox * x + wide);
        wide = pad * Math.abs(y);
        nearY = (float) (-oy * y - wide);
        farY = (float) (-oy * y + wide);
        wide = pad * Math.abs(z);
        nearZ = (float) (-oz * z - wide);
        farZ = (float) (-oz * z + wide);
    }

    /** Starts to follow the ray through a hierarchy. */
    public void start(Hierarchy through) {
        if (tree != through) { // writing a reference is slow
            tree = through;
        }
        through.settle();
        if (isWhole) {
            all.start(through, EVERYWHERE);
        }
        stack[0] = 0;
        depth = through.size() == 0 ? 0 : 1;
    }

    private static double inverse(double slope) {
        return Math.abs(slope) < FLATTEST ? Math.copySign(1 / FLATTEST, slope) : 1 / slope;
    }

    /**
     * The next object whose bounds begin within a limit, perhaps some more; -1 after the last. The limit may shrink from
     * call to call.
     */
    public int next(double limit) {
        if (isWhole) {
            return all.next();
        }
        int within = within(limit);
        float[] n = tree.nodes;
        long[] stack = this.stack;
        int top = depth;
        // Where the near and the far planes stand in a child's bounds.
        int nx = ix < 0 ? 3 : 0;
        int ny = iy < 0 ? 4 : 1;
        int nz = iz < 0 ? 5 : 2;
        int fx = 3 - nx;
        int fy = 5 - ny;
        int fz = 7 - nz;
        while (top > 0) {
            long nearest = stack[--top];
            if ((int) (nearest >>> Integer.SIZE) > within) {
                continue;
            }
            while ((int) nearest >= 0) {
                if (top + WIDTH > stack.length) {
                    stack = growStack();
                }
                int at = (int) nearest * Hierarchy.STRIDE;
                nearest = MISSED;
                int enterA = enter(n, at + nx, at + ny, at + nz);
                int leaveA = leave(n, at + fx, at + fy, at + fz, within);
                int b = at + PART;
                int enterB = enter(n, b + nx, b + ny, b + nz);
                int leaveB = leave(n, b + fx, b + fy, b + fz, within);
                int c = at + 2 * PART;
                int enterC = enter(n, c + nx, c + ny, c + nz);
                int leaveC = leave(n, c + fx, c + fy, c + fz, within);
                int d = at + 3 * PART;
                int enterD = enter(n, d + nx, d + ny, d + nz);
                int leaveD = leave(n, d + fx, d + fy, d + fz, within);
                if (enterA <= leaveA) {
                    long key = key(enterA, n[at + LINKS]);
                    nearest = key;
                }
                if (enterB <= leaveB) {
                    long key = key(enterB, n[at + LINKS + 1]);
                    if (nearest != MISSED) {
                        stack[top++] = Math.max(nearest, key);
                    }
                    nearest = Math.min(nearest, key);
                }
                if (enterC <= leaveC) {
                    long key = key(enterC, n[at + LINKS + 2]);
                    if (nearest != MISSED) {
                        stack[top++] = Math.max(nearest, key);
                    }
                    nearest = Math.min(nearest, key);
                }
                if (enterD <= leaveD) {
                    long key = key(enterD, n[at + LINKS + 3]);
                    if (nearest != MISSED) {
                        stack[top++] = Math.max(nearest, key);
                    }
                    nearest = Math.min(nearest, key);
                }
            }
            if (nearest != MISSED) {
                depth = top;
                return (int) nearest & Integer.MAX_VALUE;
            }
        }
        depth = 0;
        return -1;
    }

    private static long key(int enter, float link) {
        return (long) enter << Integer.SIZE | (Float.floatToRawIntBits(link) & 0xffffffffL);
    }

    private long[] growStack() {
        stack = Arrays.copyOf(stack, 2 * stack.length);
        return stack;
    }

    private int enter(float[] n, int x, int y, int z) {
        return Math.max(
                Math.max(0, Float.floatToRawIntBits(Math.fma(n[x], ix, nearX))),
                Math.max(
                        Float.floatToRawIntBits(Math.fma(n[y], iy, nearY)),
                        Float.floatToRawIntBits(Math.fma(n[z], iz, nearZ))));
    }

    private int leave(float[] n, int x, int y, int z, int within) {
        return Math.min(
                Math.min(within, Float.floatToRawIntBits(Math.fma(n[x], ix, farX))),
                Math.min(
                        Float.floatToRawIntBits(Math.fma(n[y], iy, farY)),
                        Float.floatToRawIntBits(Math.fma(n[z], iz, farZ))));
    }

    /** The bits of a float that is at least a limit, with what the entries may be off by. */
    private int within(double limit) {
        double most = limit * (1 + ROUNDED) + pad;
        return Float.floatToRawIntBits(most < Float.MAX_VALUE ? (float) most : Float.POSITIVE_INFINITY);
    }
}
