package robosim.geometry.narrow.planar;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * Two boxes at any attitude, projected: each projection is the sum of the projections of the box's own axes. Unlike {@link
 * PolygonPolygon} it needs no corners; {@code robosim.geometry.bench.SeparatingAxes} measures what that is worth.
 */
public final class ZonogonZonogon {
    // As for two rectangles, times the length of the axis, as an own axis may be almost upright: 3u of the offset. A
    // cross product 2u, its product with a half size 1u, the sums for each box and of both 3u: 6u of the half sizes.
    private static final double SLACK = 1 + 0x1p-26;
    private static final double OFFSET = FilterBound.bound(SLACK * 3 * 0x1p-53);
    private static final double HALVES = FilterBound.bound(SLACK * 6 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    private static final StageCounters.Counter FINE = StageCounters.counter("ZonogonZonogon fine");
    private static final StageCounters.Counter EXACT = StageCounters.counter("ZonogonZonogon");

    private ZonogonZonogon() {}

    /** Whether they touch or overlap; exact. */
    public static boolean touch(Leaf a, Leaf b, DoubleDoubleOverlap fine) {
        double dx = a.get(0) - b.get(0);
        double dz = a.get(2) - b.get(2);
        double error = OFFSET * (Math.abs(dx) + Math.abs(dz))
                + HALVES * ((a.get(3) + a.get(4) + a.get(5)) + (b.get(3) + b.get(4) + b.get(5)));
        int verdict = Math.max(apart(a, dx, dz, error, a, b), apart(b, dx, dz, error, a, b));
        if (verdict != 1) {
            return verdict == 0;
        }
        FINE.count();
        int side = Math.max(finely(a, dx, dz, error, a, b, fine), finely(b, dx, dz, error, a, b, fine));
        return side == 0 ? exactTouch(a, b) : side < 0;
    }

    private static boolean exactTouch(Leaf a, Leaf b) {
        EXACT.count();
        return ExactPolygon.of(a.kind, a.row, a.at).touches(ExactPolygon.of(b.kind, b.row, b.at));
    }

    // 2 apart along the normal of an own axis of either box, 1 in doubt, 0 overlapping along all normals
    private static int apart(Leaf of, double dx, double dz, double error, Leaf a, Leaf b) {
        int verdict = 0;
        for (int axis = 0; axis < 3; axis++) {
            double gx = of.get(Leaf.ROTATION + axis);
            double gz = of.get(Leaf.ROTATION + 6 + axis);
            if (gx == 0 && gz == 0) {
                continue; // upright: it projects to a point
            }
            double gap = gap(dx, dz, gx, gz, a, b);
            double doubt = doubt(error, gx, gz);
            if (gap > doubt) {
                return 2;
            }
            if (!(gap < -doubt)) {
                verdict = 1;
            }
        }
        return verdict;
    }

    // The answer of DoubleDoubleOverlap for those axes of one box that are in doubt.
    private static int finely(Leaf of, double dx, double dz, double error, Leaf a, Leaf b, DoubleDoubleOverlap fine) {
        int side = -1;
        for (int axis = 0; axis < 3; axis++) {
            double gx = of.get(Leaf.ROTATION + axis);
            double gz = of.get(Leaf.ROTATION + 6 + axis);
            if ((gx != 0 || gz != 0) && !(gap(dx, dz, gx, gz, a, b) < -doubt(error, gx, gz))) {
                side = Math.max(side, fine.along(gx, gz, a.row, a.at, b.row, b.at));
            }
        }
        return side;
    }

    private static double gap(double dx, double dz, double gx, double gz, Leaf a, Leaf b) {
        return Math.abs(dx * gz - dz * gx) - (reach(a.row, a.at, gx, gz) + reach(b.row, b.at, gx, gz));
    }

    private static double doubt(double error, double gx, double gz) {
        return error * (Math.abs(gx) + Math.abs(gz)) + UNDERFLOW;
    }

    private static double reach(double[] row, int at, double gx, double gz) {
        return row[at + 3] * Math.abs(row[at + 6] * gz - row[at + 12] * gx)
                + row[at + 4] * Math.abs(row[at + 7] * gz - row[at + 13] * gx)
                + row[at + 5] * Math.abs(row[at + 8] * gz - row[at + 14] * gx);
    }
}
