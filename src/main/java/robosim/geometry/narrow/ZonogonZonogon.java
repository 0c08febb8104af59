package robosim.geometry.narrow;

import robosim.geometry.exact.Filter;
import robosim.geometry.exact.Stages;

/** What two boxes at any attitude throw on the plane: each the sum of the segments that its own axes throw. */
final class ZonogonZonogon {
    // As for two rectangles, times the length of the axis, as an own axis may be almost upright: 3u of the offset; a
    // cross
    // product 2u, its product with a half size 1u, the sums within and of the two 3u, so 6u of the half sizes.
    private static final double SLACK = 1 + 0x1p-26;
    private static final double OFFSET = Filter.bound(SLACK * 3 * 0x1p-53);
    private static final double HALVES = Filter.bound(SLACK * 6 * 0x1p-53);
    private static final double UNDERFLOW = 0x1p-960;

    private static final Stages.Counter EXACT = Stages.counter("ZonogonZonogon");

    private ZonogonZonogon() {}

    /** Whether they touch or overlap; exact. */
    static boolean touch(int kindA, double[] a, int i, int kindB, double[] b, int j) {
        double dx = a[i] - b[j];
        double dz = a[i + 2] - b[j + 2];
        double error = OFFSET * (Math.abs(dx) + Math.abs(dz))
                + HALVES * ((a[i + 3] + a[i + 4] + a[i + 5]) + (b[j + 3] + b[j + 4] + b[j + 5]));
        int verdict = Math.max(apart(a, i, dx, dz, error, a, i, b, j), apart(b, j, dx, dz, error, a, i, b, j));
        return switch (verdict) {
            case 0 -> true;
            case 1 -> {
                EXACT.count();
                yield ExactPlanar.of(kindA, a, i).touches(ExactPlanar.of(kindB, b, j));
            }
            default -> false;
        };
    }

    // 2 apart along the normal of an own axis of one of the two, 1 in doubt, 0 overlapping along all of them
    private static int apart(
            double[] of, int at, double dx, double dz, double error, double[] a, int i, double[] b, int j) {
        int verdict = 0;
        for (int axis = 0; axis < 3; axis++) {
            double gx = of[at + Leaf.ROTATION + axis];
            double gz = of[at + Leaf.ROTATION + 6 + axis];
            if (gx == 0 && gz == 0) {
                continue; // upright: it throws a point
            }
            double gap = Math.abs(dx * gz - dz * gx) - (reach(a, i, gx, gz) + reach(b, j, gx, gz));
            double doubt = error * (Math.abs(gx) + Math.abs(gz)) + UNDERFLOW;
            if (gap > doubt) {
                return 2;
            }
            if (!(gap < -doubt)) {
                verdict = 1;
            }
        }
        return verdict;
    }

    private static double reach(double[] row, int at, double gx, double gz) {
        return row[at + 3] * Math.abs(row[at + 6] * gz - row[at + 12] * gx)
                + row[at + 4] * Math.abs(row[at + 7] * gz - row[at + 13] * gx)
                + row[at + 5] * Math.abs(row[at + 8] * gz - row[at + 14] * gx);
    }
}
