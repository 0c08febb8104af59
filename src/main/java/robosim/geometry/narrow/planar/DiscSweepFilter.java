package robosim.geometry.narrow.planar;

import robosim.geometry.exact.FilterBound;

/**
 * Whether a disc in straight motion meets another at rest, in plain doubles and only where these are certain: compares
 * the squared distance of a point from a segment with the squared sum of the radii.
 */
public final class DiscSweepFilter {
    /** Doubles cannot tell. */
    public static final int UNSURE = 0;

    /** No obstacle: the discs stay apart to the end, or overlap and separate. */
    public static final int CLEAR = 1;

    /** An obstacle: the discs are apart at the start and touch on the way, or overlap and go deeper. */
    public static final int MET = -1;

    // With u = 2^-53: the offset q is off by u of itself, and the point p of the motion d by u of itself, so q - p by
    // u(|q| + |d| + |q - p|). Its square is off by twice that times |q - p|, plus 2u of itself: 7u q.q + u d.d, as q -
    // p is no longer than q. The deviation of p from the true foot enters squared. The stored end deviates from the
    // motion by u|d|, which adds u q.q + u d.d. The squared sum of the radii is off by 3u of itself; the comparison
    // adds 2u.
    private static final double FILTER = FilterBound.bound(12 * 0x1p-53);

    // Each product of q and d is off by 2u of itself, their sum by u.
    private static final double FILTER_AHEAD = FilterBound.bound(4 * 0x1p-53);

    /** Squares of motions shorter than this could lose too much to underflow. */
    private static final double SHORT = 0x1p-900;

    // The same for three coordinates: a product and a sum more in each square, and in the product of q and d.
    private static final double FILTER_BALLS = FilterBound.bound(16 * 0x1p-53);
    private static final double FILTER_AHEAD_OF_BALLS = FilterBound.bound(6 * 0x1p-53);

    private DiscSweepFilter() {}

    /**
     * Whether a ball can move by (dx, dy, dz) past another one, whose centre is at offset (qx, qy, qz).
     *
     * @param reach the sum of the radii
     * @param slack the error of the sum of the radii in either direction, apart from its rounding
     */
    public static int pastBall(
            double qx, double qy, double qz, double dx, double dy, double dz, double reach, double slack) {
        double hull = reach + slack;
        double core = reach - slack;
        double off = qx * qx + qy * qy + qz * qz;
        double way = dx * dx + dy * dy + dz * dz;
        double doubt = FILTER_BALLS * (hull * hull + off + way);
        if (!(way > SHORT)) {
            return UNSURE;
        }
        double ahead = qx * dx + qy * dy + qz * dz;
        if (off > hull * hull + doubt) {
            double share = Math.max(0, Math.min(1, ahead / way));
            double ex = qx - share * dx;
            double ey = qy - share * dy;
            double ez = qz - share * dz;
            double least = ex * ex + ey * ey + ez * ez;
            return least > hull * hull + doubt ? CLEAR : least < core * core - doubt ? MET : UNSURE;
        }
        double doubtAhead = FILTER_AHEAD_OF_BALLS * (Math.abs(qx * dx) + Math.abs(qy * dy) + Math.abs(qz * dz)) + SHORT;
        boolean isCertain = core > 0 && off < core * core - doubt && Math.abs(ahead) > doubtAhead;
        return !isCertain ? UNSURE : ahead > 0 ? MET : CLEAR;
    }

    /**
     * Whether the contents of one disc can move by (dx, dz) past the contents of another disc, whose centre is at
     * offset (qx, qz).
     *
     * @param reach the sum of the radii
     * @param slack the error of the offset, apart from half an ulp, and of the sum of the radii, in either direction
     * @param isAll whether each disc is itself the object, not an enclosure; otherwise the answer is never {@link #MET}
     */
    public static int past(double qx, double qz, double dx, double dz, double reach, double slack, boolean isAll) {
        double hull = reach + slack + slack;
        double core = reach - slack - slack;
        double off = qx * qx + qz * qz;
        double way = dx * dx + dz * dz;
        double doubt = FILTER * (hull * hull + off + way);
        if (!(way > SHORT)) {
            return UNSURE;
        }
        double ahead = qx * dx + qz * dz;
        if (off > hull * hull + doubt) {
            double share = Math.max(0, Math.min(1, ahead / way));
            double ex = qx - share * dx;
            double ez = qz - share * dz;
            double least = ex * ex + ez * ez;
            return least > hull * hull + doubt
                    ? CLEAR
                    : isAll && core > 0 && least < core * core - doubt ? MET : UNSURE;
        }
        double span = Math.abs(dx) + Math.abs(dz);
        double doubtAhead = slack * span + FILTER_AHEAD * (Math.abs(qx * dx) + Math.abs(qz * dz));
        boolean isCertain = isAll && core > 0 && off < core * core - doubt && Math.abs(ahead) > doubtAhead;
        return !isCertain ? UNSURE : ahead > 0 ? MET : CLEAR;
    }
}
