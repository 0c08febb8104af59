package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;

/** A world with a grid answers to the bit as the same world with a box for each of the occupied cells. */
@Tag("slow")
class GridAsBoxesTest {
    private static final double SIZE = 64;
    private static final int WORLDS = Effort.cases(40);
    private static final int QUESTIONS = 400;
    private static final double SPREAD = 6;

    private record Pair(Geometry grid, Geometry boxes) {
        void add(GeometryObject object) {
            assertThat(grid.addObjectUnchecked(object)).isEqualTo(boxes.addObjectUnchecked(object));
        }
    }

    private static GridObject grid(SplittableRandom random, double heading) {
        int columns = random.nextInt(1, 24);
        int rows = random.nextInt(1, 24);
        BitSet occupied = new BitSet();
        int density = random.nextInt(1, 20);
        for (int cell = 0; cell < columns * rows; cell++) {
            occupied.set(cell, random.nextInt(density + 1) == 0);
        }
        // A wall, along which one may slide and look.
        int row = random.nextInt(rows);
        occupied.set(row * columns, row * columns + random.nextInt(1, columns + 1));
        double cell = random.nextBoolean() ? random.nextInt(1, 9) / 8.0 : random.nextDouble(0.05, 1);
        Point center = random.nextBoolean()
                ? new Point(random.nextInt(-8, 9) / 8.0, random.nextInt(-4, 5) / 8.0, random.nextInt(-8, 9) / 8.0)
                : new Point(random.nextDouble(-3, 3), random.nextDouble(-1, 1), random.nextDouble(-3, 3));
        double height = random.nextInt(8) == 0 ? 0 : random.nextDouble(0.2, 3);
        return new GridObject(center, cell, height, columns, rows, occupied).turned(0, heading);
    }

    private static Pair worlds(Dimension dimension, GridObject grid, int others, SplittableRandom random) {
        Pair pair = new Pair(
                new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT),
                new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT));
        assertThat(pair.grid.addObjectUnchecked(grid)).isTrue();
        for (BoxObject box : RandomGrids.boxes(grid)) {
            assertThat(pair.boxes.addObjectUnchecked(box)).isTrue();
        }
        RandomObjects objects = new RandomObjects(random, SPREAD);
        for (int k = 0; k < others; k++) {
            GeometryObject object = objects.next();
            pair.add(k % 2 == 0 ? object.moveable("mover " + k) : object.named("object " + k));
        }
        return pair;
    }

    private static boolean isNamed(GeometryObject object) {
        return object.name() != null;
    }

    private static List<String> ask(Geometry world, long seed, List<Accuracy> levels) {
        return Script.run(world, QUESTIONS, seed, SPREAD, 0.25, levels, GridAsBoxesTest::isNamed);
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, 0",
        "PLANAR, 90",
        "PLANAR, -90",
        "PLANAR, 180",
        "PLANAR, 33",
        "SPATIAL, 0",
        "SPATIAL, 90",
        "SPATIAL, 180",
        "SPATIAL, -90",
        "SPATIAL, -71.3"
    })
    void aGridIsItsCells(Dimension dimension, double heading) {
        SplittableRandom random = new SplittableRandom(19 + (long) heading);
        int asked = 0;
        int byRounding = 0;
        for (int k = 0; k < WORLDS; k++) {
            GridObject grid = grid(random, heading);
            Pair pair = worlds(dimension, grid, random.nextInt(1, 12), random);
            long seed = random.nextLong();
            List<Accuracy> exact = List.of(Accuracy.EXACT);
            List<String> asGrid = ask(pair.grid, seed, exact);
            List<String> asBoxes = ask(pair.boxes, seed, exact);
            for (int line = 0; line < asBoxes.size(); line++) {
                String as = "world " + k + ", " + grid;
                asked++;
                if (asGrid.get(line).equals(asBoxes.get(line))) {
                    continue;
                }
                checkShares(as, asGrid.get(line).split(" "), asBoxes.get(line).split(" "));
                byRounding++;
                if (line < QUESTIONS && asGrid.get(line).contains(" dock ")) {
                    break; // the two stand an ulp apart from now on
                }
            }
        }
        assertThat(asked).isGreaterThan(WORLDS * QUESTIONS / 2);
        assertThat(byRounding).isLessThanOrEqualTo(asked / 500);
    }

    /**
     * A share is taken back by roundings until it has been verified beside the obstacle, which is the grid or one of its
     * boxes; so the share may differ in its last bits, and another cell may be the one that is named.
     */
    private static void checkShares(String as, String[] grid, String[] boxes) {
        assertThat(boxes[1]).as(as).isIn("move", "global", "dock");
        assertThat(grid[1] + grid[2] + grid[5]).as(as).isEqualTo(boxes[1] + boxes[2] + boxes[5]);
        for (int k = 3; k < 5; k++) {
            assertThat(Double.parseDouble(grid[k])).as(as).isCloseTo(Double.parseDouble(boxes[k]), within(0x1p-38));
        }
    }
}
