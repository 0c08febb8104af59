package robosim.geometry.index.cells;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;

/** Rectangles that stand or go straight, against a look at each occupied cell. */
class CellScanTest {
    private static final int RECTANGLES = Effort.cases(5000);

    enum Way {
        STANDS,
        GOES,
        GOES_ALONG_AXES,
        IS_ON_EDGES
    }

    private record Swept(double lowU, double lowV, double highU, double highV, double du, double dv) {
        /** Whether it touches a cell grown to all sides: its way, as a point, one that is grown by the rectangle. */
        boolean touches(int i, int j, double more) {
            double first = 0;
            double last = 1;
            double[] low = {i - more - highU, j - more - highV};
            double[] high = {i + 1 + more - lowU, j + 1 + more - lowV};
            double[] by = {du, dv};
            for (int k = 0; k < 2; k++) {
                if (by[k] == 0) {
                    if (low[k] > 0 || high[k] < 0) {
                        return false;
                    }
                    continue;
                }
                first = Math.max(first, Math.min(low[k] / by[k], high[k] / by[k]));
                last = Math.min(last, Math.max(low[k] / by[k], high[k] / by[k]));
            }
            return first <= last;
        }
    }

    private static Swept swept(Way way, int columns, int rows, SplittableRandom random) {
        boolean isDyadic = way == Way.IS_ON_EDGES;
        double lowU = random.nextDouble(-8, columns + 4);
        double lowV = random.nextDouble(-8, rows + 4);
        double width = random.nextInt(6) == 0 ? 0 : random.nextDouble(6);
        double length = random.nextInt(6) == 0 ? 0 : random.nextDouble(6);
        double du = way == Way.STANDS ? 0 : random.nextDouble(-20, 20);
        double dv = way == Way.STANDS ? 0 : random.nextDouble(-20, 20);
        if (way == Way.GOES_ALONG_AXES) {
            boolean isAlongU = random.nextBoolean();
            double tiny = random.nextBoolean() ? 0 : Math.scalb(random.nextDouble(-1, 1), -random.nextInt(60));
            du = isAlongU ? du : tiny;
            dv = isAlongU ? tiny : dv;
        }
        if (isDyadic) {
            return new Swept(
                    Math.rint(lowU),
                    Math.rint(lowV),
                    Math.rint(lowU) + Math.rint(width),
                    Math.rint(lowV) + Math.rint(length),
                    Math.rint(du),
                    Math.rint(dv));
        }
        return new Swept(lowU, lowV, lowU + width, lowV + length, du, dv);
    }

    /** What is touched is shown, once; nothing is shown that is more than a few slacks off. */
    @ParameterizedTest
    @EnumSource
    void showsWhatIsTouched(Way way) {
        SplittableRandom random = new SplittableRandom(21 + way.ordinal());
        CellScan scan = new CellScan();
        int touched = 0;
        int none = 0;
        for (int k = 0; k < RECTANGLES; k++) {
            int columns = random.nextInt(1, 30);
            int rows = random.nextInt(1, 30);
            BitSet occupied = ClearanceMapTest.random(columns * rows, Math.pow(random.nextDouble(), 3), random);
            Swept swept = swept(way, columns, rows, random);
            double slack = Math.scalb(1, -random.nextInt(4, 37));
            String as = "%d: %d x %d, %s, slack %s, %s".formatted(k, columns, rows, swept, slack, occupied);
            ClearanceMap map = new ClearanceMap(columns, rows, occupied);
            if (swept.du == 0 && swept.dv == 0) {
                scan.over(map).start(swept.lowU, swept.lowV, swept.highU, swept.highV, slack);
            } else {
                scan.over(map).start(swept.lowU, swept.lowV, swept.highU, swept.highV, swept.du, swept.dv, slack);
            }
            BitSet shown = new BitSet();
            for (int cell = scan.next(); cell >= 0; cell = scan.next()) {
                assertThat(shown.get(cell)).as("%s, %d twice", as, cell).isFalse();
                assertThat(occupied.get(cell)).as(as).isTrue();
                shown.set(cell);
                assertThat(swept.touches(cell % columns, cell / columns, 4 * slack))
                        .as("%s, shows %d", as, cell)
                        .isTrue();
            }
            assertThat(scan.next()).as("%s, over", as).isEqualTo(-1);
            for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
                if (swept.touches(cell % columns, cell / columns, slack / 2)) {
                    assertThat(shown.get(cell)).as("%s, misses %d", as, cell).isTrue();
                    touched++;
                }
            }
            none += shown.isEmpty() ? 1 : 0;
        }
        assertThat(touched).isGreaterThan(RECTANGLES / 2);
        assertThat(none).isBetween(RECTANGLES / 20, RECTANGLES * 9 / 10);
    }
}
