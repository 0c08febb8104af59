package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.RayHit;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Ray;

/**
 * A world answers as if all its objects were asked one by one, to the bit, whatever was added and removed before and in
 * whatever order its objects came.
 */
@Tag("slow")
class WorldAgainstListTest {
    private static final double SIZE = 64;
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final Accuracy[] LEVELS = Accuracy.values();

    private final List<Integer> movers = new ArrayList<>();
    private int hits;
    private int questions;

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 300, 14, 0.25", "SPATIAL, EXACT, 300, 10, 0.25",
        "PLANAR, EXACT, 50, 5, 0.25", "SPATIAL, EXACT, 50, 4, 0.25",
        "PLANAR, DOP, 100, 8, 0.25", "SPATIAL, OBB, 100, 7, 0.25",
        "PLANAR, SPHERE, 80, 10, 0.25", "SPATIAL, AABB, 100, 8, 0.25",
        // Stacked: they stand in an octree.
        "SPATIAL, EXACT, 250, 3, 4", "SPATIAL, DOP, 160, 3, 4"
    })
    void asksItsObjectsAsAPlainListDoes(Dimension dimension, Accuracy accuracy, int count, double spread, double rise) {
        SplittableRandom random = new SplittableRandom(count + 31L * accuracy.ordinal() + dimension.ordinal());
        RandomObjects objects = new RandomObjects(random, spread, rise);
        PlainList list = new PlainList(SIZE, dimension, accuracy);
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        fill(world, list, objects, random, count);
        Geometry shuffled = shuffled(list, random, dimension, accuracy);
        for (int round = 0; round < Effort.cases(8); round++) {
            overlaps(world, shuffled, list, objects, random);
            beams(world, shuffled, list, objects, random);
            casts(world, shuffled, list, objects, random);
        }
        for (int round = 0; round < Effort.cases(4); round++) {
            nearest(world, shuffled, list, objects, random);
            moves(world, shuffled, list, random);
        }
        assertThat(hits).as("of " + questions + " questions").isBetween(questions / 10, questions * 9 / 10);
        assertThat(world.objects()).containsExactlyElementsOf(list.objects());
        assertThat(shuffled.objects()).containsExactlyInAnyOrderElementsOf(list.objects());
    }

    /** Additions and removals in between, some of them checked. */
    private void fill(Geometry world, PlainList list, RandomObjects objects, SplittableRandom random, int count) {
        for (int k = 0; list.objects().size() < count; k++) {
            GeometryObject object = objects.next().named("object " + k);
            if (random.nextInt(8) == 0) {
                object = object.moveable("object " + k);
            }
            boolean free = !list.test(object, world.accuracy());
            if (random.nextInt(4) == 0) {
                assertThat(world.addObject(object)).as("adding %s", object).isEqualTo(free);
            } else {
                assertThat(world.addObjectUnchecked(object))
                        .as("adding %s", object)
                        .isTrue();
                free = true;
            }
            if (free) {
                list.add(object);
            }
            if (!list.objects().isEmpty() && random.nextInt(6) == 0) {
                int out = random.nextInt(list.objects().size());
                assertThat(world.removeObject(
                                String.valueOf(list.objects().get(out).name())))
                        .isTrue();
                list.remove(out);
            }
        }
        for (int k = 0; k < count; k++) {
            if (list.objects().get(k).isMoveable()) {
                movers.add(k);
            }
        }
        assertThat(movers).hasSizeBetween(1, count / 2);
    }

    private static Geometry shuffled(PlainList list, SplittableRandom random, Dimension dimension, Accuracy accuracy) {
        List<GeometryObject> order = new ArrayList<>(list.objects());
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, accuracy);
        while (!order.isEmpty()) {
            assertThat(world.addObjectUnchecked(order.remove(random.nextInt(order.size()))))
                    .isTrue();
        }
        return world;
    }

    private void overlaps(
            Geometry world, Geometry shuffled, PlainList list, RandomObjects objects, SplittableRandom random) {
        GeometryObject object = objects.next();
        Accuracy at = LEVELS[random.nextInt(LEVELS.length)];
        boolean truth = list.test(object, at);
        count(truth);
        assertThat(world.testObject(object, at)).as("%s at %s", object, at).isEqualTo(truth);
        assertThat(shuffled.testObject(object, at))
                .as("%s at %s, shuffled", object, at)
                .isEqualTo(truth);
    }

    private void count(boolean hit) {
        questions++;
        hits += hit ? 1 : 0;
    }

    private void beams(
            Geometry world, Geometry shuffled, PlainList list, RandomObjects objects, SplittableRandom random) {
        Ray ray = new Ray(objects.place(), objects.direction());
        double min = random.nextBoolean() ? 0 : random.nextDouble(2);
        double max = random.nextBoolean() ? INFINITE : min + random.nextDouble(6);
        double width = random.nextBoolean() ? 0 : random.nextDouble(random.nextBoolean() ? 10 : 179);
        Accuracy at = LEVELS[random.nextInt(LEVELS.length)];
        double truth = list.ray(ray, min, max, width, at);
        count(truth < INFINITE);
        String what = "%s from %s to %s, %s degrees, at %s".formatted(ray, min, max, width, at);
        assertThat(world.getRayDistance(ray, min, max, width, at)).as(what).isEqualTo(truth);
        assertThat(shuffled.getRayDistance(ray, min, max, width, at))
                .as(what + ", shuffled")
                .isEqualTo(truth);
        int own = movers.get(random.nextInt(movers.size()));
        String name = String.valueOf(list.objects().get(own).name());
        Ray mount = new Ray(new RandomObjects(random, 1).place(), ray.direction());
        if (world.dimension() == Dimension.SPATIAL
                || list.objects().get(own).pose().isUpright()) {
            assertThat(world.getSonarDistance(name, mount, min, max, width))
                    .as("%s on %s: %s", mount, name, what)
                    .isEqualTo(list.sonar(own, mount, min, max, width));
        }
    }

    private void casts(
            Geometry world, Geometry shuffled, PlainList list, RandomObjects objects, SplittableRandom random) {
        Ray ray = new Ray(objects.place(), objects.direction());
        double max = random.nextInt(3) == 0 ? random.nextDouble(8) : INFINITE;
        RayHit truth = list.cast(ray, max);
        count(truth != null);
        assertThat(world.castRay(ray, max)).as("%s to %s", ray, max).isEqualTo(truth);
        RayHit other = shuffled.castRay(ray, max);
        assertThat(other == null ? INFINITE : other.distance())
                .as("%s to %s, shuffled", ray, max)
                .isEqualTo(truth == null ? INFINITE : truth.distance());
    }

    private void nearest(
            Geometry world, Geometry shuffled, PlainList list, RandomObjects objects, SplittableRandom random) {
        int own = random.nextInt(list.objects().size());
        double max = random.nextBoolean() ? random.nextDouble(1) : INFINITE;
        double truth = list.proximity(own, max);
        count(truth < INFINITE);
        String name = String.valueOf(list.objects().get(own).name());
        String what = list.objects().get(own) + " within " + max;
        assertThat(world.getProximity(name, max)).as(what).isEqualTo(truth);
        assertThat(shuffled.getProximity(name, max)).as(what + ", shuffled").isEqualTo(truth);
    }

    private void moves(Geometry world, Geometry shuffled, PlainList list, SplittableRandom random) {
        for (int own : movers) {
            GeometryObject mover = list.objects().get(own);
            Move move = move(random);
            PlainList.Free truth = list.move(own, move);
            count(truth.allowed());
            String what = "%s by %s".formatted(mover, move);
            MoveResult result = world.move(String.valueOf(mover.name()), move);
            MoveResult other = shuffled.move(String.valueOf(mover.name()), move);
            assertThat(result.allowed()).as(what).isEqualTo(truth.allowed());
            assertThat(result.fraction()).as(what).isEqualTo(truth.fraction());
            assertThat(result.turnFraction()).as(what).isEqualTo(truth.turnFraction());
            assertThat(other.allowed()).as(what + ", shuffled").isEqualTo(truth.allowed());
            assertThat(other.fraction()).as(what + ", shuffled").isEqualTo(truth.fraction());
            assertThat(other.turnFraction()).as(what + ", shuffled").isEqualTo(truth.turnFraction());
            GeometryObject moved = world.getObject(String.valueOf(mover.name()));
            assertThat(shuffled.getObject(String.valueOf(mover.name()))).isEqualTo(moved);
            if (truth.allowed()) {
                list.replace(own, moved);
            } else {
                assertThat(moved).as(what).isEqualTo(mover);
            }
        }
    }

    private static Move move(SplittableRandom random) {
        double far = random.nextInt(4) == 0 ? 0 : random.nextDouble(2);
        double turn = random.nextInt(3) == 0 ? 0 : random.nextDouble(-60, 60);
        double tip = random.nextInt(6) == 0 ? random.nextDouble(-60, 60) : 0;
        return new Move(
                far * random.nextDouble(-1, 1),
                far * random.nextDouble(-0.2, 0.2),
                far * random.nextDouble(-1, 1),
                tip,
                turn);
    }
}
