package robosim.geometry.narrow.turn;

import robosim.geometry.exact.Dyadic;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.Turn;
import robosim.geometry.narrow.leaf.Upright;

/** The turn of one leaf against another at rest, in space. */
public final class SpatialTurnSweep {
    private SpatialTurnSweep() {}

    /**
     * The free fraction of a turn of leaf a.
     *
     * <p>If the two touch or overlap at the start, the turn is blocked if the depth anywhere on the arc is above that
     * at the start.
     *
     * @return the free fraction, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and at
     *     its end a gap of up to 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot may
     *     remain; {@code +Infinity} if the whole turn is free
     */
    public static double free(Leaf a, Turn turn, Leaf b, TurnScratch s) {
        if (turn.degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        boolean isUpright = a.kind.isVerticalPrism() && b.kind.isVerticalPrism();
        if (turn.isLevel() && isUpright && VerticalTurn.isCovered(a.kind) && VerticalTurn.isCovered(b.kind)) {
            double mid = Upright.middle(a);
            double half = Upright.halfHeight(a);
            double top = Upright.top(a);
            double otherMid = Upright.middle(b);
            double otherHalf = Upright.halfHeight(b);
            double otherTop = Upright.top(b);
            if (Dyadic.signOfSum(mid, -half, -otherTop, -otherHalf) > 0
                    || Dyadic.signOfSum(otherMid, -otherHalf, -top, -half) > 0) {
                return Double.POSITIVE_INFINITY;
            }
            double depth = Math.min(otherTop + otherHalf - mid + half, top + half - otherMid + otherHalf);
            VerticalTurn vertical = s.turns().vertical;
            double free = vertical.free(a, turn, b, depth);
            if (vertical.arc > 0 || !vertical.isApart) {
                return free;
            }
            return s.turns().advancement.free(false, a, turn, b, s);
        }
        return s.turns().advancement.free(false, a, turn, b, s);
    }
}
