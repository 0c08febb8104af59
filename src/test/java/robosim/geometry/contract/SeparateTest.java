package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Objects that overlap others or are wedged between them are freed by a short displacement, or stay where they are. */
@Tag("slow")
class SeparateTest {
    private static final int WORLDS = Effort.cases(300);

    /** Directions and steps of the brute-force search for a shorter displacement. */
    private static final int DIRECTIONS = 60;

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void itEndsFreeAndNearlyAsNearAsAnyFreePlace(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(2611);
        int freed = 0;
        int none = 0;
        int missed = 0;
        int untouched = 0;
        int much = 0;
        for (int w = 0; w < WORLDS; w++) {
            RandomObjects objects = new RandomObjects(random, 5);
            Geometry world = new Geometry(30, 30, 30, dimension, Accuracy.EXACT);
            Geometry obstacles = new Geometry(30, 30, 30, dimension, Accuracy.EXACT);
            for (int k = 0; k < 10; k++) {
                GeometryObject one = objects.next();
                world.addObjectUnchecked(one);
                obstacles.addObjectUnchecked(one);
            }
            GeometryObject robot = robot(w).moveable("robot").movedTo(objects.place());
            if (!world.addObjectUnchecked(robot)) {
                continue;
            }
            boolean touches = obstacles.testObject(robot);
            double max = w % 3 == 0 ? 0.3 : 4;

            Point by = world.separate("robot", max);

            GeometryObject end = world.getObject("robot");
            String what = dimension + " world " + w + " from " + robot + " by " + by;
            if (by == null) {
                none++;
                assertThat(end).as(what).isEqualTo(robot);
                assertThat(touches).as(what).isTrue();
                missed += shortest(obstacles, robot, max / 4, dimension) < max / 4 ? 1 : 0;
            } else if (!touches) {
                untouched++;
                assertThat(by).as(what).isEqualTo(new Point());
                assertThat(end).as(what).isEqualTo(robot);
            } else {
                freed++;
                double length = Math.sqrt(by.x() * by.x() + by.y() * by.y() + by.z() * by.z());
                assertThat(length).as(what).isBetween(Double.MIN_VALUE, max);
                assertThat(obstacles.testObject(end)).as(what).isFalse();
                assertThat(end.center().x() - robot.center().x()).as(what).isCloseTo(by.x(), within(1e-12));
                double other = shortest(obstacles, robot, length, dimension);
                much += other < 0.7 * length ? 1 : 0;
            }
        }
        assertThat(freed).isGreaterThan(WORLDS / 6);
        assertThat(untouched).isGreaterThan(WORLDS / 100);
        assertThat(none).isGreaterThan(WORLDS / 100);
        assertThat(missed)
                .as("not freed though places are free, if only beyond others")
                .isLessThanOrEqualTo(1 + none / 10);
        assertThat(much).as("much longer than another one").isLessThanOrEqualTo(freed / 10);
    }

    private static GeometryObject robot(int w) {
        return switch (w % 3) {
            case 0 -> new BoxObject(new Point(), 0.8, 0.6, 0.5).turned(0, 20);
            case 1 -> new CylinderObject(new Point(), 0.4, 0.8);
            default -> new SphereObject(new Point(), 0.4);
        };
    }

    /** The length of the shortest displacement to a free place that is found on straight lines in many directions. */
    private static double shortest(Geometry obstacles, GeometryObject robot, double max, Dimension dimension) {
        Point c = robot.center();
        for (int step = 1; step <= 20; step++) {
            double far = max * step / 20;
            for (int k = 0; k < DIRECTIONS; k++) {
                double around = 2.399963 * k;
                double y = dimension == Dimension.PLANAR ? 0 : 1 - 2 * (k + 0.5) / DIRECTIONS;
                double r = Math.sqrt(1 - y * y);
                Point at = new Point(
                        c.x() + far * r * Math.cos(around), c.y() + far * y, c.z() + far * r * Math.sin(around));
                if (!obstacles.testObject(robot.movedTo(at))) {
                    return far;
                }
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    @Test
    void aRobotInAWallComesOutOnItsOwnSide() {
        Geometry world = new Geometry(20, 5, 20);
        world.addObject(new BoxObject(new Point(2, 0, 0), 0.2, 4, 10).named("wall"));
        world.addObjectUnchecked(new CylinderObject(new Point(1.7, 0, 0), 0.3, 1).moveable("robot"));

        Point by = world.separate("robot", 1);

        assertThat(by.x()).isCloseTo(-0.1, within(1e-9));
        assertThat(by.z()).isZero();
        assertThat(world.simpleMove("robot", -1, 0, 0)).isTrue();
    }

    /** It overlaps one wall of a narrow room and may not come out through another. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void itPassesThroughNothingElse(Dimension dimension) {
        Geometry world = new Geometry(20, 5, 20, dimension, Accuracy.EXACT);
        for (int side = -1; side <= 1; side += 2) {
            world.addObjectUnchecked(new BoxObject(new Point(side * 0.55, 0, 0), 0.1, 4.9, 3));
            world.addObjectUnchecked(new BoxObject(new Point(0, 0, side * 0.75), 3, 4.9, 0.1));
        }
        world.addObjectUnchecked(new CylinderObject(new Point(0.1, 0, 0), 0.505, 1).moveable("robot"));

        Point by = world.separate("robot", 0.5);

        assertThat(by).isNull();
        assertThat(world.getObject("robot").center()).isEqualTo(new Point(0.1, 0, 0));
        // With room beyond the wall that it overlaps, it leaves through that one.
        assertThat(world.separate("robot", 3).x()).isGreaterThan(0.5);
    }

    /** Between two walls that it touches exactly. */
    /** Surfaces that cross each other: the way out leads through triangles that the robot touches, and no others. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMeshComesOutOfAMesh(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(17);
        int touching = 0;
        for (int k = 0; k < Effort.cases(40, 10); k++) {
            Geometry world = new Geometry(30, 30, 30, dimension, Accuracy.EXACT);
            Point at =
                    new Point(random.nextDouble(-0.9, 0.9), random.nextDouble(-0.5, 0.5), random.nextDouble(-0.9, 0.9));
            world.addObject(cube().turned(0, random.nextDouble(360)).movedTo(at));
            MeshObject robot = cube().turned(0, random.nextDouble(360)).moveable("robot");
            if (!world.testObject(robot)) {
                continue;
            }
            touching++;
            world.addObjectUnchecked(robot);
            Point by = world.separate("robot", 4);
            assertThat(by).as("%s in %s", robot, world.objects()).isNotNull();
            assertThat(Math.abs(by.x()) + Math.abs(by.y()) + Math.abs(by.z())).isLessThan(3);
        }
        assertThat(touching).isGreaterThan(Effort.cases(20, 5));
    }

    private static MeshObject cube() {
        List<Point> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            corners.add(new Point((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5));
        }
        return new MeshObject(corners, new int[][] {
            {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}
        });
    }

    @Test
    void aWedgedRobotIsFreed() {
        Geometry world = new Geometry(20, 20, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObjectUnchecked(new BoxObject(new Point(1, 0, 0), 1, 1, 4).named("right"));
        world.addObjectUnchecked(new BoxObject(new Point(-1, 0, 0), 1, 1, 4).named("left"));
        world.addObjectUnchecked(new BoxObject(new Point(0, 0, 1.5), 1, 1, 1).moveable("robot"));

        Point by = world.separate("robot", 2);

        assertThat(by.z()).isCloseTo(1, within(1e-6));
        assertThat(world.getProximity("robot", 1)).isPositive();
        assertThat(world.move("robot", new Move(0, 0, 1, 0, 0)).allowed()).isTrue();
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new SphereObject(new Point(), 1).moveable("ball"));
        assertThat(world.separate("ball", 0)).isEqualTo(new Point());
        assertThatThrownBy(() -> world.separate("ball", -1)).hasMessageStartingWith("max must");
        assertThatThrownBy(() -> world.separate("bell", 1)).hasMessageStartingWith("name ");
    }
}
