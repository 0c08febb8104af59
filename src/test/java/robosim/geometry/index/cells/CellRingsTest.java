package robosim.geometry.index.cells;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;

/** Cells around a rectangle, and in a sector, against a look at each occupied one. */
class CellRingsTest {
    private static final int SEARCHES = Effort.cases(5000);

    private record Rectangle(double lowU, double lowV, double highU, double highV) {
        private double offU(int i) {
            return Math.max(0, Math.max(i - highU, lowU - i - 1));
        }

        private double offV(int j) {
            return Math.max(0, Math.max(j - highV, lowV - j - 1));
        }

        double distance(int i, int j) {
            return Math.hypot(offU(i), offV(j));
        }

        double asAKing(int i, int j) {
            return Math.max(offU(i), offV(j));
        }
    }

    /** Two half planes with a common point on their borders; normals point outward, and one that is 0 is no border. */
    private record Sector(double u, double v, double leftU, double leftV, double rightU, double rightV) {
        /** Whether a cell has a point in it, by cutting the square. */
        boolean holds(int i, int j) {
            List<double[]> square = List.of(
                    new double[] {i, j}, new double[] {i + 1, j}, new double[] {i + 1, j + 1}, new double[] {i, j + 1});
            return !cut(cut(square, leftU, leftV), rightU, rightV).isEmpty();
        }

        private double side(double[] point, double normalU, double normalV) {
            return normalU * (point[0] - u) + normalV * (point[1] - v);
        }

        private List<double[]> cut(List<double[]> polygon, double normalU, double normalV) {
            List<double[]> left = new ArrayList<>();
            for (int k = 0; k < polygon.size(); k++) {
                double[] one = polygon.get(k);
                double[] next = polygon.get((k + 1) % polygon.size());
                double s = side(one, normalU, normalV);
                double t = side(next, normalU, normalV);
                if (s <= 0) {
                    left.add(one);
                }
                if (s < 0 != t < 0 && s != t) {
                    double at = s / (s - t);
                    left.add(new double[] {one[0] + at * (next[0] - one[0]), one[1] + at * (next[1] - one[1])});
                }
            }
            return left;
        }

        /** Whether a cell is wholly beyond one of the borders, by more than a margin. */
        boolean isBeyond(int i, int j, double margin) {
            double left = Double.POSITIVE_INFINITY;
            double right = Double.POSITIVE_INFINITY;
            for (int corner = 0; corner < 4; corner++) {
                double[] at = {i + (corner & 1), j + (corner >> 1)};
                left = Math.min(left, side(at, leftU, leftV));
                right = Math.min(right, side(at, rightU, rightV));
            }
            return left > margin || right > margin;
        }
    }

    private static double place(int count, SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> random.nextInt(-2, count + 3);
            case 1 -> random.nextDouble(-60, count + 60);
            default -> random.nextDouble(count);
        };
    }

    private static Sector sector(Rectangle apex, SplittableRandom random) {
        double heading = random.nextInt(3) == 0 ? Math.PI / 4 * random.nextInt(8) : random.nextDouble(2 * Math.PI);
        double half = random.nextInt(3) == 0 ? random.nextDouble(0.05) : random.nextDouble(Math.PI / 2);
        double leftU = -StrictMath.sin(heading + half);
        double leftV = StrictMath.cos(heading + half);
        double rightU = StrictMath.sin(heading - half);
        double rightV = -StrictMath.cos(heading - half);
        boolean isHalfPlane = random.nextInt(8) == 0;
        return new Sector(
                apex.lowU, apex.lowV, leftU, leftV, isHalfPlane ? 0 : 2.5 * rightU, isHalfPlane ? 0 : 2.5 * rightV);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void showsAllThatAreNear(boolean hasSector) {
        SplittableRandom random = new SplittableRandom(hasSector ? 31 : 32);
        CellRings rings = new CellRings();
        int near = 0;
        int far = 0;
        int leftOut = 0;
        for (int k = 0; k < SEARCHES; k++) {
            int columns = random.nextInt(1, 30);
            int rows = random.nextInt(1, 30);
            BitSet occupied = ClearanceMapTest.random(columns * rows, Math.pow(random.nextDouble(), 4), random);
            ClearanceMap map = new ClearanceMap(columns, rows, occupied);
            double u = place(columns, random);
            double v = place(rows, random);
            boolean isPoint = hasSector || random.nextInt(4) == 0;
            Rectangle around =
                    new Rectangle(u, v, isPoint ? u : u + random.nextDouble(9), isPoint ? v : v + random.nextDouble(9));
            double slack = Math.scalb(1, -random.nextInt(4, 33));
            double limit = random.nextBoolean() ? 100 : random.nextDouble(20);
            boolean isShrinking = random.nextBoolean();
            Sector sector = hasSector ? sector(around, random) : new Sector(0, 0, 0, 0, 0, 0);
            String as = "%d: %d x %d, %s, %s, slack %s, limit %s, %s"
                    .formatted(k, columns, rows, around, sector, slack, limit, occupied);
            rings.start(map, around.lowU, around.lowV, around.highU, around.highV, slack);
            if (hasSector) {
                rings.sector(sector.u, sector.v, sector.leftU, sector.leftV, sector.rightU, sector.rightV);
            }
            BitSet shown = new BitSet();
            double farthest = 0;
            for (int cell = rings.next(limit); cell >= 0; cell = rings.next(limit)) {
                int i = cell % columns;
                int j = cell / columns;
                assertThat(shown.get(cell)).as("%s, %d twice", as, cell).isFalse();
                assertThat(occupied.get(cell)).as(as).isTrue();
                shown.set(cell);
                double steps = around.asAKing(i, j);
                assertThat(steps).as("%s, %d is late", as, cell).isGreaterThan(farthest - 1 - 2 * slack);
                assertThat(steps).as("%s, %d is far", as, cell).isLessThan(limit + 1 + 2 * slack);
                assertThat(sector.isBeyond(i, j, 9 * slack))
                        .as("%s, %d is beyond", as, cell)
                        .isFalse();
                farthest = Math.max(farthest, steps);
                if (isShrinking) {
                    limit = Math.min(limit, around.distance(i, j));
                }
            }
            assertThat(rings.next(limit)).as("%s, over", as).isEqualTo(-1);
            for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
                int i = cell % columns;
                int j = cell / columns;
                if (!sector.holds(i, j)) {
                    leftOut++;
                } else if (around.distance(i, j) <= limit) {
                    assertThat(shown.get(cell)).as("%s, misses %d", as, cell).isTrue();
                    near++;
                } else {
                    far++;
                }
            }
        }
        assertThat(near).isGreaterThan(SEARCHES);
        assertThat(far).isGreaterThan(SEARCHES);
        assertThat(leftOut).isGreaterThanOrEqualTo(hasSector ? SEARCHES : 0);
    }

    /** A rectangle far outside, or far larger than the grid. */
    @Test
    void farAndLarge() {
        BitSet occupied = new BitSet();
        occupied.set(0);
        occupied.set(11);
        ClearanceMap map = new ClearanceMap(4, 3, occupied);
        CellRings rings = new CellRings();
        for (double far : new double[] {1e6, -1e6, 1e300, -1e300}) {
            rings.start(map, far, 0, far, 0, 0.01);
            BitSet shown = new BitSet();
            for (int cell = rings.next(1 / 0.0); cell >= 0; cell = rings.next(1 / 0.0)) {
                shown.set(cell);
            }
            assertThat(shown).as("from %s", far).isEqualTo(occupied);
        }
        rings.start(map, -1e5, -1e5, 1e5, 1e5, 0.01);
        assertThat(rings.next(0)).isEqualTo(0);
        assertThat(rings.next(0)).isEqualTo(11);
        assertThat(rings.next(0)).isEqualTo(-1);
    }
}
