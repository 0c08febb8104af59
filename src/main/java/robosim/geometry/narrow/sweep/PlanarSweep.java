package robosim.geometry.narrow.sweep;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sat.AxisBody;

/** The motion of one leaf's projection on XZ against another's at rest. */
public final class PlanarSweep {
    private PlanarSweep() {}

    /**
     * Time of the first contact when leaf a is translated by (dx, dz) during the time from 0 to 1.
     *
     * <p>If the two touch or overlap at the start there is no later contact, since convex sets that separate along a
     * line stay apart; then it is only decided whether the motion goes deeper at once, against every direction of least
     * penetration.
     *
     * @param dy ignored: heights do not count
     * @return the time of impact, from 0 to 1, rounded down; 0 if a motion from contact goes deeper; {@code +Infinity}
     *     if there is no contact up to time 1 (touching at time 1 counts), or a motion from contact goes along or away
     */
    public static double translation(Leaf a, double dx, double dy, double dz, Leaf b, SweepScratch s) {
        if (a.kind.isEnclosure() && b.kind.isEnclosure()) {
            return MovingPrism.time(true, a, dx, 0, dz, b);
        }
        if (a.kind.isPolytope()) {
            if (b.kind.isPolytope()) {
                return s.polytopes(AxisBody.Mode.PLANAR, a, dx, 0, dz, b);
            }
            if (b.kind.isDisc()) {
                return disc(b, -dx, -dz, a, s);
            }
        } else if (a.kind.isDisc() && (b.kind.isDisc() || b.kind.isPolytope())) {
            return disc(a, dx, dz, b, s);
        }
        return s.sweep().move.time(true, a, dx, 0, dz, b, s.overlap);
    }

    private static double disc(Leaf a, double dx, double dz, Leaf b, SweepScratch s) {
        double time = roughly(a, dx, dz, b, s);
        if (!Double.isNaN(time)) {
            return time;
        }
        return ExactDisc.of(a, dx, dz, b, null).time();
    }

    /** Time of contact of a disc in the plane; NaN if double-doubles cannot decide. */
    static double roughly(Leaf a, double dx, double dz, Leaf b, SweepScratch s) {
        MovingDisc disc = s.sweep().disc;
        return b.kind.isDisc()
                ? disc.discs(a, dx, dz, b, s.sweep().outline)
                : disc.polygon(a, dx, dz, b, s.sweep().outline);
    }

    /**
     * The free fraction of a turn of leaf a.
     *
     * <p>If the two touch or overlap at the start, the turn is blocked if the depth anywhere on the arc is above that
     * at the start. A gap below 2^-44 of the sizes may count as touching, and touching leaves may get deeper by as
     * much.
     *
     * @return the free fraction, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and at
     *     its end a gap of up to 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot may
     *     remain; {@code +Infinity} if the whole turn is free
     */
    public static double turn(Leaf a, PivotTurn turn, Leaf b, SweepScratch s) {
        if (turn.degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (turn.isLevel() && VerticalTurn.isCovered(a.kind) && VerticalTurn.isCovered(b.kind)) {
            VerticalTurn vertical = s.sweep().vertical;
            double free = vertical.free(a, turn, b, Double.POSITIVE_INFINITY);
            if (vertical.arc > 0 || !vertical.isApart) {
                return free;
            }
        }
        return s.sweep().turning.free(true, a, turn, b, s.overlap);
    }
}
