package robosim.geometry.index.cells;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;

/** Lines through cells against a look at each occupied cell. */
class CellWalkTest {
    private static final int LINES = Effort.cases(6000);

    /** A line is off by less than this share of the slack: so {@code GridWalk} starts it. */
    private static final double ERROR = 0.25;

    /** What is shown is nearer to the line than so many slacks. */
    private static final double NEAR = 4;

    enum Way {
        ANY,
        ALONG_EDGES,
        THROUGH_CORNERS,
        NEAR_CORNERS,
        FLAT,
        ON_EDGES
    }

    /** A line with the part of it that is asked for. */
    private record Line(double u, double v, double du, double dv, double from, double to, double slack) {
        /** Where it enters a cell grown to all sides, as far as it is in [from, to]; +Infinity if it does not. */
        double enters(int i, int j, double more) {
            double first = from;
            double last = to;
            double[] at = {u, v};
            double[] by = {du, dv};
            double[] low = {i - more, j - more};
            for (int k = 0; k < 2; k++) {
                double high = low[k] + 1 + 2 * more;
                if (by[k] == 0) {
                    if (at[k] < low[k] || at[k] > high) {
                        return Double.POSITIVE_INFINITY;
                    }
                    continue;
                }
                double one = (low[k] - at[k]) / by[k];
                double other = (high - at[k]) / by[k];
                first = Math.max(first, Math.min(one, other));
                last = Math.min(last, Math.max(one, other));
            }
            return first <= last ? first : Double.POSITIVE_INFINITY;
        }

        boolean isOverGrid(int columns, int rows) {
            double atU = u + from * du;
            double atV = v + from * dv;
            return atU >= 0 && atU <= columns && atV >= 0 && atV <= rows;
        }
    }

    private static Line line(Way way, int columns, int rows, SplittableRandom random) {
        double slack = Math.scalb(1, -random.nextInt(4, 37));
        double u = random.nextDouble(-5, columns + 5);
        double v = random.nextDouble(-5, rows + 5);
        double angle = random.nextDouble(2 * Math.PI);
        double du = StrictMath.cos(angle);
        double dv = StrictMath.sin(angle);
        switch (way) {
            case ANY -> {}
            case ALONG_EDGES -> {
                boolean isAlongU = random.nextBoolean();
                double sign = random.nextBoolean() ? 1 : -1;
                du = isAlongU ? sign : 0;
                dv = isAlongU ? 0 : sign;
                u = isAlongU ? u : random.nextInt(columns + 1) + random.nextInt(-1, 2) * slack * ERROR;
                v = isAlongU ? random.nextInt(rows + 1) + random.nextInt(-1, 2) * slack * ERROR : v;
            }
            case THROUGH_CORNERS, NEAR_CORNERS -> {
                int p = random.nextInt(-3, 4);
                int q = p == 0 ? 1 : random.nextInt(-3, 4);
                double back = random.nextInt(16) / 4.0;
                double off = way == Way.THROUGH_CORNERS ? 0 : random.nextDouble(-3, 3) * slack;
                u = random.nextInt(columns + 1) - back * p;
                v = random.nextInt(rows + 1) - back * q + off;
                double length = random.nextBoolean() ? 1 : Math.hypot(p, q);
                du = p / length;
                dv = q / length;
            }
            case FLAT -> {
                double tiny = Math.scalb(random.nextDouble(-1, 1), -random.nextInt(3, 40));
                boolean isAlongU = random.nextBoolean();
                du = isAlongU ? (random.nextBoolean() ? 1 : -1) : tiny;
                dv = isAlongU ? tiny : random.nextBoolean() ? 1 : -1;
                u = isAlongU ? u : random.nextInt(columns + 1) - tiny * random.nextInt(rows);
                v = isAlongU ? random.nextInt(rows + 1) - tiny * random.nextInt(columns) : v;
            }
            case ON_EDGES -> {
                u = random.nextInt(columns + 1);
                v = random.nextBoolean() ? random.nextInt(rows + 1) : v;
            }
        }
        double scale = random.nextBoolean() ? 1 : Math.exp(random.nextDouble(-3, 3));
        double from = random.nextInt(4) == 0 ? random.nextDouble(8) / scale : 0;
        double to = random.nextInt(4) == 0 ? from + random.nextDouble(20) / scale : Double.POSITIVE_INFINITY;
        return new Line(u, v, du * scale, dv * scale, from, to, slack);
    }

    @ParameterizedTest
    @EnumSource
    void showsWhatTheLinePasses(Way way) {
        SplittableRandom random = new SplittableRandom(11 + way.ordinal());
        CellWalk walk = new CellWalk();
        int passed = 0;
        int beside = 0;
        int missed = 0;
        int cut = 0;
        for (int k = 0; k < LINES; k++) {
            int columns = random.nextInt(1, 30);
            int rows = random.nextInt(1, 30);
            BitSet occupied = ClearanceMapTest.random(columns * rows, Math.pow(random.nextDouble(), 3), random);
            Line line = line(way, columns, rows, random);
            double limit = limit(line, columns, occupied, random);
            boolean isShrinking = random.nextBoolean();
            String as = "%d: %d x %d, %s, limit %s, %s".formatted(k, columns, rows, line, limit, occupied);
            ClearanceMap map = new ClearanceMap(columns, rows, occupied);
            walk.over(map).start(line.u, line.v, line.du, line.dv, line.from, line.to, line.slack);
            List<Integer> shown = new ArrayList<>();
            for (int cell = walk.next(limit); cell >= 0; cell = walk.next(limit)) {
                assertThat(map.isOccupied(cell)).as(as).isTrue();
                shown.add(cell);
                assertThat(shown.size()).as("%s, ends", as).isLessThanOrEqualTo(4 * (columns + rows) + 4);
                if (isShrinking) {
                    limit = Math.min(limit, line.enters(cell % columns, cell / columns, 0));
                }
            }
            assertThat(walk.next(limit)).as("%s, over", as).isEqualTo(-1);
            for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
                double enters = line.enters(cell % columns, cell / columns, ERROR * line.slack);
                if (enters <= limit && enters < Double.POSITIVE_INFINITY) {
                    assertThat(shown)
                            .as(
                                    "%s, misses %d, column %d, row %d at %s, shows %s",
                                    as, cell, cell % columns, cell / columns, enters, shown)
                            .contains(cell);
                    passed++;
                    boolean isBeside = line.enters(cell % columns, cell / columns, -ERROR * line.slack) > 1e9;
                    beside += isBeside ? 1 : 0;
                } else if (enters < Double.POSITIVE_INFINITY) {
                    cut++;
                }
            }
            missed += shown.isEmpty() ? 1 : 0;
            checkNear(as, line, columns, rows, shown);
            checkOrder(as, line, columns, shown);
        }
        assertThat(passed).isGreaterThan(LINES / 2);
        assertThat(missed).isBetween(LINES / 50, LINES * 4 / 5);
        assertThat(cut).isGreaterThan(LINES / 20);
        if (way != Way.ANY && way != Way.ON_EDGES) {
            assertThat(beside).isGreaterThan(LINES / 50);
        }
    }

    /** None, any, or where the line enters a cell. */
    private static double limit(Line line, int columns, BitSet occupied, SplittableRandom random) {
        double[] enters = occupied.stream()
                .mapToDouble(cell -> line.enters(cell % columns, cell / columns, ERROR * line.slack))
                .filter(Double::isFinite)
                .toArray();
        return switch (random.nextInt(3)) {
            case 0 -> line.from + random.nextDouble(30) / Math.hypot(line.du, line.dv);
            case 1 -> enters.length == 0 ? line.from : enters[random.nextInt(enters.length)];
            default -> Double.POSITIVE_INFINITY;
        };
    }

    private static void checkNear(String as, Line line, int columns, int rows, List<Integer> shown) {
        if (line.from > 0 && !line.isOverGrid(columns, rows)) {
            return; // begins at an edge of the grid, wherever the line left that
        }
        for (int cell : shown) {
            double enters = line.enters(cell % columns, cell / columns, NEAR * line.slack);
            assertThat(enters)
                    .as("%s, shows %d, column %d, row %d", as, cell, cell % columns, cell / columns)
                    .isLessThan(Double.POSITIVE_INFINITY);
        }
    }

    /** No cell comes before one that the line has entered for certain before it. */
    private static void checkOrder(String as, Line line, int columns, List<Integer> shown) {
        double latest = 0;
        for (int cell : new LinkedHashSet<>(shown)) {
            double surely = line.enters(cell % columns, cell / columns, -NEAR * line.slack);
            assertThat(surely).as("%s, %d is late in %s", as, cell, shown).isGreaterThanOrEqualTo(latest);
            latest = Math.max(latest, line.enters(cell % columns, cell / columns, NEAR * line.slack));
        }
    }
}
