package robosim.geometry.viewer.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/** A grid in pictures: its cells, or where these are smaller than a pixel what shows each of them. */
class CellAreaTest {
    private static final int COLUMNS = 37;
    private static final int ROWS = 23;

    private static GridObject grid(SplittableRandom random, double heading) {
        BitSet occupied = new BitSet();
        for (int cell = 0; cell < COLUMNS * ROWS; cell++) {
            occupied.set(cell, random.nextInt(4) == 0);
        }
        return new GridObject(new Point(3, 1, -2), 0.25, 2, COLUMNS, ROWS, occupied).turned(0, heading);
    }

    private static CellArea area(GridObject grid) {
        return (CellArea) Footprint.of(grid).get(0);
    }

    private static int polygonsAt(List<double[]> polygons, double x, double y) {
        int count = 0;
        for (double[] corners : polygons) {
            boolean inside = true;
            for (int k = 0; k < 8; k += 2) {
                int next = (k + 2) % 8;
                double side = (corners[next] - corners[k]) * (y - corners[k + 1])
                        - (corners[next + 1] - corners[k + 1]) * (x - corners[k]);
                inside &= side > 0;
            }
            count += inside ? 1 : 0;
        }
        return count;
    }

    @Test
    void everyOccupiedCellIsInOnePolygonAndNoFreeOneIs() {
        SplittableRandom random = new SplittableRandom(1);
        for (double heading : new double[] {0, 90, 33, -120}) {
            GridObject grid = grid(random, heading);
            MapFrame frame = new MapFrame(Scene.View.around(List.of(grid)));
            List<double[]> polygons = area(grid).onPage(frame, null);
            assertThat(polygons.size()).isLessThan(grid.occupied().cardinality());
            for (int cell = 0; cell < COLUMNS * ROWS; cell++) {
                Point middle = grid.box(cell % COLUMNS, cell / COLUMNS).center();
                assertThat(polygonsAt(polygons, frame.x(middle), frame.y(middle)))
                        .as("cell %d at %s degrees", cell, heading)
                        .isEqualTo(grid.occupied().get(cell) ? 1 : 0);
            }
        }
    }

    @Test
    void onlyThePartThatIsShownIsDrawn() {
        GridObject grid = grid(new SplittableRandom(2), 20);
        MapFrame frame = new MapFrame(new Scene.View(3, -2, 4, -1, false));
        List<double[]> polygons = area(grid).onPage(frame, null);
        assertThat(polygons).hasSizeLessThan(40);
        int shown = 0;
        for (int cell = grid.occupied().nextSetBit(0);
                cell >= 0;
                cell = grid.occupied().nextSetBit(cell + 1)) {
            Point middle = grid.box(cell % COLUMNS, cell / COLUMNS).center();
            boolean isIn = middle.x() > 3 && middle.x() < 4 && middle.z() > -2 && middle.z() < -1;
            shown += isIn ? 1 : 0;
            if (isIn) {
                assertThat(polygonsAt(polygons, frame.x(middle), frame.y(middle)))
                        .isEqualTo(1);
            }
        }
        assertThat(shown).isGreaterThan(1);
        Bounds far = new Bounds(100, 0, 100, 101, 1, 101);
        assertThat(area(grid).onPage(frame, far)).isEmpty();
    }

    @Test
    void cellsSmallerThanAPixelAreDrawnTogetherAndNoneIsLost() {
        SplittableRandom random = new SplittableRandom(3);
        BitSet occupied = new BitSet();
        for (int k = 0; k < 60_000; k++) {
            occupied.set(random.nextInt(4_000_000));
        }
        GridObject grid = new GridObject(new Point(), 0.05, 2, 2000, 2000, occupied);
        MapFrame frame = new MapFrame(Scene.View.world(1000, 1000)); // a pixel is about a metre, 19 cells
        List<double[]> polygons = area(grid).onPage(frame, null);
        assertThat(polygons).hasSizeBetween(100, 11_100);
        double[] least = {1e9, 1e9, -1e9, -1e9};
        double covered = 0;
        for (double[] p : polygons) {
            covered += (p[2] - p[0]) * (p[5] - p[3]);
            for (int k = 0; k < 8; k += 2) {
                least[0] = Math.min(least[0], p[k]);
                least[1] = Math.min(least[1], p[k + 1]);
                least[2] = Math.max(least[2], p[k]);
                least[3] = Math.max(least[3], p[k + 1]);
            }
        }
        // Nearly all blocks have an occupied cell, and none reaches beyond the grid.
        assertThat(covered / Math.pow(100 * frame.scale, 2)).isBetween(0.98, 1.0 + 1e-9);
        assertThat(least[0]).isGreaterThanOrEqualTo(frame.x(-50) - 1e-9);
        assertThat(least[3]).isLessThanOrEqualTo(frame.y(50) + 1e-9);
        for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 9001)) {
            Point middle = grid.box(cell % 2000, cell / 2000).center();
            assertThat(polygonsAt(polygons, frame.x(middle), frame.y(middle))).isEqualTo(1);
        }
    }

    @Test
    void distancesAndDepthsAreThoseOfTheCellsAsBoxes() {
        SplittableRandom random = new SplittableRandom(4);
        int inside = 0;
        int far = 0;
        for (double heading : new double[] {0, 90, 33}) {
            GridObject grid = grid(random, heading);
            CellArea area = area(grid);
            for (int k = 0; k < Effort.cases(1000); k++) {
                double x = random.nextDouble(-4, 10);
                double z = random.nextDouble(-7, 4);
                double deepest = Double.NEGATIVE_INFINITY;
                double nearest = Double.POSITIVE_INFINITY;
                for (int cell = grid.occupied().nextSetBit(0);
                        cell >= 0;
                        cell = grid.occupied().nextSetBit(cell + 1)) {
                    BoxObject box = grid.box(cell % COLUMNS, cell / COLUMNS);
                    double depth = Footprint.depth(Footprint.of(box).get(0), x, z);
                    deepest = Math.max(deepest, depth);
                    double dx = x - box.center().x();
                    double dz = z - box.center().z();
                    double[] r = grid.rotation();
                    double u = Math.max(0, Math.abs(r[0] * dx + r[6] * dz) - 0.125);
                    double v = Math.max(0, Math.abs(r[2] * dx + r[8] * dz) - 0.125);
                    nearest = Math.min(nearest, Math.hypot(u, v));
                }
                if (deepest >= 0) {
                    assertThat(area.depth(x, z)).isCloseTo(deepest, within(1e-9));
                    assertThat(area.distance(x, z, 0)).isZero();
                    inside++;
                } else {
                    assertThat(area.depth(x, z)).isNegative();
                    double told = area.distance(x, z, 0.5);
                    assertThat(told).isCloseTo(nearest <= 0.5 ? nearest : Double.POSITIVE_INFINITY, within(1e-9));
                    far += told == Double.POSITIVE_INFINITY ? 1 : 0;
                }
            }
        }
        assertThat(inside).isBetween(Effort.cases(200), Effort.cases(1500));
        assertThat(far).isBetween(Effort.cases(200), Effort.cases(2500));
    }
}
