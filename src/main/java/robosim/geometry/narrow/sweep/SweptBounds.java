package robosim.geometry.narrow.sweep;

import robosim.geometry.exact.Degrees;
import robosim.geometry.exact.UpwardRounding;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.leaf.UnderflowScaling;

/** Axis-aligned bounds of a leaf over a whole motion, rounded outward: the leaf never leaves them. */
public final class SweptBounds {
    private SweptBounds() {}

    /** Writes minimum x, y, z and maximum x, y, z of a leaf over a translation. */
    public static void translation(Leaf leaf, double dx, double dy, double dz, double[] out6) {
        LeafBounds.of(leaf.kind, leaf.row, leaf.at, out6);
        moved(out6, 0, dx, dy, dz, out6);
    }

    /**
     * Writes the bounds over a translation, given those at its start. Outward rounding is monotonic, so sweeping the
     * joint bounds of many leaves gives the same bits as joining the swept bounds of each.
     */
    private static void moved(double[] bounds, int at, double dx, double dy, double dz, double[] out6) {
        for (int k = 0; k < 3; k++) {
            double d = k == 0 ? dx : k == 1 ? dy : dz;
            out6[k] = -UpwardRounding.sum(-bounds[at + k], Math.max(0, -d));
            out6[k + 3] = UpwardRounding.sum(bounds[at + 3 + k], Math.max(0, d));
        }
    }

    /**
     * Writes minimum x, y, z and maximum x, y, z of a leaf over a turn by {@code degrees} about the axis of unit length
     * (wx, wy, wz) through (px, py, pz).
     *
     * <p>A bound that the turn does not extend is that of the leaf at the start; others are tight to within rounding,
     * for cylinders that tilt to 2^-36 of their distance from the pivot.
     */
    public static void turn(Leaf leaf, PivotTurn turn, double[] out6, SweepScratch s) {
        LeafBounds.of(leaf.kind, leaf.row, leaf.at, out6);
        if (turn.degrees == 0) {
            return;
        }
        UnderflowScaling m = s.leaf.scaling;
        if (!m.take(Dimension.SPATIAL, VectorMath.largest(turn.px, turn.py, turn.pz), leaf.kind, leaf.row, leaf.at)) {
            extend(leaf, turn, out6, s);
            return;
        }
        for (int k = 0; k < 6; k++) {
            out6[k] = m.up(out6[k]);
        }
        extend(m.first, m.up(turn), out6, s);
        for (int k = 0; k < 3; k++) {
            out6[k] = -m.ceiling(-out6[k]);
            out6[k + 3] = m.ceiling(out6[k + 3]);
        }
    }

    private static void extend(Leaf leaf, PivotTurn turn, double[] out6, SweepScratch s) {
        TurningLeaf body = s.sweep().body;
        double sign = turn.degrees < 0 ? -1 : 1;
        body.load(leaf, turn);
        double lost = lost(leaf, turn);
        // The stored end is at that angle to within rounding.
        double angle = Degrees.toRadians(Math.abs(turn.degrees)) * (1 + 0x1p-50) + TurningPolygon.MARGIN;
        for (int k = 0; k < 3; k++) {
            double x = k == 0 ? 1 : 0;
            double y = k == 1 ? 1 : 0;
            double z = k == 2 ? 1 : 0;
            double pivot = k == 0 ? turn.px : k == 1 ? turn.py : turn.pz;
            body.aim(x, y, z, sign);
            double most = body.greatest(angle, pivot, out6[k + 3]);
            out6[k + 3] = most > out6[k + 3] ? most + lost : most;
            body.aim(-x, -y, -z, sign);
            double least = body.greatest(angle, -pivot, -out6[k]);
            out6[k] = -(least > -out6[k] ? least + lost : least);
        }
    }

    /**
     * What a rim's reach loses in doubles where the cylinder is turned off a direction along its axis by less than can be told
     * from the cosine; 0 for an upright cylinder that stays upright, and for other leaves.
     */
    private static double lost(Leaf leaf, PivotTurn turn) {
        boolean hasRims = leaf.kind == LeafKind.CYLINDER || (leaf.kind == LeafKind.UPRIGHT_CYLINDER && !turn.isLevel());
        return hasRims ? 0x1p-25 * leaf.get(Leaf.SIZE) : 0;
    }

    /**
     * Extends the bounds of x + z (two numbers) and of x - z (two more), which hold at the start, to hold for the leaf
     * anywhere on a turn.
     */
    public static void turnDiagonals(Leaf leaf, PivotTurn turn, double[] out4, SweepScratch s) {
        if (turn.degrees == 0) {
            return;
        }
        UnderflowScaling m = s.leaf.scaling;
        if (!m.take(Dimension.SPATIAL, VectorMath.largest(turn.px, turn.py, turn.pz), leaf.kind, leaf.row, leaf.at)) {
            extendDiagonals(leaf, turn, out4, s);
            return;
        }
        for (int k = 0; k < 4; k++) {
            out4[k] = m.up(out4[k]);
        }
        extendDiagonals(m.first, m.up(turn), out4, s);
        for (int k = 0; k < 4; k += 2) {
            out4[k] = -m.ceiling(-out4[k]);
            out4[k + 1] = m.ceiling(out4[k + 1]);
        }
    }

    private static void extendDiagonals(Leaf leaf, PivotTurn turn, double[] out4, SweepScratch s) {
        TurningLeaf body = s.sweep().body;
        double sign = turn.degrees < 0 ? -1 : 1;
        body.load(leaf, turn);
        double angle = Degrees.toRadians(Math.abs(turn.degrees)) * (1 + 0x1p-50) + TurningPolygon.MARGIN;
        for (int k = 0; k < 2; k++) {
            double z = k == 0 ? VectorMath.HALF_ROOT : -VectorMath.HALF_ROOT;
            double pivot = VectorMath.HALF_ROOT * turn.px + z * turn.pz;
            double slack = 0x1p-48 * (Math.abs(turn.px) + Math.abs(turn.pz));
            body.aim(VectorMath.HALF_ROOT, 0, z, sign);
            out4[2 * k + 1] = diagonal(body, angle, pivot, out4[2 * k + 1], slack);
            body.aim(-VectorMath.HALF_ROOT, 0, -z, sign);
            out4[2 * k] = -diagonal(body, angle, -pivot, -out4[2 * k], slack);
        }
    }

    // The direction has unit length; a diagonal is the root of two longer.
    private static double diagonal(TurningLeaf body, double angle, double pivot, double start, double slack) {
        double from = VectorMath.HALF_ROOT * start;
        double to = body.greatest(angle, pivot, from);
        return to > from ? (to + slack + 0x1p-48 * Math.abs(to)) / VectorMath.HALF_ROOT : start;
    }
}
