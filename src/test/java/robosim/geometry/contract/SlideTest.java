package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.reference.Reference;

/** Robots that live among walls for a long time. */
class SlideTest {
    private static final int STEPS = Effort.cases(25_000);
    private static final int TURNS = 50_000;
    private static final double CLEARANCE = 1e-3;
    private static final int WALLS = 12;

    private static List<GeometryObject> walls() {
        List<GeometryObject> walls = new ArrayList<>();
        for (int k = 0; k < WALLS; k++) {
            double angle = 360.0 / WALLS * k + 7;
            double x = 10 * StrictMath.cos(Math.toRadians(angle));
            double z = -10 * StrictMath.sin(Math.toRadians(angle));
            walls.add(new BoxObject(new Point(x, 0, z), 0.2, 2, 6).turned(0, angle));
        }
        return walls;
    }

    private static Geometry world(Dimension dimension, GeometryObject robot) {
        Geometry world = new Geometry(40, 10, 40, dimension, Accuracy.EXACT);
        walls().forEach(wall -> assertThat(world.addObjectUnchecked(wall)).isTrue());
        assertThat(world.addObject(robot)).isTrue();
        return world;
    }

    /**
     * Drives against oblique walls, stops with a clearance, goes on along what stopped it: a step along a wall is only
     * ever refused by another wall.
     */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aRobotSlidesAlongObliqueWalls(Dimension dimension) {
        for (GeometryObject robot : List.of(
                new CylinderObject(new Point(), 0.5, 1).moveable("robot"),
                new BoxObject(new Point(), 0.8, 1, 0.6).turned(0, 11).moveable("robot"))) {
            slide(dimension, robot);
        }
    }

    private static void slide(Dimension dimension, GeometryObject robot) {
        SplittableRandom random = new SplittableRandom(31);
        Geometry world = world(dimension, robot);
        double heading = random.nextDouble(360);
        int stops = 0;
        int slides = 0;
        for (int k = 0; k < STEPS / 2; k++) {
            double dx = 0.3 * StrictMath.cos(heading);
            double dz = 0.3 * StrictMath.sin(heading);
            GeometryObject start = world.getObject("robot");
            MoveResult result = world.moveToContact("robot", global(world, dx, dz), CLEARANCE);
            if (!result.allowed()) {
                stops++;
                // As far as asked from what it would have met, if it was before; what it passes by may be nearer.
                double gap = gap(dimension, world.getObject("robot"), result.obstacle());
                double before = gap(dimension, start, result.obstacle());
                assertThat(gap).as("step " + k).isGreaterThanOrEqualTo(Math.min(before, CLEARANCE) * (1 - 1e-9));
                if (before > CLEARANCE) {
                    assertThat(gap)
                            .as("step " + k + " " + start + " " + result + " before " + before + " now "
                                    + world.getObject("robot"))
                            .isLessThanOrEqualTo(CLEARANCE * (1 + 1e-6));
                }
                slides += slideAlong(world, result, dx, dz, k) ? 1 : 0;
                heading += random.nextDouble(0.5, 1.5);
            }
            if (k % 500 == 0) {
                noneIsOverlapped(world, dimension);
            }
        }
        assertThat(stops).isGreaterThan(STEPS / 100);
        assertThat(slides).isGreaterThan(stops / 2);
    }

    private static double gap(Dimension dimension, GeometryObject robot, GeometryObject other) {
        Geometry two = new Geometry(40, 10, 40, dimension, Accuracy.EXACT);
        assertThat(two.addObject(robot)).isTrue();
        assertThat(two.addObject(other)).isTrue();
        return two.getProximity("robot", 100);
    }

    private static Move global(Geometry world, double dx, double dz) {
        double[] r = world.getObject("robot").rotation();
        return new Move(r[0] * dx + r[6] * dz, 0, r[2] * dx + r[8] * dz, 0, 0);
    }

    /** The part of a step that goes along the wall it met, and a hair away from it. */
    private static boolean slideAlong(Geometry world, MoveResult met, double dx, double dz, int k) {
        Point n = met.normal();
        double into = dx * n.x() + dz * n.z();
        double alongX = dx - into * n.x() + 1e-9 * n.x();
        double alongZ = dz - into * n.z() + 1e-9 * n.z();
        MoveResult along = world.moveGlobal("robot", new Move(alongX, 0, alongZ, 0, 0));
        if (!along.allowed()) {
            assertThat(along.obstacle())
                    .as("step " + k + ": " + met + ", " + along)
                    .isNotEqualTo(met.obstacle());
        }
        return along.allowed();
    }

    private static void noneIsOverlapped(Geometry world, Dimension dimension) {
        GeometryObject robot = world.getObject("robot");
        for (GeometryObject wall : world.objects()) {
            if (!wall.isMoveable()) {
                assertThat(Reference.overlap(robot, wall, dimension))
                        .as(robot + " in " + wall)
                        .isFalse();
            }
        }
    }

    /** Simple moves by random steps: a step is refused where the oracle says that its end or its way is not free. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aRobotWandersWithSimpleMoves(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(32);
        Geometry world = world(dimension, new CylinderObject(new Point(), 0.5, 1).moveable("robot"));
        int refused = 0;
        for (int k = 0; k < STEPS; k++) {
            GeometryObject before = world.getObject("robot");
            if (world.simpleMove("robot", 0.2, 0, 0)) {
                if (k % 500 == 0) {
                    noneIsOverlapped(world, dimension);
                }
                continue;
            }
            refused++;
            assertThat(world.getObject("robot")).isEqualTo(before);
            double gap = world.getProximity("robot", 100);
            assertThat(gap).as("step " + k).isBetween(0.0, 0.2);
            // A round robot turns in any corner.
            assertThat(world.simpleTurn("robot", random.nextDouble(-170, 170)))
                    .as("step " + k)
                    .isTrue();
        }
        assertThat(refused).isBetween(STEPS / 100, STEPS * 3 / 4);
    }

    /** A closed path of moves and turns ends where it began. */
    @Test
    void aClosedPathReturns() {
        Geometry world = new Geometry(100, 10, 100);
        BoxObject robot =
                new BoxObject(new Point(1, 0, 2), 1, 1, 0.5).turned(0, 13).moveable("robot");
        assertThat(world.addObject(robot)).isTrue();
        for (int k = 0; k < TURNS; k++) {
            assertThat(world.simpleMove("robot", 0.01, 0, 0)).isTrue();
            assertThat(world.simpleTurn("robot", k % 2 == 0 ? 0.1 : 0.62)).isTrue();
        }
        // 50,000 turns of 0.36 degrees on average are 50 circles.
        GeometryObject back = world.getObject("robot");
        assertThat(Math.IEEEremainder(back.heading() - robot.heading(), 360)).isBetween(-1e-9, 1e-9);
        assertThat(back.center().x()).isBetween(1 - 1e-9, 1 + 1e-9);
        assertThat(back.center().z()).isBetween(2 - 1e-9, 2 + 1e-9);
    }
}
