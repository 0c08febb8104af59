package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.RayHit;
import robosim.geometry.SenseBuffer;
import robosim.geometry.SenseBuffer.Extra;
import robosim.geometry.Snapshot;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Ray;
import robosim.geometry.model.RayPattern;
import robosim.geometry.model.SenseOptions;
import robosim.geometry.model.SphereObject;

/**
 * What beams share when they are asked together changes nothing: where they graze corners and edges, where objects coincide
 * and the first one wins, where they begin inside, where coordinates are huge or tiny, and where all is crowded.
 */
@Tag("slow")
class TogetherTest {
    private static final int UNITS = 12;

    private final SplittableRandom random = new SplittableRandom(23);
    private final SenseBuffer out = new SenseBuffer(Extra.OBJECTS, Extra.NORMALS);
    private final SenseBuffer distances = new SenseBuffer(Extra.OBJECTS);
    private double scale = 1;

    private double grid() {
        return scale * random.nextInt(-UNITS, UNITS + 1) / 2.0;
    }

    private double size() {
        return scale * random.nextInt(0, 5) / 2.0;
    }

    private Point place() {
        return new Point(grid(), grid(), grid());
    }

    /** Solids on a grid, upright or at quarter turns, some at one place. */
    private GeometryObject solid(Point at) {
        GeometryObject solid = switch (random.nextInt(5)) {
            case 0 -> new CylinderObject(at, size() / 2, size());
            case 1 -> new SphereObject(at, size() / 2);
            case 2 -> new CapsuleObject(at, size() / 4, size() / 2);
            case 3 ->
                new ObjectGroup(List.of(
                                new BoxObject(new Point(), scale, 2 * scale, scale),
                                new BoxObject(new Point(scale, 0, 0), scale, scale, scale)))
                        .movedTo(at);
            default -> new BoxObject(at, size(), size(), size());
        };
        int turns = random.nextInt(6);
        return turns < 3 ? solid : turns == 3 ? solid.turned(0, 45) : solid.turned(90, 90 * turns);
    }

    private Geometry world(Dimension dimension, int count, int oneIn) {
        double side = 4 * UNITS * scale;
        Geometry world = new Geometry(side, side, side, dimension, Accuracy.EXACT);
        List<GeometryObject> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            boolean isAgain = !all.isEmpty() && random.nextInt(6) == 0;
            GeometryObject next = isAgain ? all.get(random.nextInt(all.size())) : solid(place());
            all.add(next);
            GeometryObject added = random.nextInt(oneIn) == 0 ? next.moveable("m " + k) : next.named("s " + k);
            assertThat(world.addObjectUnchecked(added)).isTrue();
        }
        world.addObjectUnchecked(new CylinderObject(place(), scale / 4, scale / 2).moveable("robot"));
        return world;
    }

    /** Directions between points of the grid, of any length, which meet corners, edges and faces' planes. */
    private RayPattern aimed(boolean isLevel, int count) {
        double[] ways = new double[3 * count];
        double ax = random.nextInt(-6, 7);
        double ay = isLevel ? 0 : random.nextInt(-6, 7);
        double az = random.nextInt(-6, 7);
        for (int at = 0; at < ways.length; at += 3) {
            while (ways[at] == 0 && ways[at + 2] == 0) {
                ways[at] = (ax + random.nextInt(-2, 3)) / 2;
                ways[at + 1] = isLevel ? 0 : (ay + random.nextInt(-2, 3)) / 2;
                ways[at + 2] = (az + random.nextInt(-2, 3)) / 2;
            }
        }
        return RayPattern.of(ways);
    }

    private RayPattern pattern(Dimension dimension, int kind) {
        boolean isLevel = dimension == Dimension.PLANAR;
        return switch (kind) {
            case 0, 1 -> aimed(isLevel, 100);
            case 2 -> RayPattern.fan(45 * random.nextInt(8), 0.5, 200);
            case 3 -> RayPattern.fan(-180, 22.5, 16);
            case 4 -> isLevel ? aimed(true, 70) : RayPattern.pinhole(21, 19, 90);
            case 5 -> RayPattern.layers(new double[] {-45, 0, 45, 60}, 0, 5, 72);
            default -> RayPattern.fan(random.nextDouble(360), 5.625, 64);
        };
    }

    static Ray beam(Pose pose, RayPattern pattern, int k) {
        Point d = pattern.direction(k);
        double[] r = pose.rotation();
        return new Ray(
                pose.center(),
                new Point(
                        r[0] * d.x() + r[1] * d.y() + r[2] * d.z(),
                        r[3] * d.x() + r[4] * d.y() + r[5] * d.z(),
                        r[6] * d.x() + r[7] * d.y() + r[8] * d.z()));
    }

    private static long unsure() {
        return StageCounters.counts().getOrDefault("PacketSearch", 0L);
    }

    @ParameterizedTest
    @CsvSource({
        "SPATIAL, 0, 300, 9", "SPATIAL, 0, 40, 2", "SPATIAL, 40, 200, 20", "SPATIAL, -60, 200, 9",
        "SPATIAL, -400, 60, 9", "SPATIAL, 90, 60, 9", "PLANAR, 0, 200, 9", "SPATIAL, 0, 1, 9"
    })
    void raysAsOneByOne(Dimension dimension, int power, int count, int oneIn) {
        scale = Math.scalb(1.0, power);
        int hits = 0;
        int inside = 0;
        int beams = 0;
        long before = unsure();
        for (int round = 0; round < Effort.cases(40, 8); round++) {
            Geometry world = world(dimension, count, oneIn);
            Snapshot snapshot = world.snapshot();
            Geometry copy = snapshot.toGeometry();
            for (int kind = 0; kind < 7; kind++) {
                RayPattern pattern = pattern(dimension, kind);
                Point within = world.objects().get(0).center();
                Pose pose = Pose.of(kind == 6 ? within : place(), kind % 2 == 0 ? 0 : 90);
                double max = kind == 1 ? scale * random.nextInt(1, 8) : Double.POSITIVE_INFINITY;
                SenseOptions options = SenseOptions.range(kind == 2 ? scale : 0, max);
                world.sense(pose, pattern, options, out);
                Geometry seen = Heights.seen(world, null, pose, pattern, 0);
                for (int k = 0; k < pattern.size(); k++) {
                    RayHit hit = seen.castRay(beam(pose, pattern, k), max);
                    beams++;
                    if (hit == null) {
                        assertThat(out.distance(k)).isEqualTo(Double.POSITIVE_INFINITY);
                        assertThat(out.object(k)).isNull();
                        continue;
                    }
                    hits++;
                    inside += hit.distance() == 0 ? 1 : 0;
                    assertThat(out.distance(k)).isEqualTo(Math.max(options.min(), hit.distance()));
                    assertThat(out.object(k).name()).isEqualTo(hit.object().name());
                    assertThat(new Point(out.normalX(k), out.normalY(k), out.normalZ(k)))
                            .isEqualTo(hit.normal());
                }
                for (int threads = 0; threads < 4; threads++) {
                    if (threads == 0) {
                        copy.sense(pose, pattern, options, distances);
                    } else {
                        snapshot.sense(pose, pattern, options.withThreads(threads), distances);
                    }
                    for (int k = 0; k < pattern.size(); k++) {
                        assertThat(distances.distance(k)).isEqualTo(out.distance(k));
                        assertThat(distances.object(k) == null).isEqualTo(out.object(k) == null);
                        assertThat(distances.object(k) == null
                                        || distances
                                                .object(k)
                                                .name()
                                                .equals(out.object(k).name()))
                                .isTrue();
                    }
                }
            }
        }
        long asked = unsure() - before;
        assertThat(beams).isGreaterThan(Effort.cases(20_000, 4000));
        if (count > 1) {
            assertThat(hits).isBetween(beams / 10, beams * 99 / 100);
            assertThat(inside).isGreaterThan(beams / 1000);
        }
        if (dimension == Dimension.PLANAR) { // only the layers see heights there
            assertThat(asked).isBetween(1L, 20L * beams);
        } else if (Math.abs(power) < 100 && count > 1) {
            // On a grid much is grazed; five passes of each beam.
            assertThat(asked).isBetween(beams / 10L, 20L * beams);
        }
    }

    /** Where nothing is on a grid, hardly a ray is left to the kernel before its nearest leaf is known. */
    @Test
    void mostAreDecidedTogether() {
        RandomObjects objects = new RandomObjects(random, 12, 1);
        Geometry world = new Geometry(60, 60, 60);
        for (int k = 0; k < 400; k++) {
            world.addObjectUnchecked(
                    (k % 2 == 0 ? new BoxObject(new Point(), 1, 0.7, 1.3) : new SphereObject(new Point(), 0.6))
                            .movedTo(objects.place())
                            .turned(random.nextDouble(180), random.nextDouble(180)));
        }
        RayPattern camera = RayPattern.pinhole(64, 48, 80);
        int beams = 0;
        int hits = 0;
        long before = unsure();
        for (int round = 0; round < Effort.cases(30); round++) {
            Pose pose = Pose.of(new Point(random.nextDouble(-9, 9), random.nextDouble(-9, 9), 9.3), 31)
                    .turned(11, 7);
            world.sense(pose, camera, SenseOptions.range(0, 100), out);
            for (int k = 0; k < camera.size(); k++) {
                double single = world.getRayDistance(beam(pose, camera, k), 0, 100, 0);
                assertThat(out.distance(k)).isEqualTo(single);
                hits += single < Double.POSITIVE_INFINITY && single > 0 ? 1 : 0;
            }
            beams += camera.size();
        }
        assertThat(hits).isBetween(beams / 4, beams * 19 / 20);
        assertThat(unsure() - before).isLessThan(beams / 20);
    }

    @ParameterizedTest
    @CsvSource({
        "SPATIAL, 0, 300",
        "PLANAR, 0, 300",
        "SPATIAL, 30, 60",
        "PLANAR, -30, 60",
        "PLANAR, -300, 40",
        "SPATIAL, 0, 4",
        "PLANAR, 0, 4"
    })
    void conesAsOneByOne(Dimension dimension, int power, int count) {
        scale = Math.scalb(1.0, power);
        int hits = 0;
        int beams = 0;
        for (int round = 0; round < Effort.cases(30, 15); round++) {
            Geometry world = world(dimension, count, round % 2 == 0 ? 3 : 30);
            if (round % 5 == 4) {
                crowd(world);
            }
            Snapshot snapshot = world.snapshot();
            for (int kind = 2; kind < 7; kind++) {
                RayPattern pattern = pattern(dimension, kind);
                double width = random.nextInt(4) == 0 ? random.nextDouble(0.01, 179) : random.nextDouble(5, 30);
                double max = round % 3 == 0 ? scale * random.nextInt(1, 8) : Double.POSITIVE_INFINITY;
                SenseOptions options = SenseOptions.range(0, max).withWidth(width);
                Ray ahead = new Ray(new Point(), new Point(1, 0, 0));
                world.sense("robot", Pose.ORIGIN, pattern, options, distances);
                for (int k = 0; k < pattern.size(); k++) {
                    double single = world.getSonarDistance(
                            "robot", new Ray(ahead.start(), pattern.direction(k)), 0, max, width);
                    assertThat(distances.distance(k)).as("%s", pattern).isEqualTo(single);
                    hits += single < Double.POSITIVE_INFINITY && single > 0 ? 1 : 0;
                }
                beams += pattern.size();
                double[] first = distances.distances().clone();
                for (int threads = 1; threads < 4; threads++) {
                    snapshot.sense("robot", Pose.ORIGIN, pattern, options.withThreads(threads), distances);
                    for (int k = 0; k < pattern.size(); k++) {
                        assertThat(distances.distance(k)).isEqualTo(first[k]);
                    }
                }
            }
        }
        assertThat(hits).isBetween(beams / 20, beams * 99 / 100);
    }

    /** More objects about the robot than a ring of cones keeps. */
    private void crowd(Geometry world) {
        Point at = world.getObject("robot").center();
        for (int k = 0; k < 300; k++) {
            double angle = random.nextDouble(2 * Math.PI);
            double far = scale * random.nextDouble(0.3, 0.9);
            Point there = new Point(at.x() + far * StrictMath.cos(angle), at.y(), at.z() + far * StrictMath.sin(angle));
            world.addObjectUnchecked(new SphereObject(there, scale * 0.02));
        }
    }

    /** Helpers have copies of their own, whatever the beams share. */
    @Test
    void onManyThreads() throws Exception {
        Geometry world = world(Dimension.SPATIAL, 200, 9);
        Snapshot snapshot = world.snapshot();
        RayPattern camera = RayPattern.pinhole(90, 70, 70);
        Pose pose = Pose.of(new Point(0.3, 0.2, 0.1), 20);
        world.sense(pose, camera, SenseOptions.range(0, 50), out);
        double[] truth = out.distances().clone();
        ForkJoinPool pool = new ForkJoinPool(3);
        try {
            for (int threads = 1; threads < 4; threads++) {
                SenseOptions options = SenseOptions.range(0, 50).withThreads(threads);
                pool.submit(() -> snapshot.sense(pose, camera, options, distances))
                        .get();
                for (int k = 0; k < truth.length; k++) {
                    assertThat(distances.distance(k)).isEqualTo(truth[k]);
                }
            }
        } finally {
            pool.shutdownNow();
        }
    }
}
