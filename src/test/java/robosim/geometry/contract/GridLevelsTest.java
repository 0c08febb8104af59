package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** A coarser level adds contacts with a grid and shortens distances to it; it misses none. */
@Tag("slow")
class GridLevelsTest {
    private static final double SIZE = 64;
    private static final double SPREAD = 5;
    private static final int WORLDS = Effort.cases(24, 12);
    private static final int QUESTIONS = 60;

    /** More than distances are rounded by. */
    private static final double ROUNDING = 1e-13;

    private static double heading(SplittableRandom random) {
        return random.nextBoolean() ? 90 * random.nextInt(-1, 3) : random.nextDouble(-180, 180);
    }

    private static Geometry world(Dimension dimension, Accuracy accuracy, GridObject grid) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        assertThat(world.addObjectUnchecked(grid)).isTrue();
        return world;
    }

    private static Ray ray(RandomObjects objects) {
        return new Ray(objects.place(), objects.direction());
    }

    @ParameterizedTest
    @EnumSource
    void whatIsMetExactlyIsMetAtEachLevel(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(7 + dimension.ordinal());
        RandomObjects objects = new RandomObjects(random, SPREAD);
        int met = 0;
        int echoes = 0;
        int added = 0;
        for (int k = 0; k < WORLDS; k++) {
            GridObject grid = RandomGrids.next(random, heading(random));
            Geometry world = world(dimension, Accuracy.EXACT, grid);
            for (int q = 0; q < QUESTIONS; q++) {
                GeometryObject object = objects.next();
                Ray ray = ray(objects);
                double width = random.nextBoolean() ? 0 : random.nextDouble(120);
                boolean truth = world.testObject(object);
                double distance = world.getRayDistance(ray, 0, 1 / 0.0, width);
                met += truth ? 1 : 0;
                echoes += distance < 1 / 0.0 ? 1 : 0;
                for (Accuracy level : Accuracy.values()) {
                    String as = "%s %s, %s, %s".formatted(dimension, level, grid, grid.occupied());
                    boolean isMet = world.testObject(object, level);
                    assertThat(isMet || !truth).as("%s, %s", as, object).isTrue();
                    double atLevel = world.getRayDistance(ray, 0, 1 / 0.0, width, level);
                    assertThat(atLevel)
                            .as("%s, %s, width %s", as, ray, width)
                            .isLessThanOrEqualTo(distance + ROUNDING * (1 + distance));
                    added += isMet && !truth ? 1 : 0;
                }
            }
        }
        int asked = WORLDS * QUESTIONS;
        assertThat(met).isBetween(asked / 10, asked * 9 / 10);
        assertThat(echoes).isBetween(asked / 10, asked * 9 / 10);
        assertThat(added).isGreaterThan(asked / 50);
    }

    private static Move move(SplittableRandom random) {
        double far = random.nextInt(4) == 0 ? 0 : random.nextDouble(2);
        double turn = random.nextInt(3) == 0 ? 0 : random.nextDouble(-90, 90);
        double tip = random.nextInt(6) == 0 ? random.nextDouble(-60, 60) : 0;
        return new Move(far * random.nextDouble(-1, 1), 0, far * random.nextDouble(-1, 1), tip, turn);
    }

    @ParameterizedTest
    @EnumSource
    void whatALevelAllowsIsFree(Accuracy level) {
        SplittableRandom random = new SplittableRandom(17 + level.ordinal());
        RandomObjects objects = new RandomObjects(random, SPREAD);
        int allowed = 0;
        int refused = 0;
        for (int k = 0; k < WORLDS; k++) {
            Dimension dimension = k % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL;
            GridObject grid = RandomGrids.next(random, heading(random));
            Geometry alone = world(dimension, level, grid);
            for (int q = 0; q < QUESTIONS; q++) {
                GeometryObject body = objects.next().moveable("mover");
                Geometry world = world(dimension, level, grid);
                Geometry exact = world(dimension, Accuracy.EXACT, grid);
                if (!world.addObject(body)) {
                    continue;
                }
                assertThat(exact.addObject(body)).as("%s beside %s", body, grid).isTrue();
                for (int step = 0; step < 3; step++) {
                    GeometryObject before = world.getObject("mover");
                    exact.removeObject("mover");
                    exact.addObjectUnchecked(before);
                    Move move = move(random);
                    boolean docks = random.nextInt(3) == 0;
                    MoveResult result = docks ? world.moveToContact("mover", move, 0) : world.move("mover", move);
                    String as = "%s %s: %s by %s beside %s, %s"
                            .formatted(level, dimension, Paste.of(before), move, grid, grid.occupied());
                    if (result.allowed()) {
                        assertThat(exact.move("mover", move).allowed()).as(as).isTrue();
                    }
                    assertThat(alone.testObject(world.getObject("mover")))
                            .as("%s, there", as)
                            .isFalse();
                    allowed += result.allowed() ? 1 : 0;
                    refused += result.allowed() ? 0 : 1;
                }
            }
        }
        assertThat(allowed).isGreaterThan(WORLDS);
        assertThat(refused).isGreaterThan(WORLDS);
    }

    /** Along the axes a cell is its own enclosing box. */
    @ParameterizedTest
    @CsvSource({"AABB, PLANAR, 0", "AABB, SPATIAL, 90", "OBB, PLANAR, -90", "OBB, SPATIAL, 180", "OBB, SPATIAL, 0"})
    void boxesAnswerTheSame(Accuracy level, Dimension dimension, double heading) {
        SplittableRandom random = new SplittableRandom(27 + (long) heading);
        RandomObjects objects = new RandomObjects(random, SPREAD);
        int met = 0;
        int echoes = 0;
        int made = 0;
        int moves = 0;
        for (int k = 0; k < WORLDS / 2; k++) {
            GridObject grid = RandomGrids.next(random, heading);
            Geometry asGrid = world(dimension, level, grid);
            Geometry asBoxes = new Geometry(SIZE, SIZE, SIZE, dimension, level);
            for (BoxObject box : RandomGrids.boxes(grid)) {
                assertThat(asBoxes.addObjectUnchecked(box)).isTrue();
            }
            for (int q = 0; q < QUESTIONS; q++) {
                String as = "%s %s, %s, %s".formatted(dimension, level, grid, grid.occupied());
                GeometryObject object = objects.next();
                Ray ray = ray(objects);
                double width = random.nextBoolean() ? 0 : random.nextDouble(120);
                boolean isMet = asGrid.testObject(object);
                double distance = asGrid.getRayDistance(ray, 0, 1 / 0.0, width);
                assertThat(isMet).as("%s, %s", as, object).isEqualTo(asBoxes.testObject(object));
                assertThat(distance)
                        .as("%s, %s, width %s", as, ray, width)
                        .isEqualTo(asBoxes.getRayDistance(ray, 0, 1 / 0.0, width));
                met += isMet ? 1 : 0;
                echoes += distance < 1 / 0.0 ? 1 : 0;
                GeometryObject mover = object.moveable("mover");
                if (asGrid.addObject(mover)) {
                    assertThat(asBoxes.addObject(mover)).isTrue();
                    Point way = objects.place();
                    boolean isMade = asGrid.simpleMove("mover", way.x() / 4, 0, way.z() / 4);
                    assertThat(asBoxes.simpleMove("mover", way.x() / 4, 0, way.z() / 4))
                            .as("%s, %s by %s", as, mover, way)
                            .isEqualTo(isMade);
                    made += isMade ? 1 : 0;
                    moves++;
                    asGrid.removeObject("mover");
                    asBoxes.removeObject("mover");
                }
            }
        }
        int asked = WORLDS / 2 * QUESTIONS;
        assertThat(met).isBetween(asked / 10, asked * 9 / 10);
        assertThat(echoes).isBetween(asked / 10, asked * 9 / 10);
        assertThat(made).isBetween(moves / 20, moves * 19 / 20);
    }
}
