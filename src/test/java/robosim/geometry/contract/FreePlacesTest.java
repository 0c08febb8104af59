package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.exact.Attitude;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/** Poses and edges in one call answer as one by one, and nothing moves. */
@Tag("slow")
class FreePlacesTest {
    private static final double SIZE = 24;
    private static final int COUNT = 333;

    private final SplittableRandom random = new SplittableRandom(7);
    private final RandomObjects objects = new RandomObjects(random, 9);

    /** Objects of all kinds, one in so many moves. */
    private Geometry filled(Dimension dimension, Accuracy accuracy, int count, int oneIn) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.next();
            world.addObjectUnchecked(random.nextInt(oneIn) == 0 ? object.moveable("object " + k) : object);
        }
        world.addObjectUnchecked(new CylinderObject(new Point(), 0.3, 0.5).moveable("disc"));
        world.addObjectUnchecked(new BoxObject(new Point(1, 0, 2), 0.6, 0.4, 0.4).moveable("box"));
        world.addObjectUnchecked(objects.next().moveable("any"));
        Script.run(world, 50, random.nextLong(), 9, 0.25);
        return world;
    }

    private double[] poses(int count) {
        double[] poses = new double[4 * count];
        for (int at = 0; at < poses.length; at += 4) {
            Point place = objects.place();
            poses[at] = place.x();
            poses[at + 1] = place.y();
            poses[at + 2] = place.z();
            poses[at + 3] = at % 3 == 1 ? poses[at - 1] : objects.heading(); // one in three as before
        }
        return poses;
    }

    /** From such poses to others nearby, some of which only move or only turn. */
    private double[] edges(int count) {
        double[] from = poses(count);
        double[] edges = new double[8 * count];
        for (int k = 0; k < count; k++) {
            for (int i = 0; i < 4; i++) {
                double by = i == 3 ? random.nextDouble(-90, 90) : random.nextDouble(-1, 1);
                boolean stays = k % 5 == 0 ? i < 3 : k % 3 == 0 && i == 3;
                edges[8 * k + i] = from[4 * k + i];
                edges[8 * k + 4 + i] = from[4 * k + i] + (stays || k % 40 == 0 ? 0 : by);
            }
        }
        return edges;
    }

    /** The object as it is tipped, turned about the vertical to a heading. */
    private static GeometryObject posed(GeometryObject object, double[] poses, int at) {
        Point center = point(poses, at);
        if (object.pose().isUpright()) {
            return object.at(Pose.of(center, poses[at + 3]));
        }
        double[] place = new double[Pose.PLACE];
        object.pose().place(place, 0);
        Attitude.turnVertically(place, 3, poses[at + 3] + 0.0 - object.heading());
        return object.at(Pose.of(center, place, 3));
    }

    private static Point point(double[] numbers, int at) {
        return new Point(numbers[at], numbers[at + 1], numbers[at + 2]);
    }

    private static boolean bit(long[] bits, int k) {
        return (bits[k / 64] >>> (k % 64) & 1) != 0;
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 60, 40", "SPATIAL, EXACT, 90, 40", "PLANAR, EXACT, 60, 3", "SPATIAL, EXACT, 90, 3",
        "PLANAR, DOP, 40, 8", "SPATIAL, DOP, 60, 8", "PLANAR, OBB, 40, 8", "SPATIAL, OBB, 60, 8",
        "PLANAR, AABB, 40, 8", "SPATIAL, AABB, 60, 3", "PLANAR, SPHERE, 40, 8", "SPATIAL, SPHERE, 60, 8"
    })
    void asOneByOne(Dimension dimension, Accuracy accuracy, int count, int oneIn) {
        Geometry world = filled(dimension, accuracy, count, oneIn);
        Snapshot snapshot = world.snapshot();
        String before = world.objects().toString();
        for (String name : new String[] {"disc", "box", "any"}) {
            GeometryObject object = world.getObject(name);
            double[] poses = poses(COUNT);
            double[] edges = edges(COUNT);
            long[] free = new long[7];
            free[5] = -1;
            free[6] = -1;
            int freePoses = world.freePoses(name, poses, free);
            Geometry without = snapshot.toGeometry();
            without.removeObject(name);
            int truth = 0;
            for (int k = 0; k < COUNT; k++) {
                boolean isFree = !without.testObject(posed(object, poses, 4 * k));
                truth += isFree ? 1 : 0;
                assertThat(bit(free, k)).as("%s, pose %d", name, k).isEqualTo(isFree);
            }
            assertThat(freePoses).isEqualTo(truth);
            assertThat(free[5] >>> COUNT % 64).isEqualTo(0);
            assertThat(free[6]).isEqualTo(-1);
            long[] freeEdges = new long[6];
            int edgesFound = world.freeEdges(name, edges, freeEdges);
            assertEdges(snapshot, name, edges, freeEdges, edgesFound);
            for (int threads : new int[] {1, 2, 5}) {
                long[] again = new long[6];
                assertThat(snapshot.withThreads(threads).freePoses(name, poses, again))
                        .isEqualTo(truth);
                assertThat(again).isEqualTo(java.util.Arrays.copyOf(free, 6));
                assertThat(snapshot.withThreads(threads).freeEdges(name, edges, again))
                        .isEqualTo(edgesFound);
                assertThat(again).isEqualTo(freeEdges);
            }
            if (!name.equals("any")) {
                assertThat(truth).isBetween(COUNT / 20, COUNT * 19 / 20);
                assertThat(edgesFound).isBetween(COUNT / 30, truth);
            }
        }
        assertThat(world.objects()).hasToString(before);
    }

    private static void assertEdges(Snapshot snapshot, String name, double[] edges, long[] free, int found) {
        int truth = 0;
        Geometry copy = snapshot.toGeometry();
        for (int k = 0; k < COUNT; k++) {
            int at = 8 * k;
            GeometryObject there = posed(copy.getObject(name), edges, at);
            copy.removeObject(name);
            boolean isFree = copy.addObject(there);
            if (!isFree) {
                copy.addObjectUnchecked(there.movedTo(new Point()));
            }
            if (isFree) {
                Move move = new Move(
                        edges[at + 4] - edges[at],
                        edges[at + 5] - edges[at + 1],
                        edges[at + 6] - edges[at + 2],
                        0,
                        edges[at + 7] - edges[at + 3]);
                isFree = copy.moveGlobal(name, move).allowed();
            }
            truth += isFree ? 1 : 0;
            assertThat(bit(free, k)).as("%s, edge %d", name, k).isEqualTo(isFree);
        }
        assertThat(found).isEqualTo(truth);
    }

    /** An edge begins where the object touches nothing, and it stays in the world, as poses do. */
    @Test
    void whatIsTouchedAtTheStartIsInTheWay() {
        Geometry world = new Geometry(20, 5, 20);
        world.addObject(new BoxObject(new Point(4, 0, 0), 2, 2, 2));
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
        double[] touchesTheBoxAndMovesAway = {2.5, 0, 0, 0, 0, 0, 0, 0};
        double[] standsFree = {2.4, 0, 0, 0, 0, 0, 0, 0};
        double[] throughTheBox = {0, 0, 0, 0, 6, 0, 0, 0};
        double[] overTheBorder = {0, 0, 0, 0, 9.6, 0, 5, 0};
        double[] fromBeyondIt = {9.6, 0, 5, 0, 0, 0, 5, 0};
        double[] edges = Stream.of(touchesTheBoxAndMovesAway, standsFree, throughTheBox, overTheBorder, fromBeyondIt)
                .flatMapToDouble(DoubleStream::of)
                .toArray();
        long[] free = new long[1];
        assertThat(world.freeEdges("robot", edges, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b00010);
        double[] poses = {2.5, 0, 0, 0, 2.4, 0, 0, 0, 9.6, 0, 5, 0};
        assertThat(world.freePoses("robot", poses, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b010);
        assertThat(world.freePoses("robot", new double[0], new long[0])).isEqualTo(0);
    }

    /** A robot on a floor of tiles may be anywhere on it, and nowhere lower, nor where a wall stands on it. */
    @Test
    void whoStandsOnAFloorMayBeAnywhereOnIt() {
        Geometry world = new Geometry(20, 6, 20);
        for (int k = -2; k <= 2; k++) {
            world.addObject(new BoxObject(new Point(2.5 * k, -1.5, 0), 2, 1, 8));
        }
        world.addObjectUnchecked(new BoxObject(new Point(4, 0, 0), 0.2, 2, 4));
        world.addObjectUnchecked(new CylinderObject(new Point(0, -0.5, 0), 0.5, 1).moveable("robot"));
        assertThat(world.simpleMove("robot", 1.5, 0, 0)).isTrue();
        double[] poses = {
            0, -0.5, 0, 0, 1.5, -0.5, 0, 30, -2.5, -0.5, 2, 0, 0, -0.5 - 0x1p-50, 0, 0, 3.5, -0.5, 0, 0, 0, 0, 0, 0
        };
        long[] free = new long[1];
        assertThat(world.freePoses("robot", poses, free)).isEqualTo(4);
        assertThat(free[0]).isEqualTo(0b100111);
        double[] edges = new double[8 * 5];
        for (int k = 0; k < 5; k++) {
            System.arraycopy(poses, 0, edges, 8 * k, 4);
            System.arraycopy(poses, 4 * (k + 1), edges, 8 * k + 4, 4);
        }
        assertThat(world.freeEdges("robot", edges, free)).isEqualTo(3);
        assertThat(free[0]).isEqualTo(0b10011);
        assertThat(world.placeObject("robot", new Point(0, -0.5 - 0x1p-50, 0), 0))
                .isFalse();
        assertThat(world.placeObject("robot", new Point(3.5, -0.5, 0), 0)).isFalse();
        assertThat(world.placeObject("robot", new Point(-2.5, -0.5, 2), 0)).isTrue();
        assertThat(world.simpleMove("robot", 0, 1, 0)).isTrue();
        assertThat(world.freePoses("robot", poses, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b100000);
    }

    /** From where the object is, an edge is free where the move is, whatever it touches there. */
    @Test
    void edgesFromThePresentPlaceAnswerAsMovesDo() {
        int[] counts = new int[2];
        for (int k = 0; k < Effort.cases(400); k++) {
            Geometry world = filled(Dimension.values()[k % 2], Accuracy.values()[k % 5], 30, 40);
            for (String name : new String[] {"disc", "box", "any"}) {
                GeometryObject object = world.getObject(name);
                Point c = object.center();
                double[] edge = {c.x(), c.y(), c.z(), object.heading(), 0, 0, 0, object.heading() + 30 * (k % 3 - 1)};
                for (int i = 0; i < 3; i++) {
                    edge[4 + i] = edge[i] + (k % 4 == 0 ? 0 : Math.rint(8 * random.nextDouble(-1, 1)) / 8);
                }
                boolean isFree = world.freeEdges(name, edge, new long[1]) == 1;
                counts[isFree ? 1 : 0]++;
                Move move = new Move(edge[4] - edge[0], edge[5] - edge[1], edge[6] - edge[2], 0, edge[7] - edge[3]);
                assertThat(world.moveGlobal(name, move).allowed())
                        .as("%s by %s in %s", object, move, world.objects())
                        .isEqualTo(isFree);
            }
        }
        assertThat(counts[0]).isGreaterThan(Effort.cases(100));
        assertThat(counts[1]).isGreaterThan(Effort.cases(100));
    }

    /** A capsule that lies along X, and is as long as it is not wide, keeps lying at a pose. */
    @Test
    void whatLiesKeepsLying() {
        Geometry world = new Geometry(20, 6, 20);
        world.addObject(new CylinderObject(new Point(3, 0, 0), 0.2, 2));
        CapsuleObject lying =
                new CapsuleObject(new Point(), 0.2, 2).oriented(new double[] {0, 1, 0, -1, 0, 0, 0, 0, 1});
        assertThat(world.addObject(lying.moveable("robot"))).isTrue();
        double heading = world.getObject("robot").heading();
        double[] poses = {2, 0, 0, heading, 2, 0, 0, heading + 90, 0, 0, 0, heading};
        long[] free = new long[1];
        assertThat(world.freePoses("robot", poses, free)).isEqualTo(2);
        assertThat(free[0]).isEqualTo(0b110);
        double[] edges = {
            0,
            0,
            0,
            heading,
            2,
            0,
            0,
            heading,
            2,
            0,
            0,
            heading + 90,
            2,
            0,
            0,
            heading,
            0,
            0,
            0,
            heading,
            1,
            0,
            0,
            heading
        };
        assertThat(world.freeEdges("robot", edges, free)).isEqualTo(1);
        assertThat(free[0]).isEqualTo(0b100);
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = new Geometry(20, 5, 20);
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
        Snapshot snapshot = world.snapshot();
        double[] two = new double[8];
        long[] free = {-1};
        refused("name must be that of an object", () -> world.freePoses("rob", two, free));
        refused("name must be that of an object", () -> snapshot.withThreads(3).freePoses("rob", two, free));
        refused("threads must be from 1", () -> snapshot.withThreads(0));
        refused("poses must have 4 numbers each (got: 3 numbers)", () -> world.freePoses("robot", new double[3], free));
        refused("edges must have 8 numbers each", () -> world.freeEdges("robot", new double[12], free));
        refused(
                "free must have at least 1 elements for 2 bits (got: 0)",
                () -> world.freePoses("robot", two, new long[0]));
        two[6] = Double.NaN;
        refused("poses[6] must be a number from -2^100 to 2^100 (got: NaN)", () -> world.freePoses("robot", two, free));
        two[6] = 0;
        two[7] = Double.POSITIVE_INFINITY;
        refused(
                "edges[7] must be a finite angle in degrees (got: Infinity)",
                () -> snapshot.withThreads(2).freeEdges("robot", two, free));
        two[7] = Double.MAX_VALUE;
        two[3] = -Double.MAX_VALUE;
        refused("turn from edges[3] to [7] must be a finite angle", () -> world.freeEdges("robot", two, free));
        assertThat(free[0]).isEqualTo(-1);
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(message);
    }
}
