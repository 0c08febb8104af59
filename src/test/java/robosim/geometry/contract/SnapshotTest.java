package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Allocated;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;

/** Worlds made of a snapshot answer to the bit as the one it is of, share what stands still, and keep changes to themselves. */
@Tag("slow")
class SnapshotTest {
    private static final double SIZE = 64;
    private static final int QUESTIONS = Effort.cases(450, 150);
    private static final int SEED = 12;

    /** Of all objects; one in so many moves. */
    private record Kind(Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int movesOneIn) {
        Geometry empty() {
            return new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        }

        RandomObjects objects(SplittableRandom random) {
            return new RandomObjects(random, spread, rise);
        }

        List<String> ask(Geometry world, int questions, long seed) {
            return Script.run(world, questions, seed, spread, rise);
        }
    }

    private static Geometry filled(Kind kind, SplittableRandom random) {
        Geometry world = kind.empty();
        RandomObjects objects = kind.objects(random);
        for (int k = 0; k < kind.count; k++) {
            GeometryObject object = objects.next();
            String name = "object " + k;
            if (random.nextInt(kind.movesOneIn) == 0) {
                object = object.moveable(name);
            } else if (random.nextInt(3) > 0) {
                object = object.named(name);
            }
            assertThat(world.addObjectUnchecked(object)).isTrue();
            if (k > 20 && random.nextInt(8) == 0) {
                world.removeObject("object " + random.nextInt(k - 10)); // ids are used again
            }
        }
        // Off their first places, with something lost to rounding.
        kind.ask(world, 200, random.nextLong());
        return world;
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 300, 14, 0.25, 40", "SPATIAL, EXACT, 300, 10, 0.25, 40",
        "PLANAR, EXACT, 200, 10, 0.25, 4", "SPATIAL, EXACT, 200, 9, 0.25, 4",
        "PLANAR, DOP, 100, 8, 0.25, 4", "SPATIAL, OBB, 100, 7, 0.25, 12",
        "PLANAR, SPHERE, 80, 10, 0.25, 12", "SPATIAL, AABB, 100, 8, 0.25, 3",
        // Stacked: they stand in an octree.
        "SPATIAL, EXACT, 250, 3, 4, 12", "SPATIAL, DOP, 160, 3, 4, 4"
    })
    void answersToTheBit(
            Dimension dimension, Accuracy accuracy, int count, double spread, double rise, int movesOneIn) {
        // Where boxes around the objects count, most moves are refused.
        int questions = accuracy == Accuracy.AABB ? 2 * QUESTIONS : QUESTIONS;
        Kind kind = new Kind(dimension, accuracy, count, spread, rise, movesOneIn);
        Geometry world = filled(kind, new SplittableRandom(count + 31L * accuracy.ordinal() + dimension.ordinal()));
        Snapshot snapshot = world.snapshot();
        Snapshot read = read(bytes(snapshot));
        Geometry copy = snapshot.toGeometry();
        Geometry copyOfCopy = copy.snapshot().toGeometry();
        List<Geometry> siblings = snapshot.toGeometries(2);

        List<String> truth = kind.ask(world, questions, SEED);
        assertThat(truth).anyMatch(line -> line.contains("go true")).anyMatch(line -> line.contains("go false"));
        assertThat(truth).anyMatch(line -> line.contains("test true")).anyMatch(line -> line.contains("test false"));
        assertThat(kind.ask(copy, questions, SEED)).as("a copy").isEqualTo(truth);
        assertThat(kind.ask(copyOfCopy, questions, SEED)).as("a copy's copy").isEqualTo(truth);
        assertThat(kind.ask(siblings.get(1), questions, SEED)).as("one of two").isEqualTo(truth);
        assertThat(kind.ask(read.toGeometry(), questions, SEED))
                .as("read from a stream")
                .isEqualTo(truth);
        assertThat(kind.ask(snapshot.toGeometry(), questions, 6))
                .as("other questions")
                .isNotEqualTo(truth);
        assertThat(exactly(read.objects())).isEqualTo(exactly(snapshot.objects()));
        assertThat(snapshot.size()).isEqualTo(snapshot.objects().size()).isGreaterThan(count / 2);
    }

    private static List<String> exactly(List<GeometryObject> objects) {
        return objects.stream().map(Script::exactly).toList();
    }

    @ParameterizedTest
    @CsvSource({"PLANAR, EXACT, 200, 10, 0.25", "SPATIAL, EXACT, 200, 9, 0.25", "SPATIAL, DOP, 160, 3, 4"})
    void aChangedCopyChangesNoOther(Dimension dimension, Accuracy accuracy, int count, double spread, double rise) {
        Kind kind = new Kind(dimension, accuracy, count, spread, rise, 8);
        Geometry world = filled(kind, new SplittableRandom(count));
        Snapshot snapshot = world.snapshot();
        Geometry untouched = snapshot.toGeometry();
        Geometry changed = snapshot.toGeometry();
        change(changed, kind, new SplittableRandom(8));
        change(world, kind, new SplittableRandom(8));
        assertThat(exactly(changed.objects())).isEqualTo(exactly(world.objects()));
        List<String> truth = kind.ask(world, QUESTIONS, 9);
        assertThat(kind.ask(changed, QUESTIONS, 9)).as("changed").isEqualTo(truth);
        assertThat(kind.ask(changed.snapshot().toGeometry(), QUESTIONS, 10))
                .as("a copy of what was changed")
                .isEqualTo(kind.ask(world, QUESTIONS, 10));
        List<String> before = kind.ask(snapshot.toGeometry(), QUESTIONS, 9);
        assertThat(before).isNotEqualTo(truth);
        assertThat(kind.ask(untouched, QUESTIONS, 9)).as("made before").isEqualTo(before);
    }

    /** Static and moveable objects come; then some that were shared go, and more come. */
    private static void change(Geometry world, Kind kind, SplittableRandom random) {
        RandomObjects objects = kind.objects(random);
        for (int round = 0; round < 2; round++) {
            for (int k = 0; k < 30; k++) {
                String name = "late " + round + " " + k;
                GeometryObject object = objects.next();
                world.addObjectUnchecked(k % 3 == 0 ? object.moveable(name) : object.named(name));
                world.addObject(objects.primitive());
            }
            kind.ask(world, 100, round);
            List<GeometryObject> all = world.objects();
            int removed = 0;
            for (int k = 0; k < all.size(); k += 9) {
                String name = all.get(k).name();
                if (name != null) {
                    assertThat(world.removeObject(name)).isTrue();
                    assertThat(world.hasObject(name)).isFalse();
                    removed++;
                }
            }
            assertThat(removed).isGreaterThan(5);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 4})
    void manyThreadsAtOnce(double rise) throws Exception {
        Kind kind = new Kind(Dimension.SPATIAL, Accuracy.EXACT, 250, rise > 1 ? 3 : 9, rise, 12);
        Geometry world = filled(kind, new SplittableRandom(77));
        Snapshot snapshot = world.snapshot();
        int threads = 8;
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            CyclicBarrier start = new CyclicBarrier(threads);
            List<Future<List<String>>> answers = new ArrayList<>();
            for (int k = 0; k < threads; k++) {
                boolean changes = k % 4 == 3;
                answers.add(pool.submit(() -> {
                    start.await(); // levels and regions are made by whoever asks first
                    Geometry copy = snapshot.toGeometry();
                    if (changes) {
                        change(copy, kind, new SplittableRandom(8));
                    }
                    return kind.ask(copy, QUESTIONS, SEED);
                }));
            }
            Geometry changed = snapshot.toGeometry();
            change(changed, kind, new SplittableRandom(8));
            List<String> ofChanged = kind.ask(changed, QUESTIONS, SEED);
            List<String> truth = kind.ask(world, QUESTIONS, SEED);
            for (int k = 0; k < threads; k++) {
                assertThat(answers.get(k).get()).as("thread %d", k).isEqualTo(k % 4 == 3 ? ofChanged : truth);
            }
        } finally {
            pool.shutdownNow();
        }
    }

    /** What a copy allocates does not know how much stands still. */
    @Test
    void aCopyCostsItsMoversOnly() {
        Snapshot small = grid(100).snapshot();
        Snapshot large = grid(20_000).snapshot();
        small.toGeometry();
        large.toGeometry();
        long ofSmall = Allocated.once(() -> small.toGeometry());
        long ofLarge = Allocated.once(() -> large.toGeometry());
        assertThat(ofLarge).isBetween(ofSmall / 2, ofSmall + 4096);
        assertThat(ofSmall).isLessThan(200_000);
        Geometry copy = large.toGeometry();
        assertThat(Allocated.once(() -> copy.snapshot()))
                .as("a snapshot of a copy")
                .isLessThan(50_000);
        assertThat(Allocated.once(() -> large.toGeometries(100))).isLessThan(100 * 42_500);
        assertThat(Allocated.once(() -> grid(20_000))).isGreaterThan(20_000 * 100);
    }

    /** A second snapshot shares what stands still with the first, until any of that comes or goes. */
    @Test
    void whatStandsStillIsTakenInOnce() {
        Geometry world = grid(20_000);
        Ray ray = new Ray(new Point(300, 0, 0), new Point(-1, 0, 0));
        Snapshot first = world.snapshot();
        world.simpleMove("robot 3", 0, 0, 5);
        assertThat(Allocated.everyTime(() -> world.snapshot())).isLessThan(50_000);
        Geometry moved = world.snapshot().toGeometry();
        assertThat(moved.getObject("robot 3")).isEqualTo(world.getObject("robot 3"));
        assertThat(first.toGeometry().getObject("robot 3")).isNotEqualTo(moved.getObject("robot 3"));
        double before = moved.getRayDistance(ray, 0, 400, 0);

        world.addObjectUnchecked(new BoxObject(new Point(200, 0, 0), 1, 1, 1).named("post"));
        Snapshot with = world.snapshot();
        assertThat(with.size()).isEqualTo(first.size() + 1);
        assertThat(with.toGeometry().getRayDistance(ray, 0, 400, 0)).isEqualTo(99.5);
        world.removeObject("post");
        world.addObjectUnchecked(new BoxObject(new Point(220, 0, 0), 1, 1, 1).named("post"));
        assertThat(world.snapshot().toGeometry().getRayDistance(ray, 0, 400, 0)).isEqualTo(79.5);
        world.removeObject("post");
        assertThat(world.snapshot().toGeometry().getRayDistance(ray, 0, 400, 0)).isEqualTo(before);
        assertThat(first.toGeometry().getRayDistance(ray, 0, 400, 0)).isEqualTo(before);
    }

    private static Geometry grid(int count) {
        Geometry world = new Geometry(1000, 10, 1000);
        for (int k = 0; k < count; k++) {
            world.addObjectUnchecked(new BoxObject(new Point(k % 200 - 100, 0, k / 200 - 50), 0.5, 1, 0.5));
        }
        for (int k = 0; k < 10; k++) {
            world.addObjectUnchecked(new CylinderObject(new Point(k, 0, 300), 0.3, 1).moveable("robot " + k));
        }
        return world;
    }

    @Test
    void placementsOfAMeshShareItsTrianglesAgain() {
        Geometry world = new Geometry(1000, 10, 1000);
        MeshObject mesh = RandomObjects.meshOf(new BoxObject(new Point(), 1, 1, 1));
        for (int k = 0; k < 50; k++) {
            world.addObjectUnchecked(mesh.movedTo(new Point(3 * k, 0, 0)).turned(0, k));
        }
        byte[] bytes = bytes(world.snapshot());
        List<GeometryObject> read = read(bytes).objects();
        assertThat(read).isEqualTo(world.objects());
        assertThat(read.stream().map(object -> ((MeshObject) object).triangles()))
                .allMatch(triangles -> triangles == ((MeshObject) read.get(0)).triangles());
    }

    /** Each stream holds one number that no world would take. */
    @Test
    void refusesWhatAWorldWould() {
        assertRefused(123.25, Double.NaN, "x must be");
        assertRefused(123.25, 1000, "within the world");
        assertRefused(7.125, -1, "");
        assertRefused(7.125, 5000, "within the world");
        assertRefused(33.5, 34.5, "heading");
        assertRefused(33.5, Double.NaN, "heading");
        assertRefused(640.0, Double.POSITIVE_INFINITY, "width");
        assertRefused(640.0, -640.0, "width");
        assertThat(read(patched(123.25, 123.5)).objects()).hasSize(2);
    }

    private static void assertRefused(double number, double other, String reason) {
        assertThatThrownBy(() -> read(patched(number, other)))
                .as("%s in place of %s", other, number)
                .isInstanceOf(UncheckedIOException.class)
                .cause()
                .isInstanceOf(InvalidObjectException.class)
                .hasMessageContaining(reason);
    }

    /** A small snapshot with one number written over. */
    private static byte[] patched(double number, double other) {
        Geometry world = new Geometry(640, 100, 641);
        world.addObject(new BoxObject(new Point(123.25, 0, 1), 7.125, 3, 4));
        world.addObject(
                new CylinderObject(new Point(20, 0, 2), 2, 3).moveable("robot").turned(0, 33.5));
        byte[] bytes = bytes(world.snapshot());
        int found = 0;
        for (int at = 0; at + 8 <= bytes.length; at++) {
            if (ByteBuffer.wrap(bytes, at, 8).getDouble() == number) {
                ByteBuffer.wrap(bytes, at, 8).putDouble(other);
                found++;
            }
        }
        assertThat(found).as("places of %s", number).isEqualTo(1);
        return bytes;
    }

    private static byte[] bytes(Snapshot snapshot) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(snapshot);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static Snapshot read(byte[] bytes) {
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
            return (Snapshot) in.readObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }
}
