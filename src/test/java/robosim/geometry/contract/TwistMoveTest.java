package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Avoidance;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Moves that turn while they translate, against dense samples of the same arcs, straight moves and turns. */
class TwistMoveTest {
    private static final double SIZE = 16;
    private static final int SAMPLES = 80;

    /** How near to contact a refused arc must come; arcs of these tests have radii of up to 1,000. */
    private static final double CLOSE = 1e-5;

    private static Geometry world(SplittableRandom random, Dimension dimension, Accuracy accuracy, boolean isUpright) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        RandomObjects objects = new RandomObjects(random, SIZE / 2 - 2.5, 1);
        for (int k = 0; k < 14; k++) {
            world.addObjectUnchecked(isUpright ? objects.upright() : objects.next());
        }
        return world;
    }

    private static GeometryObject robot(SplittableRandom random, boolean isUpright) {
        double reach = SIZE / 2 - 1.5;
        Point at = new Point(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
        double tip = isUpright ? 0 : random.nextDouble(-60, 60);
        double heading = random.nextDouble(-180, 180);
        return switch (random.nextInt(4)) {
            case 0 -> new BoxObject(at, 0.9, 0.4, 0.5).turned(tip, heading).moveable("robot");
            case 1 -> new CylinderObject(at, 0.3, 0.5).turned(tip, heading).moveable("robot");
            case 2 -> new CapsuleObject(at, 0.2, 0.8).turned(tip, heading).moveable("robot");
            default -> new SphereObject(at, 0.3).turned(tip, heading).moveable("robot");
        };
    }

    private static Twist twist(SplittableRandom random) {
        double turn = switch (random.nextInt(4)) {
            case 0 -> random.nextDouble(-300, 300);
            case 1 -> Math.scalb(random.nextDouble(-1, 1), -random.nextInt(6));
            default -> random.nextDouble(-90, 90);
        };
        return new Twist(random.nextDouble(-2, 2), 0, random.nextInt(3) == 0 ? random.nextDouble(-1, 1) : 0, turn);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void anArcIsFreeExactlyUpToWhatBlocksIt(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8301);
        int whole = 0;
        int parts = 0;
        for (int n = 0; n < Effort.cases(60, 20); n++) {
            boolean isUpright = dimension == Dimension.PLANAR || n % 3 > 0;
            Geometry world = world(random, dimension, Accuracy.EXACT, isUpright);
            for (int k = 0; k < 30; k++) {
                GeometryObject robot = robot(random, isUpright);
                if (world.testObject(robot)) {
                    continue;
                }
                Twist twist = twist(random);
                double seconds = random.nextDouble(0, 4);
                Geometry moved = world.snapshot().toGeometry();
                assertThat(moved.addObject(robot)).isTrue();
                MoveResult result = moved.move("robot", twist, seconds);
                String what = "%s with %s for %s: %s".formatted(robot, twist, seconds, result);
                for (int s = 0; s <= SAMPLES; s++) {
                    double time = seconds * result.fraction() * s / SAMPLES;
                    GeometryObject there = robot.at(twist.after(robot.pose(), time));
                    assertThat(world.testObject(there)).as(what).isFalse();
                    assertThat(world.search().fits(there)).as(what).isTrue();
                }
                assertThat(result.turnFraction()).isEqualTo(result.fraction());
                if (result.allowed()) {
                    whole++;
                    Point end = twist.after(robot.pose(), seconds).center();
                    assertThat(moved.getObject("robot").center().x()).isEqualTo(end.x(), within(1e-13));
                    assertThat(moved.getObject("robot").center().z()).isEqualTo(end.z(), within(1e-13));
                    continue;
                }
                parts++;
                assertThat(moved.getObject("robot")).as(what).isEqualTo(robot);
                assertThat(moved.move("robot", twist, result.fraction() * seconds)
                                .allowed())
                        .as(what)
                        .isTrue();
                assertThat(gap(moved)).as(what).isLessThan(CLOSE);
                checkNormal(result, robot, twist, result.fraction() * seconds, what);
            }
        }
        assertThat(whole).isGreaterThan(40);
        assertThat(parts).isGreaterThan(40);
    }

    /** A normal never points along the motion of the contact point. */
    private static void checkNormal(MoveResult result, GeometryObject robot, Twist twist, double time, String what) {
        Pose pose = twist.after(robot.pose(), time);
        double spin = Math.toRadians(twist.ry());
        double[] away = {
            result.contact().x() - pose.center().x(),
            result.contact().y() - pose.center().y(),
            result.contact().z() - pose.center().z()
        };
        double[] velocity = new double[3];
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3;
            int b = (k + 2) % 3;
            double turning = pose.rotation(3 * a + 1) * away[b] - pose.rotation(3 * b + 1) * away[a];
            velocity[k] = pose.rotation(3 * k) * twist.x() + pose.rotation(3 * k + 2) * twist.z() + spin * turning;
        }
        Point n = result.normal();
        double along = n.x() * velocity[0] + n.y() * velocity[1] + n.z() * velocity[2];
        assertThat(along).as(what).isLessThan(1e-3);
    }

    /** To the nearest object or the border. */
    private static double gap(Geometry world) {
        GeometryObject robot = world.getObject("robot");
        double half = SIZE / 2;
        double least = world.getProximity("robot", Double.POSITIVE_INFINITY);
        var b = robot.bounds();
        least = Math.min(least, Math.min(half - b.maxX(), b.minX() + half));
        least = Math.min(least, Math.min(half - b.maxZ(), b.minZ() + half));
        return world.dimension() == Dimension.PLANAR
                ? least
                : Math.min(least, Math.min(half - b.maxY(), b.minY() + half));
    }

    /** Without a turn a twist is the straight move, and without a translation the turn, to the bit. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theLimitsAreMovesAndTurns(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8302);
        int blocked = 0;
        for (int n = 0; n < Effort.cases(40, 12); n++) {
            Geometry world = world(random, dimension, Accuracy.values()[n % 5], n % 2 == 0);
            for (int k = 0; k < 20; k++) {
                GeometryObject robot = robot(random, n % 2 == 0);
                Geometry one = world.snapshot().toGeometry();
                one.addObjectUnchecked(robot);
                Geometry other = one.snapshot().toGeometry();
                Twist to = new Twist(random.nextDouble(-3, 3), random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0);
                MoveResult straight = one.move("robot", to, 1);
                MoveResult move = other.move("robot", new Move(to.x(), to.y(), to.z(), 0, 0));
                assertThat(straight.allowed()).isEqualTo(move.allowed());
                assertThat(straight.fraction()).isEqualTo(move.fraction(), within(1e-9));
                assertThat(straight.obstacle()).isEqualTo(move.obstacle());
                double by = random.nextDouble(-180, 180);
                MoveResult turn = one.move("robot", new Twist(0, 0, 0, by), 1);
                MoveResult spin = other.move("robot", new Move(0, 0, 0, 0, by));
                assertThat(turn.turnFraction()).isEqualTo(spin.turnFraction());
                assertThat(turn.obstacle()).isEqualTo(spin.obstacle());
                assertThat(one.getObject("robot").center())
                        .isEqualTo(other.getObject("robot").center());
                assertThat(one.getObject("robot").heading())
                        .isEqualTo(other.getObject("robot").heading());
                blocked += move.allowed() ? 0 : 1;
            }
        }
        assertThat(blocked).isGreaterThan(20);
    }

    /** Turning ever more slowly, an arc stops where the straight line does. */
    @Test
    void aSlowTurnIsAlmostALine() {
        for (int exponent = 2; exponent <= 70; exponent++) {
            Geometry world = new Geometry(20, 4, 20);
            world.addObject(new BoxObject(new Point(4, 0, 0), 2, 2, 2));
            world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).moveable("robot"));
            Twist twist = Twist.drive(1, Math.scalb(1, -exponent));
            MoveResult result = world.move("robot", twist, 8);
            // The front left corner comes nearer by half the width times the sine of the angle.
            assertThat(result.fraction() * 8)
                    .as("2^-%d", exponent)
                    .isEqualTo(2.5, within(4.5 * Math.toRadians(twist.ry()) * 8 + 1e-7));
            assertThat(world.move("robot", twist, result.fraction() * 8).allowed())
                    .isTrue();
            assertThat(world.getProximity("robot", 9)).as("2^-%d", exponent).isLessThan(2e-7);
            assertThat(world.move("robot", twist, 1e-3).allowed()).isFalse();
            assertThat(world.move("robot", new Twist(-1, 0, 0, twist.ry()), 3).allowed())
                    .as("2^-%d", exponent)
                    .isTrue();
        }
    }

    /** A ball on an arc of radius 2 around a point, before a wall: known by hand. */
    @Test
    void aBallStopsWhereItsCircleTouchesTheWall() {
        Geometry world = new Geometry(20, 4, 20);
        world.addObject(new BoxObject(new Point(3, 0, 0), 2, 2, 20).named("wall"));
        world.addObject(new SphereObject(new Point(0, 0, 0), 0.5).moveable("ball"));
        Twist twist = Twist.drive(Math.PI / 2 * 2, 90); // a quarter of the circle a second
        MoveResult result = world.move("ball", twist, 1);
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isEqualTo(Math.toDegrees(Math.asin(1.5 / 2)) / 90, within(1e-8));
        assertThat(result.obstacle().name()).isEqualTo("wall");
        assertThat(result.normal().x()).isEqualTo(-1, within(1e-9));
        assertThat(world.moveToContact("ball", twist, 1, 0.25).fraction())
                .isEqualTo(Math.toDegrees(Math.asin(1.25 / 2)) / 90, within(1e-7));
        assertThat(world.getProximity("ball", 1)).isGreaterThanOrEqualTo(0.25);
        assertThat(world.move("ball", twist, 0.1, Avoidance.ignoring("wall").withMargin(1))
                        .allowed())
                .isTrue();
    }

    /** Contacts at the start block only what goes deeper; a floor of tiles or triangles does not block. */
    @Test
    void whatIsTouchedBlocksOnlyMotionIntoIt() {
        for (boolean isMesh : new boolean[] {false, true}) {
            Geometry world = new Geometry(20, 4, 20);
            world.addObject(new BoxObject(new Point(0, 0.5, 0), 1, 1, 1).moveable("robot"));
            if (isMesh) {
                int[][] faces = {{0, 1, 2, 3}};
                world.addObjectUnchecked(new MeshObject(
                        List.of(new Point(-9, 0, -9), new Point(-9, 0, 9), new Point(9, 0, 9), new Point(9, 0, -9)),
                        faces));
            } else {
                for (int k = 0; k < 9; k++) {
                    world.addObjectUnchecked(new BoxObject(new Point(2 * k - 8, -0.5, 0), 2, 1, 18));
                }
            }
            world.addObjectUnchecked(new BoxObject(new Point(0, 0.5, -1), 8, 1, 1).named("left wall"));
            Twist left = Twist.drive(1, 20);
            MoveResult into = world.move("robot", left, 1);
            assertThat(into.allowed()).isFalse();
            assertThat(into.fraction()).isLessThan(1e-9);
            assertThat(into.obstacle().name()).isEqualTo("left wall");
            // To the right its rear left corner swings out, unless the centre of the arc is behind it.
            assertThat(world.move("robot", Twist.drive(1, -20), 0.5).allowed()).isFalse();
            assertThat(world.move("robot", new Twist(0, 0, 1, -20), 0.5).allowed())
                    .isTrue();
            assertThat(world.move("robot", Twist.drive(2, 40), 0.25).allowed()).isTrue();
            assertThat(world.getObject("robot").center().y()).isEqualTo(0.5);
        }
    }

    /** From wherever an arc stopped, the same arc back is free. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void noStopTraps(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8303);
        int stopped = 0;
        for (int n = 0; n < Effort.cases(60, 20); n++) {
            boolean isUpright = dimension == Dimension.PLANAR || n % 3 > 0;
            Geometry world = world(random, dimension, Accuracy.values()[n % 5], isUpright);
            for (int k = 0; k < 20; k++) {
                GeometryObject robot = robot(random, isUpright);
                Geometry moved = world.snapshot().toGeometry();
                if (!moved.addObject(robot)) {
                    continue;
                }
                Twist twist = twist(random);
                double clearance = k % 2 * 0.125;
                if (clearance > gap(moved)) {
                    continue;
                }
                MoveResult result = moved.moveToContact("robot", twist, 2, clearance);
                String what = "%s with %s: %s".formatted(robot, twist, result);
                if (clearance > 0 && moved.accuracy() == Accuracy.EXACT) {
                    assertThat(moved.getProximity("robot", 1)).as(what).isGreaterThanOrEqualTo(clearance);
                }
                Twist back = new Twist(-twist.x(), 0, -twist.z(), -twist.ry());
                if (moved.accuracy() == Accuracy.EXACT) {
                    assertThat(moved.move("robot", back, 2 * result.fraction()).allowed())
                            .as(what)
                            .isTrue();
                }
                // A coarser level never allows more.
                Geometry exact = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
                world.objects().forEach(exact::addObjectUnchecked);
                exact.addObjectUnchecked(robot);
                assertThat(exact.moveToContact("robot", twist, 2, clearance).fraction())
                        .as(what)
                        .isGreaterThanOrEqualTo(result.fraction());
                stopped += result.allowed() ? 0 : 1;
            }
        }
        assertThat(stopped).isGreaterThan(30);
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = new Geometry(20, 4, 20);
        world.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).moveable("robot"));
        assertThatThrownBy(() -> world.move("robot", new Twist(1, 0.5, 0, 10), 1))
                .hasMessageContaining("y of a twist that turns must be 0")
                .hasMessageContaining("y=0.5");
        assertThatThrownBy(() -> world.move("robot", Twist.drive(1, 10), -1)).hasMessageContaining("(got: -1.0)");
        assertThatThrownBy(() -> world.move("robot", Twist.drive(1, 10), Double.NaN))
                .hasMessageContaining("seconds");
        assertThatThrownBy(() -> world.move("robot", Twist.drive(1e20, 10), 1e20))
                .hasMessageContaining("seconds");
        assertThat(world.move("robot", new Twist(0, 0.5, 0, 0), 1).allowed()).isTrue();
        Geometry plane = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
        plane.addObject(new BoxObject(new Point(0, 0, 0), 1, 1, 1).moveable("robot"));
        assertThat(plane.move("robot", new Twist(1, 0.5, 0, 10), 1).allowed()).isTrue();
        assertThat(plane.getObject("robot").center().y()).isEqualTo(0.5);
    }
}
