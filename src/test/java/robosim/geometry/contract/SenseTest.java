package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
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
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SenseOptions.Carrier;

/** Many beams in one call answer to the bit as one by one, in a world and in its snapshot, on any number of threads. */
@Tag("slow")
class SenseTest {
    private static final double SIZE = 64;

    private final SplittableRandom random = new SplittableRandom(19);

    private Geometry filled(Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int oneIn) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        RandomObjects objects = new RandomObjects(random, spread, rise);
        for (int k = 0; k < count; k++) {
            GeometryObject object = objects.next();
            String name = "object " + k;
            boolean moves = random.nextInt(oneIn) == 0;
            GeometryObject given = moves ? object.moveable(name) : k % 3 > 0 ? object.named(name) : object;
            assertThat(world.addObjectUnchecked(given)).isTrue();
        }
        for (int k = 0; k < 3; k++) {
            GeometryObject robot = k == 0
                    ? new CylinderObject(objects.place(), 0.3, 0.6)
                    : objects.next().movedTo(objects.place()).turned(k == 2 ? 33 : 0, objects.heading());
            world.addObjectUnchecked(robot.moveable("robot " + k));
        }
        Script.run(world, 100, random.nextLong(), spread, rise); // off their first places
        return world;
    }

    private RayPattern pattern(int kind) {
        return switch (kind) {
            case 0 -> RayPattern.fan(random.nextDouble(-180, 180), random.nextDouble(-3, 3), 300);
            case 1 -> RayPattern.layers(new double[] {-30, -7.5, 0, 11}, 90, -random.nextDouble(4), 80);
            case 2 -> RayPattern.pinhole(20, 15, random.nextDouble(20, 150));
            default -> {
                RandomObjects any = new RandomObjects(random, 1);
                double[] directions = new double[3 * 70];
                for (int at = 0; at < directions.length; at += 3) {
                    Point direction = any.direction();
                    directions[at] = direction.x();
                    directions[at + 1] = direction.y();
                    directions[at + 2] = direction.z();
                }
                yield RayPattern.of(directions);
            }
        };
    }

    private Pose pose(RandomObjects objects, int kind) {
        Pose there = Pose.of(objects.place(), kind == 0 ? 0 : objects.heading());
        return kind < 2 ? there : there.turned(random.nextDouble(-90, 90), 0);
    }

    private static Point turned(double[] r, double x, double y, double z) {
        return new Point(
                r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z);
    }

    private static Point turned(double[] rotation, Point direction) {
        return turned(rotation, direction.x(), direction.y(), direction.z());
    }

    /** A ray of a carrier's own frame in the world. */
    private static Ray placed(GeometryObject carrier, Ray mount) {
        Point start = turned(carrier.rotation(), mount.start());
        Point c = carrier.center();
        return new Ray(
                new Point(c.x() + start.x(), c.y() + start.y(), c.z() + start.z()),
                turned(carrier.rotation(), mount.direction()));
    }

    private static Ray beam(Pose mount, RayPattern pattern, int beam) {
        return new Ray(mount.center(), turned(mount.rotation(), pattern.direction(beam)));
    }

    /** One question, and its answers one by one. */
    private record Question(String name, Pose pose, RayPattern pattern, SenseOptions options) {
        /** The world whose single rays are the truth. */
        Geometry seen(Geometry world) {
            return Heights.seen(world, name, pose, pattern, options.width());
        }

        double single(Geometry world, int beam) {
            Ray ray = beam(pose, pattern, beam);
            if (name == null) {
                return world.getRayDistance(ray, options.min(), options.max(), options.width());
            }
            return options.carrier() == Carrier.IGNORED
                    ? world.getSonarDistance(name, ray, options.min(), options.max(), options.width())
                    : world.getRayDistance(
                            placed(world.getObject(name), ray), options.min(), options.max(), options.width());
        }

        void ask(Geometry world, SenseBuffer out) {
            if (name == null) {
                world.sense(pose, pattern, options, out);
            } else {
                world.sense(name, pose, pattern, options, out);
            }
        }

        void ask(Snapshot snapshot, int threads, SenseBuffer out) {
            if (name == null) {
                snapshot.sense(pose, pattern, options.withThreads(threads), out);
            } else {
                snapshot.sense(name, pose, pattern, options.withThreads(threads), out);
            }
        }
    }

    private Question question(RandomObjects objects, int k) {
        String name = k % 4 == 0 ? null : "robot " + k % 3;
        SenseOptions options = SenseOptions.range(k % 5 == 0 ? 0.7 : 0, k % 7 == 0 ? 5 : Double.POSITIVE_INFINITY)
                .withWidth(k % 3 == 0 ? random.nextDouble(1, 40) : 0)
                .withCarrier(k % 6 < 4 ? Carrier.IGNORED : Carrier.SEEN);
        RandomObjects near = new RandomObjects(random, 0.5);
        return new Question(name, pose(name == null ? objects : near, k % 3), pattern(k % 4), options);
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 300, 14, 0.25, 40", "SPATIAL, EXACT, 300, 10, 0.25, 40",
        "PLANAR, EXACT, 200, 10, 0.25, 4", "SPATIAL, EXACT, 200, 9, 0.25, 4",
        "PLANAR, DOP, 80, 18, 0.1, 4", "SPATIAL, DOP, 80, 12, 0.25, 12",
        "PLANAR, OBB, 80, 18, 0.1, 12", "SPATIAL, OBB, 80, 12, 0.25, 12",
        "PLANAR, SPHERE, 60, 18, 0.1, 12", "SPATIAL, SPHERE, 60, 12, 0.25, 4",
        "PLANAR, AABB, 80, 18, 0.1, 3", "SPATIAL, AABB, 80, 12, 0.25, 3",
        "SPATIAL, EXACT, 250, 3, 4, 12"
    })
    void asOneByOne(Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int oneIn) {
        Geometry world = filled(dimension, accuracy, count, spread, rise, oneIn);
        Snapshot snapshot = world.snapshot();
        Geometry copy = snapshot.toGeometry();
        RandomObjects objects = new RandomObjects(random, spread, rise);
        SenseBuffer out = new SenseBuffer();
        SenseBuffer ofSnapshot = new SenseBuffer(Extra.OBJECTS);
        int echoes = 0;
        int beams = 0;
        int withHeights = 0;
        for (int k = 0; k < 24; k++) {
            Question question = question(objects, k);
            double[] truth = new double[question.pattern.size()];
            Geometry seen = question.seen(world);
            withHeights += seen == world ? 0 : 1;
            for (int beam = 0; beam < truth.length; beam++) {
                truth[beam] = question.single(seen, beam);
                echoes += truth[beam] < Double.POSITIVE_INFINITY && truth[beam] > question.options.min() ? 1 : 0;
            }
            beams += truth.length;
            question.ask(world, out);
            assertSame(question, out, truth);
            assertThat(out.dimension()).isEqualTo(seen.dimension());
            question.ask(copy, out);
            assertSame(question, out, truth);
            for (int threads : new int[] {1, 2, 5}) {
                question.ask(snapshot, threads, ofSnapshot);
                assertSame(question, ofSnapshot, truth);
            }
        }
        assertThat(echoes).isBetween(beams / 5, beams * 19 / 20);
        assertThat(withHeights)
                .isBetween(dimension == Dimension.PLANAR ? 5 : 0, dimension == Dimension.PLANAR ? 19 : 0);
    }

    private static void assertSame(Question question, SenseBuffer out, double[] truth) {
        assertThat(out.size()).isEqualTo(truth.length);
        assertThat(Arrays.copyOf(out.distances(), out.size()))
                .as("%s", question)
                .isEqualTo(truth);
        assertThat(out.distance(truth.length - 1)).isEqualTo(truth[truth.length - 1]);
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 200, 12, 0.25, 12",
        "SPATIAL, EXACT, 200, 9, 0.25, 4",
        "SPATIAL, EXACT, 200, 3, 4, 20",
        "PLANAR, DOP, 100, 8, 0.25, 8",
        "SPATIAL, SPHERE, 100, 8, 0.25, 8"
    })
    void objectsAndNormalsAreThoseOfCastRay(
            Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int oneIn) {
        Geometry world = filled(dimension, accuracy, count, spread, rise, oneIn);
        Snapshot snapshot = world.snapshot();
        RandomObjects objects = new RandomObjects(random, spread, rise);
        SenseBuffer out = new SenseBuffer(Extra.NORMALS, Extra.OBJECTS);
        int hits = 0;
        int misses = 0;
        for (int k = 0; k < 16; k++) {
            Pose pose = pose(new RandomObjects(random, 0.5), k % 3);
            RayPattern pattern = pattern(k % 4);
            String name = k % 4 == 0 ? null : "robot " + k % 3;
            SenseOptions options = SenseOptions.range(0.5, 12).withThreads(1 + k % 3);
            Geometry without = snapshot.toGeometry();
            GeometryObject carrier = null;
            if (name == null) {
                pose = pose(objects, k % 3);
            }
            without = Heights.seen(without, name, pose, pattern, 0);
            if (name == null) {
                world.sense(pose, pattern, options, out);
            } else {
                carrier = world.getObject(name);
                without.removeObject(name);
                snapshot.sense(name, pose, pattern, options, out);
            }
            for (int beam = 0; beam < pattern.size(); beam++) {
                Ray ray = beam(pose, pattern, beam);
                RayHit hit = without.castRay(carrier == null ? ray : placed(carrier, ray), 12);
                GeometryObject met = out.object(beam);
                if (hit == null) {
                    misses++;
                    assertThat(met).isNull();
                    assertThat(out.distance(beam)).isEqualTo(Double.POSITIVE_INFINITY);
                    assertThat(out.normalX(beam)).isEqualTo(0);
                } else {
                    hits++;
                    assertThat(out.distance(beam)).isEqualTo(Math.max(0.5, hit.distance()));
                    assertThat(new Point(out.normalX(beam), out.normalY(beam), out.normalZ(beam)))
                            .isEqualTo(hit.normal());
                    assertThat(out.normals()[3 * beam + 1]).isEqualTo(out.normalY(beam));
                    assertThat(met).isNotNull();
                    assertThat(met.isMoveable() ? met.name() : met)
                            .isEqualTo(met.isMoveable() ? hit.object().name() : hit.object());
                }
            }
        }
        assertThat(hits).isGreaterThan(500);
        assertThat(misses).isGreaterThan(40);
    }

    @ParameterizedTest
    @EnumSource
    void aScanIsAFan(Dimension dimension) {
        Geometry world = filled(dimension, Accuracy.EXACT, 200, 12, 0.25, 10);
        SenseBuffer out = new SenseBuffer();
        for (int k = 0; k < Effort.cases(40); k++) {
            double first = k % 2 == 0 ? -135 : random.nextDouble(-360, 360);
            double step = k % 2 == 0 ? 0.25 : random.nextDouble(-5, 5);
            Point mount = new Point(random.nextDouble(-0.2, 0.2), 0.1, 0);
            double[] scan = new double[500];
            world.scan("robot " + k % 3, mount, first, step, 0.1, 20, scan);
            RayPattern fan = RayPattern.fan(first, step, 500);
            world.sense("robot " + k % 3, Pose.of(mount, 0), fan, SenseOptions.range(0.1, 20), out);
            assertThat(Arrays.copyOf(out.distances(), 500)).isEqualTo(scan);
        }
    }

    /** A camera that has looked at a PLANAR world sees what comes, goes and moves afterwards. */
    @Test
    void heightsFollowChanges() {
        for (int round = 0; round < 6; round++) {
            Geometry world = filled(Dimension.PLANAR, Accuracy.EXACT, 60, 8, 0.25, round < 3 ? 4 : 20);
            Geometry given = round % 2 == 0 ? world : world.snapshot().toGeometry();
            RayPattern camera = RayPattern.pinhole(40, 30, 100);
            SenseOptions options = SenseOptions.range(0, 30);
            int changed = 0;
            for (int step = 0; step < 12; step++) {
                Pose above = Pose.of(new Point(0, 0.7, 0), 0).turned(-5, 0);
                SenseBuffer before = new SenseBuffer();
                given.sense(above, camera, options, before);
                Script.run(given, 10, random.nextLong(), 8, 0.25);
                given.removeObject("object " + step);
                given.addObjectUnchecked(new BoxObject(new Point(step - 5, 0.5, 3), 0.3, 1 + step, 0.3));
                SenseBuffer out = new SenseBuffer();
                given.sense(above, camera, options, out);
                Question question = new Question(null, above, camera, options);
                Geometry twin = Heights.of(given);
                double[] truth = new double[camera.size()];
                Arrays.setAll(truth, beam -> question.single(twin, beam));
                assertSame(question, out, truth);
                changed += Arrays.equals(truth, Arrays.copyOf(before.distances(), truth.length)) ? 0 : 1;
            }
            assertThat(changed).isGreaterThan(3);
        }
    }

    @Test
    void eachObjectIsOneInstance() {
        Geometry world = new Geometry(20, 5, 20);
        BoxObject wall = new BoxObject(new Point(4, 0, 0), 0.5, 2, 6);
        GeometryObject robot = new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot");
        world.addObject(wall);
        world.addObject(robot);
        SenseBuffer out = new SenseBuffer(Extra.OBJECTS);
        RayPattern ahead = RayPattern.fan(-2, 2, 3);
        SenseOptions options = SenseOptions.range(0, 10);
        world.sense("robot", Pose.ORIGIN, ahead, options, out);
        assertThat(out.object(0)).isSameAs(wall);
        assertThat(out.object(2)).isSameAs(wall);
        world.sense(Pose.of(new Point(-3, 0, 0), 0), ahead, options, out);
        assertThat(out.object(1)).isSameAs(robot);
        // A smaller pattern leaves nothing of the larger one behind.
        world.sense(Pose.of(new Point(-3, 0, 0), 180), RayPattern.fan(0, 1, 1), options, out);
        assertThat(out.size()).isEqualTo(1);
        assertThat(out.object(0)).isNull();
        assertThatThrownBy(() -> out.object(1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("beam must be from 0 to size - 1, 0 (got: 1)");
    }

    /** In a pool of its own, so that there are helpers on any machine. */
    @Test
    void manyThreadsAtOnce() throws Exception {
        Geometry world = filled(Dimension.SPATIAL, Accuracy.EXACT, 250, 9, 0.25, 12);
        Snapshot snapshot = world.snapshot();
        RayPattern lidar = RayPattern.layers(new double[] {-15, -10, -5, 0, 5, 10, 15}, 0, 0.5, 720);
        SenseOptions options = SenseOptions.range(0, 50);
        SenseBuffer truth = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
        world.sense("robot 0", Pose.ORIGIN, lidar, options, truth);
        ForkJoinPool pool = new ForkJoinPool(5);
        try {
            List<Runnable> calls = new ArrayList<>();
            for (int k = 0; k < 12; k++) {
                int threads = 1 + k % 5;
                calls.add(() -> {
                    SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
                    for (int round = 0; round < 4; round++) {
                        snapshot.sense("robot 0", Pose.ORIGIN, lidar, options.withThreads(threads), out);
                        assertThat(Arrays.equals(out.distances(), truth.distances()))
                                .isTrue();
                        assertThat(Arrays.equals(out.normals(), truth.normals()))
                                .isTrue();
                    }
                });
            }
            for (var call : calls.stream().map(pool::submit).toList()) {
                call.get();
            }
        } finally {
            pool.shutdownNow();
        }
    }

    /** A pool whose threads are all taken delays nobody: the calling thread does all of the work. */
    @Test
    void busyHelpersAreNotWaitedFor() throws Exception {
        Snapshot snapshot =
                filled(Dimension.PLANAR, Accuracy.EXACT, 100, 9, 0.25, 12).snapshot();
        RayPattern fan = RayPattern.fan(0, 0.1, 3600);
        ForkJoinPool pool = new ForkJoinPool(1);
        try {
            SenseBuffer out = new SenseBuffer();
            pool.submit(() -> snapshot.sense(
                            "robot 0",
                            Pose.ORIGIN,
                            fan,
                            SenseOptions.range(0, 9).withThreads(4),
                            out))
                    .get(60, TimeUnit.SECONDS);
            assertThat(out.size()).isEqualTo(3600);
        } finally {
            pool.shutdownNow();
        }
    }

    @Test
    void badArgumentsAreNamed() {
        Geometry world = new Geometry(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot"));
        world.addObject(new BoxObject(new Point(4, 0, 0), 0.5, 2, 6).named("wall"));
        RayPattern fan = RayPattern.fan(0, 1, 360);
        SenseOptions options = SenseOptions.range(0, 10);
        SenseBuffer out = new SenseBuffer();
        refused("name must be that of an object", () -> world.sense("robbot", Pose.ORIGIN, fan, options, out));
        refused("name must be that of a moveable", () -> world.sense("wall", Pose.ORIGIN, fan, options, out));
        refused("name must be that of an object", () -> world.snapshot().sense("x", Pose.ORIGIN, fan, options, out));
        refused(
                "width must be 0 for a buffer with normals, which cones have not (got: 5.0)",
                () -> world.sense(Pose.ORIGIN, fan, options.withWidth(5), new SenseBuffer(Extra.NORMALS)));
        refused(
                "direction 1 must not be vertical in a PLANAR world, which has no heights (got: (0.0, 2.0, 0.0))",
                () -> world.sense(
                        Pose.ORIGIN, RayPattern.of(new double[] {1, 0, 0, 0, 2, 0}), options.withWidth(5), out));
        refused("the buffer must have been made for OBJECTS", () -> out.object(0));
        refused("the buffer must have been made for NORMALS", () -> out.normals());
        refused("beam must be one that was answered, and none was: sense first (got: 0)", () -> out.distance(0));
        refused("min must be from 0 to 2^100 (got: -1.0)", () -> SenseOptions.range(-1, 2));
        refused("max must be at least min, 3.0 (got: 2.0)", () -> SenseOptions.range(3, 2));
        refused("width must be from 0 up to", () -> options.withWidth(180));
        refused("threads must be from 1 to 1024 (got: 0)", () -> options.withThreads(0));
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(message);
    }
}
