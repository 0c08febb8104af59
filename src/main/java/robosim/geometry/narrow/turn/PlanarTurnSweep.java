package robosim.geometry.narrow.turn;

import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.Turn;

/** The turn of one leaf's projection on XZ against another's at rest. */
public final class PlanarTurnSweep {
    private PlanarTurnSweep() {}

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
    public static double free(Leaf a, Turn turn, Leaf b, TurnScratch s) {
        if (turn.degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (turn.isLevel() && VerticalTurn.isCovered(a.kind) && VerticalTurn.isCovered(b.kind)) {
            VerticalTurn vertical = s.turns().vertical;
            double free = vertical.free(a, turn, b, Double.POSITIVE_INFINITY);
            if (vertical.arc > 0 || !vertical.isApart) {
                return free;
            }
            return s.turns().advancement.free(true, a, turn, b, s);
        }
        return s.turns().advancement.free(true, a, turn, b, s);
    }
}
