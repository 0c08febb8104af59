package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Avoidance;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.NearObject;
import robosim.geometry.Snapshot;
import robosim.geometry.WorldQueries;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;

/** What planners ask: clearances with points, margins, objects that do not count, fractions of edges, and drives. */
class PlannerQueriesTest {
    private static final double SIZE = 16;
    private static final int THREADS = 3;

    /** A world of random objects, some of which have names, and a robot in it. */
    private static Geometry world(SplittableRandom random, Dimension dimension, int count, boolean isUpright) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
        RandomObjects objects = new RandomObjects(random, SIZE / 2 - 2.5, 1);
        for (int k = 0; k < count; k++) {
            GeometryObject object = isUpright ? objects.upright() : objects.next();
            world.addObjectUnchecked(k % 3 == 0 ? object.moveable("thing " + k) : object.named("thing " + k));
        }
        world.addObjectUnchecked(robot(random, new Point()));
        return world;
    }

    private static GeometryObject robot(SplittableRandom random, Point at) {
        return random.nextBoolean()
                ? new BoxObject(at, 0.9, 0.4, 0.5).moveable("robot")
                : new CylinderObject(at, 0.3, 0.5).moveable("robot");
    }

    private static double[] poses(SplittableRandom random, int count) {
        double[] poses = new double[4 * count];
        for (int k = 0; k < count; k++) {
            for (int axis = 0; axis < 3; axis++) {
                poses[4 * k + axis] = random.nextDouble(-SIZE / 2 + 1, SIZE / 2 - 1);
            }
            poses[4 * k + 3] = random.nextDouble(-180, 180);
        }
        return poses;
    }

    private static Geometry at(Geometry world, double[] poses, int k) {
        Geometry there = world.snapshot().toGeometry();
        GeometryObject robot = world.getObject("robot");
        there.removeObject("robot");
        Pose pose = Pose.of(new Point(poses[4 * k], poses[4 * k + 1], poses[4 * k + 2]), poses[4 * k + 3]);
        assertThat(there.addObjectUnchecked(robot.at(pose))).isTrue();
        return there;
    }

    private static Geometry without(Geometry world, List<String> names) {
        Geometry left = world.snapshot().toGeometry();
        names.forEach(name -> assertThat(left.removeObject(name)).isTrue());
        return left;
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void theClearanceIsTheLeastOfAllSignedDistances(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8101);
        int deep = 0;
        int free = 0;
        for (int n = 0; n < Effort.cases(40, 16); n++) {
            Geometry world = world(random, dimension, 30, n % 2 == 0);
            double[] poses = poses(random, 12);
            double[] out = new double[12 * 10];
            double[] plain = new double[12];
            int clear = world.clearances("robot", poses, 3, Avoidance.ALL, out);
            assertThat(world.clearances("robot", poses, 3, Avoidance.ALL, plain))
                    .isEqualTo(clear);
            for (int k = 0; k < 12; k++) {
                Geometry there = at(world, poses, k);
                GeometryObject robot = there.getObject("robot");
                NearObject near = there.clearance("robot", 3);
                double proximity = there.getProximity("robot", 3);
                assertThat(plain[k]).isEqualTo(out[10 * k]);
                if (near == null) {
                    assertThat(proximity).isEqualTo(Double.POSITIVE_INFINITY);
                    assertThat(out[10 * k]).isEqualTo(Double.POSITIVE_INFINITY);
                    continue;
                }
                String what = "%s in %s: %s".formatted(robot, there, near);
                assertThat(near.distance()).as(what).isEqualTo(proximity);
                assertThat(near.signed())
                        .as(what)
                        .isEqualTo(ContactQuery.signedDistance(robot, near.object(), dimension, Budget.UNLIMITED));
                double least = Double.POSITIVE_INFINITY;
                for (GeometryObject other : there.objects()) {
                    if (!"robot".equals(other.name())) {
                        least = Math.min(
                                least,
                                ContactQuery.signedDistance(robot, other, dimension, Budget.UNLIMITED)
                                        .high());
                    }
                }
                assertThat(near.signed().high()).as(what).isEqualTo(least, within(1e-9));
                assertThat(out[10 * k])
                        .as(what)
                        .isEqualTo(proximity > 0 ? proximity : near.signed().high());
                Point onOther = near.signed().onB();
                assertThat(out[10 * k + 4]).as(what).isEqualTo(onOther.x());
                assertThat(out[10 * k + 9])
                        .as(what)
                        .isEqualTo(near.signed().direction().z());
                deep += proximity == 0 ? 1 : 0;
                free += proximity > 0 ? 1 : 0;
            }
        }
        assertThat(deep).isGreaterThan(5);
        assertThat(free).isGreaterThan(20);
    }

    /** On a map of cells the nearest cell counts, however many there are. */
    @Test
    void theClearanceOnAMapIsThatOfItsCells() {
        SplittableRandom random = new SplittableRandom(8102);
        for (int n = 0; n < 20; n++) {
            GridObject map = RandomGrids.next(random, n % 2 == 0 ? 0 : 30).named("map");
            Geometry world = new Geometry(200, 50, 200, Dimension.PLANAR, Accuracy.EXACT);
            assertThat(world.addObjectUnchecked(map)).isTrue();
            Point place = new Point(random.nextDouble(-4, 4), 0, random.nextDouble(-4, 4));
            GeometryObject robot =
                    new BoxObject(place, 0.5, 1, 0.25).turned(0, 30).moveable("robot");
            world.addObjectUnchecked(robot);
            NearObject near = world.clearance("robot", Double.POSITIVE_INFINITY);
            SignedDistance whole = ContactQuery.signedDistance(robot, map, Dimension.PLANAR, Budget.UNLIMITED);
            assertThat(near.signed().high()).isEqualTo(whole.high(), within(1e-12));
            if (whole.low() > 0) {
                assertThat(near.signed().low()).isEqualTo(whole.low(), within(1e-12));
                assertThat(near.distance()).isEqualTo(world.getProximity("robot", Double.POSITIVE_INFINITY));
            }
        }
    }

    /** All batches in a world, on threads, and in a world without the objects that do not count. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void whatDoesNotCountMightAsWellNotBeThere(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8103);
        int differing = 0;
        for (int n = 0; n < Effort.cases(24, 4); n++) {
            Geometry world = world(random, dimension, 25, n % 2 == 0);
            List<String> names = new ArrayList<>();
            for (int k = 0; k < 25; k++) {
                if (random.nextInt(3) == 0) {
                    names.add("thing " + k);
                }
            }
            Snapshot snapshot = world.snapshot();
            double margin = n % 4 < 2 ? 0 : 0.2;
            Avoidance avoid = Avoidance.margin(margin).andIgnoring(names);
            Geometry left = without(world, names);
            double[] poses = poses(random, 300);
            double[] drives = drives(random, 270);
            double[] few = Arrays.copyOf(poses, 8 * 10);
            List<double[]> answers = new ArrayList<>();
            for (WorldQueries each : List.of(world, snapshot.toGeometry(), snapshot, snapshot.withThreads(THREADS))) {
                answers.add(answers(each, poses, few, drives, avoid));
            }
            double[] expected = answers(left, poses, few, drives, Avoidance.margin(margin));
            for (double[] answer : answers) {
                assertThat(answer).isEqualTo(expected);
            }
            differing += Arrays.equals(expected, answers(world, poses, few, drives, Avoidance.margin(margin))) ? 0 : 1;
            Move move = new Move(random.nextDouble(-3, 3), 0, random.nextDouble(-3, 3), 0, random.nextInt(2) * 40);
            MoveResult there = world.snapshot().toGeometry().move("robot", move, avoid);
            assertThat(there).isEqualTo(left.move("robot", move, Avoidance.margin(margin)));
        }
        assertThat(differing).isGreaterThan(4);
    }

    private static double[] answers(
            WorldQueries world, double[] poses, double[] edges, double[] drives, Avoidance avoid) {
        int count = poses.length / 4;
        long[] free = new long[(count + 63) / 64];
        double[] clear = new double[10 * count];
        double[] fractions = new double[edges.length / 4];
        double[] shares = new double[drives.length / 9];
        long[] freeEdges = new long[(edges.length / 8 + 63) / 64];
        List<Double> all = new ArrayList<>();
        all.add((double) world.freePoses("robot", poses, avoid, free));
        all.add((double) world.clearances("robot", poses, 2, avoid, clear));
        all.add((double) world.edgeFractions("robot", edges, avoid, fractions));
        all.add((double) world.freeEdges("robot", edges, avoid, freeEdges));
        all.add((double) world.driveFractions("robot", drives, avoid, shares));
        assertThat(all.get(2)).isEqualTo(all.get(3));
        for (long word : free) {
            all.add((double) Long.bitCount(word));
        }
        for (double[] numbers : List.of(clear, fractions, shares)) {
            for (double number : numbers) {
                all.add(number);
            }
        }
        return all.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Without a margin and with everything counting, the bits are those of the plain batches. */
    @Test
    void withoutAMarginTheAnswersAreThePlainOnes() {
        SplittableRandom random = new SplittableRandom(8104);
        for (int n = 0; n < 6; n++) {
            Geometry world = world(random, n % 2 == 0 ? Dimension.PLANAR : Dimension.SPATIAL, 40, n % 4 < 2);
            double[] poses = poses(random, 400);
            long[] one = new long[7];
            long[] other = new long[7];
            assertThat(world.freePoses("robot", poses, Avoidance.ALL, one))
                    .isEqualTo(world.freePoses("robot", poses, other));
            assertThat(one).isEqualTo(other);
            long[] edges = new long[4];
            double[] fractions = new double[400];
            assertThat(world.freeEdges("robot", poses, edges)).isPositive();
            world.edgeFractions("robot", poses, Avoidance.ALL, fractions);
            for (int k = 0; k < 200; k++) {
                boolean isFree = (edges[k / 64] >> k % 64 & 1) == 1;
                assertThat(fractions[2 * k] == 1 && fractions[2 * k + 1] == 1).isEqualTo(isFree);
            }
        }
    }

    /** A margin is kept along all of a free edge, and a place that keeps it is free. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMarginIsKeptAllAlong(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8105);
        double margin = 0.25;
        int free = 0;
        int blocked = 0;
        for (int n = 0; n < Effort.cases(24, 4); n++) {
            Geometry world = world(random, dimension, 14, n % 2 == 0);
            double[] poses = poses(random, 60);
            long[] bits = new long[1];
            world.freePoses("robot", poses, Avoidance.margin(margin), bits);
            for (int k = 0; k < 60; k += 5) {
                boolean keeps = at(world, poses, k).getProximity("robot", 9) >= margin;
                assertThat((bits[0] >> k & 1) == 1).isEqualTo(keeps); // all poses are far from the border
            }
            double[] edges = Arrays.copyOf(poses, 8 * 12);
            world.freeEdges("robot", edges, Avoidance.margin(margin), bits);
            for (int k = 0; k < 12; k++) {
                double least = Double.POSITIVE_INFINITY;
                double[] on = new double[4 * 41];
                for (int s = 0; s <= 40; s++) {
                    for (int axis = 0; axis < 4; axis++) {
                        double share = Math.min(1, Math.max(0, axis < 3 ? s / 20.0 : s / 20.0 - 1));
                        on[4 * s + axis] =
                                edges[8 * k + axis] + share * (edges[8 * k + 4 + axis] - edges[8 * k + axis]);
                    }
                }
                double[] clear = new double[41];
                world.clearances("robot", on, 9, Avoidance.ALL, clear);
                for (double each : clear) {
                    least = Math.min(least, each);
                }
                if ((bits[0] >> k & 1) == 1) {
                    assertThat(least).isGreaterThan(margin - 1e-9);
                    free++;
                } else {
                    blocked++;
                }
            }
        }
        assertThat(free).isGreaterThan(4);
        assertThat(blocked).isGreaterThan(4);
    }

    private static double[] drives(SplittableRandom random, int count) {
        double[] drives = new double[9 * count];
        for (int k = 0; k < count; k++) {
            System.arraycopy(poses(random, 1), 0, drives, 9 * k, 4);
            drives[9 * k + 4] = random.nextDouble(-2, 2);
            drives[9 * k + 5] = random.nextInt(3) == 0 ? random.nextDouble(-1, 1) : 0;
            drives[9 * k + 6] = random.nextInt(3) == 0 ? random.nextDouble(-1, 1) : 0;
            drives[9 * k + 7] = random.nextInt(4) == 0 ? 0 : random.nextDouble(-120, 120);
            drives[9 * k + 8] = random.nextDouble(0, 3);
        }
        return drives;
    }

    private static Pose pose(double[] drives, int k, double seconds) {
        int at = 9 * k;
        Twist twist = new Twist(drives[at + 4], drives[at + 5], drives[at + 6], drives[at + 7]);
        return twist.after(Pose.of(new Point(drives[at], drives[at + 1], drives[at + 2]), drives[at + 3]), seconds);
    }

    /** No sample of a free drive is in anything, and what stops a drive is there. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aDriveIsFreeExactlyUpToWhatBlocksIt(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(8106);
        int whole = 0;
        int parts = 0;
        int none = 0;
        for (int n = 0; n < Effort.cases(40, 12); n++) {
            double margin = n % 3 == 0 ? 0.125 : 0;
            Geometry world = world(random, dimension, 14, n % 2 == 0);
            GeometryObject robot = world.getObject("robot");
            Geometry empty = without(world, List.of("robot"));
            double[] drives = drives(random, 60);
            double[] shares = new double[60];
            int free = world.driveFractions("robot", drives, Avoidance.margin(margin), shares);
            double[] shorter = drives.clone();
            for (int k = 0; k < 60; k++) {
                double seconds = drives[9 * k + 8];
                shorter[9 * k + 8] = seconds * shares[k];
                for (int s = 0; s <= 100 && shares[k] > 0; s++) {
                    GeometryObject there = robot.at(pose(drives, k, seconds * shares[k] * s / 100));
                    assertThat(empty.testObject(there))
                            .as("%s at %s", there, shares[k])
                            .isFalse();
                    assertThat(empty.search().fits(there)).isTrue();
                }
                if (shares[k] < 1) {
                    double least = clearance(empty, robot.at(pose(drives, k, seconds * shares[k])));
                    assertThat(least)
                            .as(
                                    "drive %s of %s: %s",
                                    Arrays.toString(Arrays.copyOfRange(drives, 9 * k, 9 * k + 9)), robot, shares[k])
                            .isLessThan(margin + 1e-6);
                }
                whole += shares[k] == 1 ? 1 : 0;
                none += shares[k] == 0 ? 1 : 0;
                free -= shares[k] == 1 ? 1 : 0;
                parts += shares[k] > 0 && shares[k] < 1 ? 1 : 0;
            }
            assertThat(free).isZero();
            double[] again = new double[60];
            world.driveFractions("robot", shorter, Avoidance.margin(margin), again);
            for (int k = 0; k < 60; k++) {
                assertThat(again[k]).isEqualTo(shares[k] == 0 ? again[k] : 1);
            }
        }
        assertThat(whole).isGreaterThan(50);
        assertThat(parts).isGreaterThan(50);
        assertThat(none).isGreaterThan(10);
    }

    /** To the nearest object or the border. */
    private static double clearance(Geometry world, GeometryObject robot) {
        Geometry there = world.snapshot().toGeometry();
        if (!there.addObjectUnchecked(robot)) {
            return 0;
        }
        double least = there.getProximity("robot", Double.POSITIVE_INFINITY);
        double half = SIZE / 2;
        least = Math.min(
                least, Math.min(half - robot.bounds().maxX(), robot.bounds().minX() + half));
        least = Math.min(
                least, Math.min(half - robot.bounds().maxZ(), robot.bounds().minZ() + half));
        if (world.dimension() == Dimension.SPATIAL) {
            least = Math.min(
                    least, Math.min(half - robot.bounds().maxY(), robot.bounds().minY() + half));
        }
        return least;
    }

    /** A quarter of a circle around a post, between two walls: known by hand. */
    @Test
    void anArcIsNotAnEdge() {
        Geometry world = new Geometry(20, 4, 20);
        world.addObject(new BoxObject(new Point(0, -1, 0), 20, 2, 20).named("floor"));
        world.addObjectUnchecked(new CylinderObject(new Point(0, 1, -3), 1.5, 2).named("post"));
        world.addObjectUnchecked(new BoxObject(new Point(0, 0.5, 0), 0.5, 1, 0.5).moveable("car"));
        double quarter = 3 * Math.PI / 2; // of a circle of radius 3 around the post, at 1 a second
        double degrees = 90 / quarter;
        double[] drives = {0, 0.5, 0, 0, 1, 0, 0, degrees, quarter, 0, 0.5, 0, 90, 1, 0, 0, 0, 3};
        double[] shares = new double[2];
        assertThat(world.driveFractions("car", drives, Avoidance.ALL, shares)).isEqualTo(1);
        assertThat(shares[0]).isEqualTo(1); // stands on the floor, and drives around the post
        assertThat(shares[1]).isEqualTo(1.25 / 3, within(1e-6)); // straight into it
        long[] free = new long[1];
        Pose end = new Twist(1, 0, 0, degrees).after(Pose.of(new Point(0, 0.5, 0), 0), quarter);
        double[] edge = {0, 0.5, 0, 0, end.center().x(), 0.5, end.center().z(), 90};
        assertThat(end.center().x()).isEqualTo(3, within(1e-9));
        world.freeEdges("car", edge, free);
        assertThat(free[0]).isEqualTo(1); // the chord is free as well, but passes the post more closely
        world.driveFractions("car", drives, Avoidance.ignoring("floor").withMargin(1.1), shares);
        assertThat(shares[0]).isEqualTo(1);
        world.driveFractions("car", drives, Avoidance.ignoring("floor").withMargin(1.3), shares);
        assertThat(shares[0]).isZero();
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = world(new SplittableRandom(1), Dimension.SPATIAL, 3, true);
        assertThatThrownBy(() -> Avoidance.margin(-1)).hasMessageContaining("(got: -1.0)");
        assertThatThrownBy(() -> world.clearance("robot", 1, Avoidance.ignoring("thing 99")))
                .hasMessageContaining("thing 99");
        assertThatThrownBy(() -> world.clearances("robot", new double[8], 1, Avoidance.ALL, new double[3]))
                .hasMessageContaining("out must have 1 or 10 numbers");
        assertThatThrownBy(() -> world.driveFractions("robot", new double[8], Avoidance.ALL, new double[3]))
                .hasMessageContaining("drives must have 9 numbers each (got: 8 numbers)");
        double[] drive = {0, 0, 0, 0, 1, 0, 0, 0, -1};
        assertThatThrownBy(() -> world.driveFractions("robot", drive, Avoidance.ALL, new double[1]))
                .hasMessageContaining("drives[8]");
        // After an exception everything counts again.
        assertThat(world.clearance("robot", 100)).isNotNull();
    }
}
