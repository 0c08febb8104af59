package robosim.geometry.narrow.leaf;

/** Distances of boxes (minimum x, y, z, then maximum) and of points, each rounded in a known direction. */
public final class BoxGap {
    /** Three differences, squares, sums and a root are off by less than 5 u together; this takes 8. */
    private static final double DOWN = 1 - 0x1p-50;

    private static final double UP = 1 + 0x1p-50;

    /** Below this, squares may lose bits to underflow. */
    private static final double SMALL = 0x1p-400;

    private BoxGap() {}

    /** Whether two closed boxes have a point in common. */
    public static boolean hit(double[] a, double[] b) {
        return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4] && a[2] <= b[5] && b[2] <= a[5];
    }

    /** The distance of two boxes, not above the truth; 0 only if they meet or nearly do. */
    public static double atLeast(double[] a, double[] b) {
        double x = Math.max(0, Math.max(a[0] - b[3], b[0] - a[3]));
        double y = Math.max(0, Math.max(a[1] - b[4], b[1] - a[4]));
        double z = Math.max(0, Math.max(a[2] - b[5], b[2] - a[5]));
        double most = Math.max(x, Math.max(y, z));
        return (most < SMALL ? most : Math.sqrt(x * x + y * y + z * z)) * DOWN;
    }

    /** The distance of two points, not below the truth. */
    public static double atMost(double[] p, double[] q, boolean flat) {
        double x = Math.abs(p[0] - q[0]);
        double y = flat ? 0 : Math.abs(p[1] - q[1]);
        double z = Math.abs(p[2] - q[2]);
        double most = Math.max(x, Math.max(y, z));
        double length = most < SMALL ? x + y + z : Math.sqrt(x * x + y * y + z * z);
        return up(length);
    }

    /** A bound that was computed with a rounding or two, rounded up. */
    public static double up(double value) {
        return value == 0 ? 0 : Math.nextUp(value * UP);
    }

    /** The longest side, by which the node to open first is chosen. */
    public static double size(double[] box) {
        return Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
    }
}
