package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A prism translated against one at rest. Both are enclosures, with sides in the same directions, so the gap along each
 * direction is the difference of one number of either row; the two are apart only where such a gap is open.
 *
 * <p>As enclosures only must not miss anything, there is no exact stage. A gap and a speed are rounded once, which keeps
 * their signs, and their quotient once more: with u = 2^-53, off by 3u of itself. A time is taken {@link #ROUNDING} to
 * the safe side, which covers that, the product and what underflows.
 */
final class MovingPrism {
    private static final double ROUNDING = 0x1p-50;

    private static final int HEIGHTS = 8;

    private MovingPrism() {}

    /** As {@link SpatialSweep#translation}, and in the plane as {@link PlanarSweep#translation}; never late. */
    static double time(boolean planar, Leaf a, double dx, double dy, double dz, Leaf b) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int k = 0; k < (planar ? HEIGHTS : HEIGHTS + 2); k += 2) {
            double speed = speed(k, dx, dy, dz);
            double ahead = a.get(k) - b.get(k + 1);
            double behind = b.get(k) - a.get(k + 1);
            if ((ahead > 0 && speed >= 0) || (behind > 0 && speed <= 0)) {
                return Double.POSITIVE_INFINITY;
            }
            // The gap that the motion closes, and the one that it opens.
            double closing = speed < 0 ? ahead : behind;
            double opening = speed < 0 ? behind : ahead;
            if (closing > 0) {
                enter = Math.max(enter, closing / Math.abs(speed));
            }
            if (speed != 0) {
                leave = Math.min(leave, -opening / Math.abs(speed));
            }
        }
        if (enter == Double.NEGATIVE_INFINITY) {
            return isBlocked(planar, a, dx, dy, dz, b) ? 0 : Double.POSITIVE_INFINITY;
        }
        double earliest = Math.max(0, enter * (1 - ROUNDING) - Double.MIN_VALUE);
        double latest = leave * (1 + ROUNDING) + Double.MIN_VALUE;
        return earliest > 1 || earliest > latest ? Double.POSITIVE_INFINITY : earliest;
    }

    /** From contact: whether the motion goes against every shortest way out. */
    private static boolean isBlocked(boolean planar, Leaf a, double dx, double dy, double dz, Leaf b) {
        double least = Double.POSITIVE_INFINITY;
        boolean isBlocked = true;
        for (int k = 0; k < (planar ? HEIGHTS : HEIGHTS + 2); k += 2) {
            double scale = k == 4 || k == 6 ? VectorMath.HALF_ROOT : 1;
            double speed = speed(k, dx, dy, dz);
            for (int side = 1; side >= -1; side -= 2) {
                double depth = scale * (side > 0 ? b.get(k + 1) - a.get(k) : a.get(k + 1) - b.get(k));
                boolean isInto = side * speed < 0;
                isBlocked = depth < least ? isInto : isBlocked && (isInto || depth > least);
                least = Math.min(least, depth);
            }
        }
        return isBlocked;
    }

    /** The speed along the direction whose bounds begin at place k of a row. */
    private static double speed(int k, double dx, double dy, double dz) {
        return switch (k) {
            case 0 -> dx;
            case 2 -> dz;
            case 4 -> dx + dz;
            case 6 -> dx - dz;
            default -> dy;
        };
    }
}
