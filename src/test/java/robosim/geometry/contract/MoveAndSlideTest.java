package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.SlideResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** A move that goes on along what blocks it: where it ends, what it tells, and that it overlaps nothing. */
class MoveAndSlideTest {
    private static final int WORLDS = Effort.cases(150);
    private static final int WALLS = Effort.cases(2000);

    private static double apart(Point p, Point q) {
        return Math.abs(p.x() - q.x()) + Math.abs(p.y() - q.y()) + Math.abs(p.z() - q.z());
    }

    private static Geometry world(Dimension dimension) {
        return new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
    }

    private static Move toward(GeometryObject robot, double x, double y, double z) {
        double[] r = robot.rotation();
        return new Move(
                r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z, 0, 0);
    }

    /** A wall of any direction: the way up to it, and from there on only its part along the wall. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void alongAWallItEndsWhereTheAnalyticCaseDoes(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(21);
        int slid = 0;
        for (int k = 0; k < WALLS; k++) {
            double degrees = k % 9 == 0 ? 90 * random.nextInt(4) : random.nextDouble(-180, 180);
            double nx = StrictMath.cos(StrictMath.toRadians(degrees));
            double nz = -StrictMath.sin(StrictMath.toRadians(degrees));
            double radius = random.nextDouble(0.1, 1);
            double gap = k % 3 == 0 ? 0 : random.nextDouble(0.2);
            double away = random.nextDouble(0.01, 3) + gap;
            Geometry world = world(dimension);
            // Its face is away + radius from the robot's centre, the normal of the face towards it is (-nx, -nz).
            double middle = away + radius + 0.5;
            world.addObject(new BoxObject(new Point(middle * nx, 0, middle * nz), 1, 4, 60).turned(0, degrees));
            assertThat(world.addObject(new CylinderObject(new Point(), radius, 1).moveable("robot")))
                    .isTrue();
            double dx = random.nextDouble(-9, 9);
            double dz = random.nextDouble(-9, 9);
            double into = dx * nx + dz * nz;

            SlideResult result = world.moveAndSlide("robot", new Move(dx, 0, dz, 0, 0), gap, 4);

            boolean meets = into > away - gap;
            double lost = meets ? into - (away - gap) : 0;
            Point end = world.getObject("robot").center();
            String what = k + ": " + result;
            assertThat(result.contacts()).as(what).hasSize(meets ? 1 : 0);
            assertThat(end.x()).as(what).isCloseTo(dx - lost * nx, within(1e-9));
            assertThat(end.z()).as(what).isCloseTo(dz - lost * nz, within(1e-9));
            assertThat(result.made().x()).as(what).isCloseTo(end.x(), within(1e-12));
            assertThat(result.made().z()).as(what).isCloseTo(end.z(), within(1e-12));
            assertThat(result.left()).as(what).isEqualTo(new Point());
            if (meets) {
                slid++;
                Point normal = result.contacts().get(0).normal();
                assertThat(normal.x()).as(what).isCloseTo(-nx, within(1e-9));
                assertThat(normal.z()).as(what).isCloseTo(-nz, within(1e-9));
                double share = (away - gap) / into;
                double along = Math.sqrt(Math.max(0, dx * dx + dz * dz - into * into)) * (1 - share);
                assertThat(result.length())
                        .as(what)
                        .isCloseTo(share * Math.sqrt(dx * dx + dz * dz) + along, within(1e-9));
            }
        }
        assertThat(slid).isBetween(WALLS / 5, WALLS * 4 / 5);
    }

    /** Free where it ends, as the exact test of a world of the obstacles alone decides; and never longer than asked. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void itNeverOverlapsAnything(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(22);
        int slid = 0;
        int stopped = 0;
        int moves = 0;
        for (int w = 0; w < WORLDS; w++) {
            RandomObjects objects = new RandomObjects(random, 6);
            Geometry obstacles = world(dimension);
            Geometry world = world(dimension);
            for (int k = 0; k < 12; k++) {
                GeometryObject one = objects.next();
                assertThat(obstacles.addObjectUnchecked(one)).isTrue();
                assertThat(world.addObjectUnchecked(one)).isTrue();
            }
            if (!world.addObject(robot(objects, random, w))) {
                continue;
            }
            for (int k = 0; k < 12; k++) {
                double clearance = k % 3 == 0 ? 0 : random.nextDouble(0.05);
                double speed = k % 4 == 3 ? 40 : 4;
                double dx = random.nextDouble(-speed, speed);
                double dy = dimension == Dimension.PLANAR ? 0 : random.nextDouble(-1, 1);
                double dz = random.nextDouble(-speed, speed);
                GeometryObject before = world.getObject("robot");
                Move way = toward(before, dx, dy, dz);
                Move move = new Move(way.x(), way.y(), way.z(), 0, k % 5 == 0 ? random.nextDouble(-90, 90) : 0);

                SlideResult result = world.moveAndSlide("robot", move, clearance, random.nextInt(6));

                GeometryObject after = world.getObject("robot");
                String what = w + ", " + k + ": " + before + " by " + move + " gave " + result;
                assertThat(obstacles.testObject(after)).as(what).isFalse();
                double size = Math.sqrt(dx * dx + dy * dy + dz * dz);
                // What it takes to get a lost clearance back is not asked for.
                assertThat(result.length()).as(what).isLessThanOrEqualTo(size * (1 + 1e-9) + 4 * clearance + 1e-9);
                assertThat(size(result.made())).as(what).isLessThanOrEqualTo(result.length() + 1e-9);
                assertThat(after.center().x() - before.center().x())
                        .as(what)
                        .isCloseTo(result.made().x(), within(1e-9));
                assertThat(after.center().z() - before.center().z())
                        .as(what)
                        .isCloseTo(result.made().z(), within(1e-9));
                moves++;
                slid += !result.contacts().isEmpty() && size(result.left()) == 0 ? 1 : 0;
                stopped += size(result.left()) > 0 ? 1 : 0;
            }
        }
        assertThat(slid).isGreaterThan(moves / 50);
        assertThat(stopped).isGreaterThan(moves / 50);
    }

    private static GeometryObject robot(RandomObjects objects, SplittableRandom random, int w) {
        GeometryObject body = switch (w % 4) {
            case 0 -> new CylinderObject(new Point(), 0.4, 1);
            case 1 -> new BoxObject(new Point(), 0.8, 1, 0.5).turned(0, random.nextDouble(360));
            case 2 -> new SphereObject(new Point(), 0.5);
            default ->
                new ObjectGroup(List.of(
                        new BoxObject(new Point(0.3, 0, 0), 0.5, 0.5, 0.5),
                        new SphereObject(new Point(-0.4, 0, 0), 0.3)));
        };
        return body.moveable("robot").movedTo(objects.place());
    }

    private static double size(Point p) {
        return Math.sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
    }

    /** With no bends it is a move to contact, to the bit. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void withoutBendsItIsAMoveToContact(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(23);
        int blocked = 0;
        for (int w = 0; w < WORLDS; w++) {
            RandomObjects objects = new RandomObjects(random, 6);
            Geometry one = world(dimension);
            Geometry two = world(dimension);
            for (int k = 0; k < 12; k++) {
                GeometryObject obstacle = objects.next();
                one.addObjectUnchecked(obstacle);
                two.addObjectUnchecked(obstacle);
            }
            GeometryObject robot = robot(objects, random, w);
            one.addObjectUnchecked(robot);
            two.addObjectUnchecked(robot);
            Move move = new Move(random.nextDouble(-9, 9), 0, random.nextDouble(-9, 9), 0, 0);
            double clearance = w % 2 == 0 ? 0 : 0.01;

            MoveResult stop = one.moveToContact("robot", move, clearance);
            SlideResult slide = two.moveAndSlide("robot", move, clearance, 0);

            // A slide goes along the world's axes: a share of its displacement is rounded otherwise than one of the
            // move.
            assertThat(apart(
                            two.getObject("robot").center(),
                            one.getObject("robot").center()))
                    .isLessThan(1e-13);
            assertThat(slide.contacts().isEmpty()).isEqualTo(stop.allowed());
            if (!stop.allowed()) {
                blocked++;
                assertThat(slide.contacts()).hasSize(1);
                assertThat(slide.contacts().get(0).obstacle()).isEqualTo(stop.obstacle());
                assertThat(apart(slide.contacts().get(0).point(), stop.contact()))
                        .isLessThan(1e-6);
                assertThat(apart(slide.contacts().get(0).normal(), stop.normal()))
                        .isLessThan(1e-6);
            }
        }
        assertThat(blocked).isBetween(WORLDS / 5, WORLDS * 19 / 20);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aCornerStopsIt(Dimension dimension) {
        for (double clearance : new double[] {0, 0.25}) {
            Geometry world = world(dimension);
            world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 20).named("east"));
            world.addObject(new BoxObject(new Point(-6.5, 0, 5), 20, 2, 2).named("south"));
            world.addObject(new CylinderObject(new Point(), 1, 1).moveable("robot"));

            SlideResult result = world.moveAndSlide("robot", new Move(9, 0, 8, 0, 0), clearance, 10);

            assertThat(result.contacts()).hasSize(2);
            assertThat(result.contacts().get(1).obstacle()).isNotNull();
            Point end = world.getObject("robot").center();
            assertThat(end.x()).isCloseTo(3 - clearance, within(1e-9));
            assertThat(end.z()).isCloseTo(3 - clearance, within(1e-9));
            assertThat(result.left().z()).isGreaterThan(1);
        }
    }

    /** Into a wedge narrower than the robot, from all directions: it comes to stand between the walls and stays there. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 30, 60, 89, 90, 91, 120})
    void aWedgeStopsIt(double angle) {
        SplittableRandom random = new SplittableRandom(24);
        for (int k = 0; k < 100; k++) {
            Geometry world = world(Dimension.PLANAR);
            double half = angle / 2;
            wall(world, half, 1);
            wall(world, -half, -1);
            double deep = 0.5 / StrictMath.sin(StrictMath.toRadians(half));
            GeometryObject robot = new CylinderObject(new Point(-deep - 3, 0, 0), 0.5, 1).moveable("robot");
            assertThat(world.addObject(robot)).isTrue();
            for (int step = 0; step < 6; step++) {
                world.moveAndSlide("robot", new Move(30, 0, random.nextDouble(-1, 1), 0, 0), k % 2 == 0 ? 0 : 1e-3, 8);
                assertThat(world.getObject("robot").center().x()).isLessThanOrEqualTo(-deep + 1e-9);
            }
            // Where the walls meet steeply enough, it gets to the end of the wedge.
            double least = k % 2 == 0 ? -deep - 1e-6 : -deep * (1 + 1e-2) - 1e-2;
            assertThat(world.getObject("robot").center().x()).isGreaterThan(least);
        }
    }

    /** A wall from the origin towards -X, turned by an angle, with the wedge on its inner side. */
    private static void wall(Geometry world, double degrees, int side) {
        double a = StrictMath.toRadians(degrees);
        // Along the wall, out of the wedge, and across, away from it.
        double ax = -StrictMath.cos(a);
        double az = StrictMath.sin(a);
        double x = 10 * ax + side * 0.5 * StrictMath.sin(a);
        double z = 10 * az + side * 0.5 * StrictMath.cos(a);
        assertThat(world.addObjectUnchecked(new BoxObject(new Point(x, 0, z), 22, 2, 1).turned(0, degrees)))
                .isTrue();
    }

    /** On a floor and along a wall: the way goes on along the edge between them. */
    @Test
    void itFollowsAnEdge() {
        Geometry world = world(Dimension.SPATIAL);
        world.addObject(new BoxObject(new Point(0, -1, 0), 40, 2, 40).named("floor"));
        world.addObjectUnchecked(new BoxObject(new Point(5, 2, 0), 2, 4, 40).named("wall"));
        world.addObject(new SphereObject(new Point(0, 3, 0), 1).moveable("ball"));

        SlideResult result = world.moveAndSlide("ball", new Move(9, -9, 9, 0, 0), 0, 4);

        assertThat(result.contacts()).hasSize(2);
        Point end = world.getObject("ball").center();
        assertThat(end.x()).isCloseTo(3, within(1e-9));
        assertThat(end.y()).isCloseTo(1, within(1e-9));
        assertThat(end.z()).isCloseTo(9, within(1e-9));
        assertThat(result.left()).isEqualTo(new Point());
    }

    @Test
    void theBordersOfTheWorldBlockToo() {
        Geometry world = world(Dimension.SPATIAL);
        world.addObject(new SphereObject(new Point(), 1).moveable("ball"));

        SlideResult result = world.moveAndSlide("ball", new Move(10_000, 20, 0, 0, 0), 0, 4);

        assertThat(result.contacts()).hasSize(1);
        assertThat(result.contacts().get(0).obstacle()).isNull();
        assertThat(world.getObject("ball").center().x()).isCloseTo(49, within(1e-9));
        assertThat(world.getObject("ball").center().y()).isCloseTo(20, within(1e-9));
    }

    @Test
    void theTurnIsMadeAfterTheSlide() {
        Geometry world = world(Dimension.PLANAR);
        world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 20).named("wall"));
        world.addObject(new BoxObject(new Point(), 1, 1, 4).moveable("robot"));

        SlideResult result = world.moveAndSlide("robot", new Move(9, 0, 1, 0, 90), 0, 4);

        assertThat(result.contacts()).hasSize(2);
        assertThat(result.turnFraction()).isBetween(0.0, 0.01);
        assertThat(world.moveAndSlide("robot", new Move(-3, 0, 0, 0, 90), 0, 4).turnFraction())
                .isEqualTo(1);
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = world(Dimension.SPATIAL);
        world.addObject(new SphereObject(new Point(), 1).moveable("ball"));
        assertThatThrownBy(() -> world.moveAndSlide("ball", new Move(), -1, 1)).hasMessageStartingWith("clearance ");
        assertThatThrownBy(() -> world.moveAndSlide("ball", new Move(), 0, -1)).hasMessageStartingWith("bends ");
        assertThatThrownBy(() -> world.moveAndSlide("ball", new Move(), 0, 65)).hasMessageStartingWith("bends ");
        assertThatThrownBy(() -> world.moveAndSlide("boll", new Move(), 0, 1)).hasMessageStartingWith("name ");
    }

    /** No more than the value returned: it, two points and a list where nothing is met, a few values more for each contact. */
    @Test
    void itAllocatesNoMoreThanWhatItReturns() {
        Geometry world = world(Dimension.PLANAR);
        world.addObject(new BoxObject(new Point(5, 0, 0), 2, 2, 40).turned(0, 20));
        world.addObject(new CylinderObject(new Point(), 1, 1).moveable("robot"));
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Move there = new Move(9, 0, 2, 0, 0);
        Move back = new Move(-2, 0, -1, 0, 0);
        long bytes = 0;
        int met = 0;
        for (int k = 0; k < 8000; k++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            met += world.moveAndSlide("robot", k % 2 == 0 ? there : back, 0.1, 4)
                    .contacts()
                    .size();
            bytes += k < 4000 ? 0 : threads.getCurrentThreadAllocatedBytes() - before;
            if (k % 2 == 1) {
                world.placeObject("robot", new Point(), 0);
            }
        }
        assertThat(met).isEqualTo(4000);
        // A contact holds a copy of the obstacle's value, if that moves, three points and their list.
        assertThat(bytes / 4000).isLessThan(600);
    }
}
