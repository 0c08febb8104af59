package robosim.geometry.narrow;

import robosim.geometry.exact.Filter;

/**
 * Whether a disc that moves straight on meets another at rest, in plain doubles and only where these are certain: the
 * least distance of a point to a segment, squared, against the sum of the radii, squared.
 */
public final class DiscWay {
    /** Doubles cannot tell. */
    public static final int UNSURE = 0;

    /** The two are apart all the way, and where it ends. */
    public static final int CLEAR = 1;

    /** The two are apart at the start and touch on the way. */
    public static final int MET = -1;

    // With u = 2^-53 and M for the sum of the squares of offset q, way d and radii: the offset is off by u of itself,
    // so
    // q.q is off by 4u q.q, (q x d)^2 by 7u q.q d.d and r^2 d.d by 6u of itself. The offset q - d at the end is off by
    // u|q| + u|q - d|, its square by u q.q + 5u(q - d).(q - d) <= 11u q.q + 10u d.d. The stored end is off the way by
    // u|d|, which makes 2u q.q + 3u d.d more. A foot that is judged before the end, or behind it, for rounding is off
    // by
    // 3u|q|, which counts squared. The comparison itself adds 2u: at most 14u M of each, and 16u with the second order.
    private static final double FILTER = Filter.bound(16 * 0x1p-53);

    /** Ways whose squares are below this could lose products of four lengths to underflow. */
    private static final double SHORT = 0x1p-480;

    private DiscWay() {}

    /** Whether the kind is a disc as seen from above. */
    public static boolean isDisc(int kind) {
        return kind == Leaf.UPRIGHT_CYLINDER || kind == Leaf.SPHERE;
    }

    /** Whether disc i of a column, moved on by (dx, dz), meets disc j. */
    public static int past(LeafColumn column, int i, double dx, double dz, int j) {
        double[] rows = column.rows();
        int a = i * Leaf.STRIDE;
        int b = j * Leaf.STRIDE;
        double qx = rows[b] - rows[a];
        double qz = rows[b + 2] - rows[a + 2];
        double r = rows[a + 3] + rows[b + 3];
        double reach = r * r;
        double off = qx * qx + qz * qz;
        double way = dx * dx + dz * dz;
        double doubt = FILTER * (reach + off + way);
        if (!(off > reach + doubt && way > SHORT)) {
            return UNSURE;
        }
        double along = qx * dx + qz * dz;
        if (along <= 0) {
            return CLEAR;
        }
        if (along >= way) {
            double ex = qx - dx;
            double ez = qz - dz;
            double end = ex * ex + ez * ez;
            return end > reach + doubt ? CLEAR : end < reach - doubt ? MET : UNSURE;
        }
        double aside = qx * dz - qz * dx;
        double least = aside * aside;
        return least > (reach + doubt) * way ? CLEAR : least < (reach - doubt) * way ? MET : UNSURE;
    }
}
