package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.SlideOptions;
import robosim.geometry.SlideResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.WorldReader;

/** Robots that follow walls for an hour, and what stops them in corners, doorways and between posts. */
class WallFollowerTest {
    /** An hour of ten steps a second; an ordinary build drives a quarter of it. */
    private static final int STEPS = Effort.cases(36_000);

    private static final double STEP = 0.04;
    private static final int WINDOW = 300;

    @ParameterizedTest
    @ValueSource(strings = {"rooms.xml", "maze.xml", "grid"})
    void anHourAlongTheWalls(String file) throws Exception {
        SplittableRandom random = new SplittableRandom(97);
        int robots = 0;
        for (double clearance : new double[] {0, 0.01}) {
            for (int shape = 0; shape < 4; shape++) {
                Geometry world = file.equals("grid") ? grid(random) : read(file);
                robots += follow(world, robot(shape), clearance, file + " robot " + shape, random) ? 1 : 0;
            }
        }
        assertThat(robots).isEqualTo(8);
    }

    private static Geometry read(String file) throws Exception {
        Geometry world = WorldReader.read(Path.of("worlds", file)).toGeometry();
        for (GeometryObject object : world.objects()) {
            if (object.isMoveable()) {
                world.removeObject(object.name());
            }
        }
        return world;
    }

    /** A map of rooms with crooked walls, as a robot that maps a building makes it. */
    private static Geometry grid(SplittableRandom random) {
        int n = 240;
        BitSet cells = new BitSet();
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                boolean isWall = row % 60 < 2 || column % 60 < 2 || row == n - 1 || column == n - 1;
                boolean isDoor = row > 1
                        && column > 1
                        && (row % 60 + column % 60) % 60 > 20
                        && (row % 60 + column % 60) % 60 < 40;
                boolean isEdge = row < 2 || column < 2 || row == n - 1 || column == n - 1;
                if ((isWall && (isEdge || !isDoor)) || random.nextInt(400) == 0) {
                    cells.set(row * n + column);
                    if (isWall && random.nextInt(5) == 0) {
                        cells.set(Math.min(n - 1, row + 1) * n + column);
                    }
                }
            }
        }
        Geometry world = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
        assertThat(world.addObject(new GridObject(new Point(), 0.05, 1, n, n, cells).named("map")))
                .isTrue();
        return world;
    }

    private static GeometryObject robot(int shape) {
        GeometryObject body = switch (shape) {
            case 0 -> new CylinderObject(new Point(), 0.2, 0.4);
            case 1 -> new BoxObject(new Point(), 0.4, 0.4, 0.3);
            case 2 -> new CapsuleObject(new Point(), 0.2, 0.1);
            default ->
                new ObjectGroup(List.of(
                        new BoxObject(new Point(), 0.3, 0.3, 0.2), new SphereObject(new Point(0.2, 0, 0), 0.08)));
        };
        return body.moveable("robot");
    }

    /** Pushes along the wall on its right, and turns left by up to a quarter where it is stopped. */
    private static boolean follow(
            Geometry world, GeometryObject robot, double clearance, String what, SplittableRandom random) {
        GeometryObject at = robot;
        do {
            at = robot.movedTo(new Point(
                    random.nextDouble(-world.width() / 2, world.width() / 2),
                    world.dimension() == Dimension.PLANAR ? 0 : -world.height() / 2 + 0.5,
                    random.nextDouble(-world.length() / 2, world.length() / 2)));
        } while (!world.addObject(at));
        SlideOptions options = SlideOptions.clearance(clearance);
        double heading = random.nextDouble(360);
        double made = 0;
        double y = world.getObject("robot").center().y();
        for (int k = 0; k < STEPS; k++) {
            double x = STEP * StrictMath.cos(StrictMath.toRadians(heading));
            double z = -STEP * StrictMath.sin(StrictMath.toRadians(heading));
            SlideResult result = world.moveAndSlide("robot", new Move(x, 0, z, 0, 0), options);
            made += result.length();
            if (result.length() < STEP / 10) {
                assertThat(result.contacts())
                        .as("%s step %d: %s", what, k, result)
                        .isNotEmpty();
                heading += random.nextDouble(60, 90);
            } else {
                Point by = result.made();
                heading = StrictMath.toDegrees(StrictMath.atan2(-by.z(), by.x())) - 15;
            }
            if (k % WINDOW == WINDOW - 1) {
                assertThat(made)
                        .as("%s clearance %s after step %d at %s", what, clearance, k, world.getObject("robot"))
                        .isGreaterThan(WINDOW * STEP / 4);
                made = 0;
            }
        }
        assertThat(world.getObject("robot").center().y()).as(what).isEqualTo(y);
        return true;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aCornerStopsItOnlyWhereNothingIsLeftAndNamesBothWalls(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(98);
        for (int k = 0; k < 60; k++) {
            double clearance = k % 2 == 0 ? 0 : 0.03;
            double heading = random.nextDouble(360);
            double half = random.nextDouble(20, 80);
            Geometry world = new Geometry(60, 10, 60, dimension, Accuracy.EXACT);
            wall(world, heading + half, 1, "left");
            wall(world, heading - half, -1, "right");
            Point tip = along(heading, 2);
            assertThat(world.addObject(robot(k % 4).movedTo(tip))).isTrue();
            Point in = along(heading, -0.05);
            SlideResult result = null;
            for (int step = 0; step < 100; step++) {
                result = world.moveAndSlide("robot", new Move(in.x(), 0, in.z(), 0, 0), clearance, 8);
            }
            String what =
                    "%s heading %s half %s clearance %s: %s".formatted(dimension, heading, half, clearance, result);
            assertThat(result.length()).as(what).isLessThan(1e-6);
            List<String> named =
                    result.contacts().stream().map(c -> c.obstacle().name()).toList();
            assertThat(named).as(what).anyMatch(name -> name.startsWith("left"));
            assertThat(named).as(what).anyMatch(name -> name.startsWith("right"));
            // It is free to go back out, and along either wall away from the corner.
            Point out = along(heading, 0.05);
            assertThat(world.move("robot", new Move(out.x(), 0, out.z(), 0, 0)).allowed())
                    .as(what)
                    .isTrue();
        }
    }

    private static Point along(double heading, double far) {
        return new Point(
                far * StrictMath.cos(StrictMath.toRadians(heading)),
                0,
                -far * StrictMath.sin(StrictMath.toRadians(heading)));
    }

    /** A wall of tiles from the origin along a heading, on the outer side of the wedge. */
    private static void wall(Geometry world, double heading, int side, String name) {
        for (int k = -1; k < 30; k++) {
            Point middle = along(heading, 0.5 * k + 0.25);
            Point out = along(heading + 90 * side, 0.25);
            BoxObject tile = new BoxObject(new Point(middle.x() + out.x(), 0, middle.z() + out.z()), 0.5, 2, 0.5)
                    .turned(0, heading);
            assertThat(world.addObjectUnchecked(tile.named(name + k))).isTrue();
        }
    }

    /** Round robots that are pushed straight ahead slide off the jambs and pass, if only they fit with their clearance. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void roundRobotsPassDoorwaysAndPosts(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(99);
        for (int k = 0; k < 80; k++) {
            double clearance = k % 2 == 0 ? 0 : 0.03;
            double heading = k % 5 == 0 ? 90 * random.nextInt(4) : random.nextDouble(360);
            double free = 0.4 + 2 * clearance + (k % 3 == 0 ? 1e-6 : 0.05);
            Geometry world = new Geometry(20, 10, 20, dimension, Accuracy.EXACT);
            for (int side = -1; side <= 1; side += 2) {
                boolean isPost = k % 4 == 3;
                Point middle = along(heading + 90 * side, free / 2 + (isPost ? 0.1 : 1));
                world.addObjectUnchecked((isPost
                                ? new CylinderObject(middle, 0.1, 2)
                                : new BoxObject(middle, 0.2, 2, 2).turned(0, heading))
                        .named("jamb" + side));
            }
            Point start = along(heading, -1);
            Point aside = along(heading + 90, random.nextDouble(-0.15, 0.15));
            Point at = new Point(start.x() + aside.x(), 0, start.z() + aside.z());
            GeometryObject body = k % 3 == 1
                    ? new ObjectGroup(List.of(
                            new CapsuleObject(new Point(), 0.2, 0.2), new SphereObject(new Point(0, 0.3, 0), 0.15)))
                    : robot(k % 3 == 0 ? 0 : 2);
            assertThat(world.addObject(body.moveable("robot").movedTo(at))).isTrue();
            Point step = along(heading, STEP);
            for (int n = 0; n < 120; n++) {
                world.moveAndSlide("robot", new Move(step.x(), 0, step.z(), 0, 0), clearance, 4);
                assertThat(world.getProximity("robot", 9)).isGreaterThanOrEqualTo(clearance);
            }
            Point end = world.getObject("robot").center();
            Point ahead = along(heading, 1);
            assertThat(end.x() * ahead.x() + end.z() * ahead.z())
                    .as("%s %d heading %s ended at %s", dimension, k, heading, end)
                    .isGreaterThan(1);
        }
    }
}
