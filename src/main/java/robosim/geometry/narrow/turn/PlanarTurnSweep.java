package robosim.geometry.narrow.turn;

import robosim.geometry.narrow.leaf.LeafKind;

/** The turn of one leaf's projection on XZ against another's at rest. */
public final class PlanarTurnSweep {
    private PlanarTurnSweep() {}

    /**
     * The free share of a turn of leaf a by {@code degrees}, of any size and sign, about the axis of unit length
     * (wx, wy, wz) through (px, py, pz).
     *
     * <p>What touches or overlaps at the start blocks where the depth anywhere on the arc is above that at the start.
     * What starts nearer than 2^-44 of the sizes may count as touching, and what touches may get deeper by as much.
     *
     * @return the share that is free, from 0 up to, not including, 1, rounded down: the turn so far is proven free, and
     *     contact may be a gap of 2^-30 of the mover's radius and 2^-43 of both leaves' distances from the pivot away;
     *     {@code +Infinity} where all of the turn is free
     */
    public static double free(
            LeafKind kindA,
            double[] a,
            int i,
            double px,
            double py,
            double pz,
            double wx,
            double wy,
            double wz,
            double degrees,
            LeafKind kindB,
            double[] b,
            int j,
            TurnScratch s) {
        if (degrees == 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (wx == 0 && wz == 0 && VerticalTurn.isCovered(kindA) && VerticalTurn.isCovered(kindB)) {
            return s.turns()
                    .vertical
                    .free(kindA, a, i, px, pz, wy < 0 ? -degrees : degrees, kindB, b, j, Double.POSITIVE_INFINITY);
        }
        return s.turns().advancement.free(true, kindA, a, i, px, py, pz, wx, wy, wz, degrees, kindB, b, j, s);
    }
}
