package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;

/** Worlds with grids: what is shared, what is asked at once, and what is left for the garbage collector. */
@Tag("slow")
class GridSnapshotTest {
    private static final double SIZE = 64;
    private static final double SPREAD = 7;
    private static final int QUESTIONS = 300;
    private static final int CALLS = 2000;

    private final SplittableRandom random = new SplittableRandom(23);

    private Geometry filled(Dimension dimension, Accuracy accuracy, double heading) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        GridObject map = RandomGrids.next(random, heading);
        assertThat(world.addObjectUnchecked(map.named("map"))).isTrue();
        // Another placement of the same cells, and a map of its own.
        assertThat(world.addObjectUnchecked(map.movedTo(new Point(9, 0, -4)))).isTrue();
        assertThat(world.addObjectUnchecked(RandomGrids.next(random, 0).movedTo(new Point(-8, 0, 5))))
                .isTrue();
        RandomObjects objects = new RandomObjects(random, SPREAD);
        for (int k = 0; k < 24; k++) {
            GeometryObject object = objects.next();
            assertThat(world.addObjectUnchecked(
                            k % 3 == 0 ? object.named("object " + k) : object.moveable("mover " + k)))
                    .isTrue();
        }
        ask(world, 3); // off their first places
        return world;
    }

    private static List<String> ask(Geometry world, long seed) {
        return Script.run(world, QUESTIONS, seed, SPREAD, 0.25);
    }

    private static Snapshot copy(Snapshot snapshot) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(snapshot);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            return (Snapshot) in.readObject();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 0", "PLANAR, EXACT, 33", "SPATIAL, EXACT, 90", "SPATIAL, EXACT, -71.3",
        "PLANAR, OBB, 33", "SPATIAL, DOP, 0", "SPATIAL, AABB, 20", "PLANAR, SPHERE, 90"
    })
    void copiesAnswerToTheBit(Dimension dimension, Accuracy accuracy, double heading) throws Exception {
        Geometry world = filled(dimension, accuracy, heading);
        Snapshot snapshot = world.snapshot();
        Geometry copy = snapshot.toGeometry();
        Geometry copyOfCopy = copy.snapshot().toGeometry();
        Geometry read = copy(snapshot).toGeometry();
        assertThat(((GridObject) copy.getObject("map")).cells())
                .isSameAs(((GridObject) world.getObject("map")).cells());
        ExecutorService pool = Executors.newFixedThreadPool(4);
        try {
            CyclicBarrier start = new CyclicBarrier(4);
            List<Future<List<String>>> answers = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                answers.add(pool.submit(() -> {
                    start.await();
                    return ask(snapshot.toGeometry(), 5);
                }));
            }
            List<String> truth = ask(world, 5);
            assertThat(truth).anyMatch(line -> line.contains(" true")).anyMatch(line -> line.contains(" false"));
            assertThat(ask(copy, 5)).as("a copy").isEqualTo(truth);
            assertThat(ask(copyOfCopy, 5)).as("a copy's copy").isEqualTo(truth);
            assertThat(ask(read, 5)).as("read from a stream").isEqualTo(truth);
            for (Future<List<String>> answer : answers) {
                assertThat(answer.get()).as("on a thread").isEqualTo(truth);
            }
        } finally {
            pool.shutdownNow();
        }
    }

    @ParameterizedTest
    @CsvSource({"PLANAR, 0", "PLANAR, 33", "SPATIAL, 180", "SPATIAL, -71.3"})
    void patternsAreTheirBeams(Dimension dimension, double heading) {
        Geometry world = filled(dimension, Accuracy.EXACT, heading);
        Snapshot snapshot = world.snapshot();
        Geometry seen = dimension == Dimension.PLANAR ? Heights.of(world) : world; // beams look up and down
        RandomObjects objects = new RandomObjects(random, SPREAD);
        SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
        SenseBuffer ofCones = new SenseBuffer();
        int echoes = 0;
        for (int k = 0; k < 40; k++) {
            double[] directions = new double[3 * 60];
            for (int at = 0; at < directions.length; at += 3) {
                Point d = objects.direction();
                System.arraycopy(new double[] {d.x(), d.y(), d.z()}, 0, directions, at, 3);
            }
            RayPattern pattern = RayPattern.of(directions);
            Pose there = Pose.of(objects.place(), 0);
            SenseOptions lines = SenseOptions.range(0, 30);
            SenseOptions cones = lines.withWidth(random.nextDouble(1, 40));
            for (int threads : new int[] {1, 3}) {
                snapshot.sense(there, pattern, lines.withThreads(threads), out);
                for (int beam = 0; beam < 60; beam++) {
                    Ray ray = new Ray(there.center(), pattern.direction(beam));
                    assertThat(out.distance(beam)).as("%s", ray).isEqualTo(seen.getRayDistance(ray, 0, 30, 0));
                    RayHit hit = seen.castRay(ray, 30);
                    assertThat(out.object(beam)).as("%s", ray).isEqualTo(hit == null ? null : hit.object());
                    if (hit != null) {
                        assertThat(new Point(out.normalX(beam), out.normalY(beam), out.normalZ(beam)))
                                .as("%s", ray)
                                .isEqualTo(hit.normal());
                        echoes += hit.object() instanceof GridObject ? 1 : 0;
                    }
                }
                snapshot.sense(there, pattern, cones.withThreads(threads), ofCones);
                for (int beam = 0; beam < 60; beam++) {
                    Ray ray = new Ray(there.center(), pattern.direction(beam));
                    assertThat(ofCones.distance(beam))
                            .as("%s %s", ray, cones)
                            .isEqualTo(world.getRayDistance(ray, 0, 30, cones.width()));
                }
            }
        }
        assertThat(echoes).isGreaterThan(40 * 60 / 40);
    }

    @ParameterizedTest
    @EnumSource
    void nothingIsAllocated(Dimension dimension) {
        for (double heading : new double[] {0, 33}) {
            Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
            assertThat(world.addObject(RandomGrids.next(random, heading))).isTrue();
            RandomObjects objects = new RandomObjects(random, SPREAD, 0.02);
            for (String robot : ROBOTS) {
                GeometryObject body = robot.equals("disc")
                        ? new CylinderObject(new Point(), 0.2, 0.3)
                        : new BoxObject(new Point(), 0.3, 0.2, 0.4);
                while (!world.addObject(body.moveable(robot).movedTo(objects.place()))) {
                    // until it has found room
                }
            }
            askAll(world, objects);
        }
    }

    private void askAll(Geometry world, RandomObjects objects) {
        Ray[] rays = new Ray[64];
        GeometryObject[] bodies = new GeometryObject[64];
        double[][] places = new double[64][8 * 5];
        for (int k = 0; k < rays.length; k++) {
            rays[k] = new Ray(objects.place(), objects.direction());
            bodies[k] = objects.upright();
            for (int at = 0; at < places[k].length; at += 4) {
                // Off the places where things touch exactly: those take exact numbers, which are allocated.
                Point p = objects.place();
                double off = random.nextDouble(-0.05, 0.05);
                System.arraycopy(new double[] {p.x() + off, 0.013, p.z() - off, at}, 0, places[k], at, 4);
            }
        }
        long[] free = new long[1];
        double[] far = {Double.POSITIVE_INFINITY, 5};
        assertAllocatesNothing("ray", k -> world.getRayDistance(rays[k & 63], 0, far[k & 1], 0));
        assertAllocatesNothing("cone", k -> world.getRayDistance(rays[k & 63], 0, far[k & 1], 1 + k % 90));
        assertAllocatesNothing("test", k -> world.testObject(bodies[k * 7 & 63]) ? 1 : 0);
        assertAllocatesNothing("near", k -> world.getProximity(ROBOTS.get(k & 1), far[k % 3 / 2]));
        assertAllocatesNothing("move", k -> world.simpleMove(ROBOTS.get(k & 1), step(k), 0, 0) ? 1 : 0);
        assertAllocatesNothing("turn and move", k -> {
            String robot = ROBOTS.get(k & 1);
            return (world.simpleTurn(robot, k % 7 * 23.4 - 60) ? 1 : 0)
                    + (world.simpleMove(robot, step(k), 0, 0) ? 2 : 0);
        });
        assertAllocatesNothing("poses", k -> world.freePoses(ROBOTS.get(k & 1), places[k & 63], free));
        assertAllocatesNothing("edges", k -> world.freeEdges(ROBOTS.get(k & 1), places[k & 63], free));
    }

    /** There and back for each of them, then further than there is room. */
    private static double step(int k) {
        return (k % 32 < 16 ? 0.05 : 250) * (k % 4 < 2 ? 1 : -1);
    }

    private static final List<String> ROBOTS = List.of("disc", "box");

    /** Less than a byte a call, of calls that answer a mix. */
    private static void assertAllocatesNothing(String call, IntToDoubleFunction ask) {
        double[] answers = new double[CALLS];
        long bytes = Allocated.everyTime(() -> run(ask, answers));
        assertThat(bytes / (double) CALLS).as(call).isLessThan(1);
        assertThat(Arrays.stream(answers).distinct().count()).as(call).isGreaterThan(1);
    }

    private static void run(IntToDoubleFunction ask, double[] answers) {
        for (int k = 0; k < CALLS; k++) {
            answers[k] = ask.applyAsDouble(k);
        }
    }
}
