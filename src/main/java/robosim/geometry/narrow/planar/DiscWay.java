package robosim.geometry.narrow.planar;

import robosim.geometry.exact.Filter;

/**
 * Whether a disc that moves straight on meets another at rest, in plain doubles and only where these are certain: the
 * least distance of a point to a segment, squared, against the sum of the radii, squared.
 */
public final class DiscWay {
    /** Doubles cannot tell. */
    public static final int UNSURE = 0;

    /** The one blocks nothing: they are apart all the way and at its end, or overlap and go away from each other. */
    public static final int CLEAR = 1;

    /** The one blocks: they are apart at the start and touch on the way, or overlap and go deeper. */
    public static final int MET = -1;

    // With u = 2^-53: the offset q is off by u of itself, and the place p on the way d by u of itself, so q - p by
    // u(|q| + |d| + |q - p|), and its square by that doubled times |q - p| and 2u of itself: 7u q.q + u d.d, as q - p
    // is not longer than q. That p is not quite the foot counts squared. The stored end is off the way by u|d|, which
    // makes u q.q + u d.d more; the square of the radii is off by 3u of itself, and the comparison adds 2u.
    private static final double FILTER = Filter.bound(12 * 0x1p-53);

    // Each product of q and d is off by 2u of itself, their sum by u.
    private static final double FILTER_AHEAD = Filter.bound(4 * 0x1p-53);

    /** Ways whose squares are below this could lose too much of them to underflow. */
    private static final double SHORT = 0x1p-900;

    private DiscWay() {}

    /**
     * Whether what a disc encloses may move on by (dx, dz) for what another disc encloses, whose centre is off by
     * (qx, qz).
     *
     * @param reach the sum of the radii
     * @param slack how far the offset may be off, apart from half an ulp; and the sum of the radii, either way
     * @param isAll whether each disc is all that it encloses; else nothing is called met
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
