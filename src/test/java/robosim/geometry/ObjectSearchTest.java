package robosim.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.SignedDistance;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Which objects are where, against worlds that have only one object each. */
class ObjectSearchTest {
    private static final double SIZE = 20;

    private static Point somewhere(SplittableRandom random) {
        // On a lattice of quarters, so that much touches exactly.
        return new Point(
                Math.rint(4 * (random.nextDouble() - 0.5) * 14) / 4,
                Math.rint(4 * (random.nextDouble() - 0.5) * 2) / 4,
                Math.rint(4 * (random.nextDouble() - 0.5) * 14) / 4);
    }

    private static GeometryObject shape(SplittableRandom random) {
        Point at = somewhere(random);
        double size = 0.25 + 0.25 * random.nextInt(6);
        double heading = random.nextBoolean() ? 0 : 360 * random.nextDouble();
        return switch (random.nextInt(7)) {
            case 0 -> new BoxObject(at, size, 1, 0.5).turned(0, heading);
            case 1 -> new CylinderObject(at, size / 2, 1);
            case 2 -> new SphereObject(at, size / 2);
            case 3 -> new CapsuleObject(at, size / 2, 1).turned(heading / 4, heading);
            case 4 ->
                new MeshObject(
                                List.of(new Point(), new Point(size, 0, 0), new Point(0, 1, 0), new Point(0, 0, size)),
                                new int[][] {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}})
                        .turned(0, heading)
                        .movedTo(at);
            case 5 -> {
                BitSet cells = BitSet.valueOf(new long[] {0b1001_0110_1001});
                yield new GridObject(at, size / 4, 1, 4, 3, cells);
            }
            default ->
                new ObjectGroup(List.of(
                                new BoxObject(new Point(), size, 0.5, 0.25),
                                new SphereObject(new Point(0, 0.5, 0), 0.25)))
                        .turned(0, heading)
                        .movedTo(at);
        };
    }

    private static Geometry filled(
            SplittableRandom random, Dimension dimension, Accuracy accuracy, int count, int robots) {
        Geometry world = new Geometry(SIZE, 6, SIZE, dimension, accuracy);
        for (int k = 0; k < count; k++) {
            world.addObjectUnchecked(k % 3 == 0 ? shape(random).named("thing " + k) : shape(random));
        }
        for (int k = 0; k < robots; k++) {
            world.addObjectUnchecked(new CylinderObject(somewhere(random), 0.25, 1).moveable("robot " + k));
        }
        return world;
    }

    /** Whether two objects touch, as a world has it that has only one of them. */
    private static boolean touch(Geometry like, GeometryObject one, GeometryObject other) {
        Geometry alone = new Geometry(SIZE, 6, SIZE, like.dimension(), like.accuracy());
        assertThat(alone.addObjectUnchecked(one)).isTrue();
        return alone.testObject(other);
    }

    private static double distance(Geometry like, GeometryObject from, GeometryObject other) {
        Geometry alone = new Geometry(SIZE, 6, SIZE, like.dimension(), like.accuracy());
        alone.addObjectUnchecked(other.isMoveable() ? other : other.named("other"));
        alone.addObjectUnchecked(from.moveable("own"));
        return alone.getProximity("own", Double.POSITIVE_INFINITY);
    }

    private static void sameAsOneByOne(Geometry world, SplittableRandom random, int questions) {
        ObjectSearch search = world.search();
        int met = 0;
        int none = 0;
        for (int k = 0; k < questions; k++) {
            GeometryObject asked = shape(random);
            List<GeometryObject> expected = world.objects().stream()
                    .filter(each -> touch(world, each, asked))
                    .toList();
            assertThat(search.touching(asked)).as(asked.toString()).isEqualTo(expected);
            assertThat(search.firstTouching(asked)).isEqualTo(expected.stream().findFirst());
            assertThat(world.testObject(asked)).isEqualTo(!expected.isEmpty());
            Point place = somewhere(random);
            GeometryObject robot = world.getObject("robot 0");
            List<GeometryObject> inTheWay = world.objects().stream()
                    .filter(each -> !"robot 0".equals(each.name()))
                    .filter(each -> touch(world, each, robot.movedTo(place)))
                    .toList();
            assertThat(search.inTheWay("robot 0", place, 0)).isEqualTo(inTheWay);
            assertThat(search.firstInTheWay("robot 0", place, 0))
                    .isEqualTo(inTheWay.stream().findFirst());
            assertThat(world.placeObject("robot 0", place, 0))
                    .isEqualTo(inTheWay.isEmpty() && search.fits("robot 0", place, 0));
            met += expected.size();
            none += expected.isEmpty() ? 1 : 0;
        }
        assertThat(met).isGreaterThan(questions / 10);
        assertThat(none).isBetween(questions / 20, questions * 19 / 20);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void whatIsTouchedIsWhatIsTouchedAlone(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(2204);
        for (Accuracy accuracy : Accuracy.values()) {
            int questions = accuracy == Accuracy.EXACT ? 60 : 15;
            sameAsOneByOne(filled(random, dimension, accuracy, 40, 3), random, questions);
        }
        sameAsOneByOne(filled(random, dimension, Accuracy.EXACT, 30, 25), random, 30); // moveable ones in a tree
    }

    /** Also in a copy of a snapshot, whose static objects are shared, and after objects have left. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void copiesAndChangesAnswerTheSame(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(22);
        Geometry world = filled(random, dimension, Accuracy.EXACT, 40, 3);
        Geometry copy = world.snapshot().toGeometry();
        copy.addObjectUnchecked(new SphereObject(new Point(1, 0, 1), 1));
        sameAsOneByOne(copy, random, 25);
        copy.removeObject("thing 3");
        copy.addObjectUnchecked(new SphereObject(new Point(-1, 0, 1), 1));
        sameAsOneByOne(copy, random, 25);
    }

    private static List<NearObject> nearest(Geometry world, GeometryObject from, int count, double max) {
        List<NearObject> all = new ArrayList<>();
        for (GeometryObject each : world.objects()) {
            if (from.name() == null || !from.name().equals(each.name())) {
                double distance = distance(world, from, each);
                if (distance <= max) {
                    all.add(new NearObject(
                            each,
                            distance,
                            ContactQuery.signedDistance(from, each, world.dimension(), Budget.UNLIMITED)));
                }
            }
        }
        all.sort(Comparator.comparingDouble(NearObject::distance)); // stable: the one added first wins a tie
        return all.subList(0, Math.min(count, all.size()));
    }

    /** Objects and distances to the bit; of a grid only the near cells are measured, in as many steps. */
    private static void same(List<NearObject> found, List<NearObject> expected) {
        assertThat(found)
                .extracting(NearObject::object)
                .isEqualTo(expected.stream().map(NearObject::object).toList());
        for (int k = 0; k < found.size(); k++) {
            assertThat(found.get(k).distance()).isEqualTo(expected.get(k).distance());
            SignedDistance signed = found.get(k).signed();
            assertThat(signed.high()).isEqualTo(expected.get(k).signed().high(), within(1e-12));
            boolean isGrid = found.get(k).object() instanceof GridObject;
            assertThat(signed.low())
                    .isEqualTo(isGrid ? signed.low() : expected.get(k).signed().low());
            assertThat(signed.onB())
                    .isEqualTo(isGrid ? signed.onB() : expected.get(k).signed().onB());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7, 100})
    void theNearestAreThoseOfASortedList(int count) {
        SplittableRandom random = new SplittableRandom(count);
        for (Dimension dimension : Dimension.values()) {
            for (int robots : new int[] {2, 24}) {
                Geometry world = filled(random, dimension, Accuracy.EXACT, 30, robots);
                for (int k = 0; k < 12; k++) {
                    double max = k % 3 == 0 ? Double.POSITIVE_INFINITY : 3 * random.nextDouble();
                    Point from = somewhere(random);
                    List<NearObject> expected = nearest(world, new SphereObject(from, 0), count, max);
                    same(world.search().nearest(from, count, max), expected);
                    Geometry copy = world.snapshot().toGeometry();
                    same(copy.search().nearest(from, count, max), expected);
                    world.placeObject("robot 1", from, 10 * k);
                }
                GeometryObject robot = world.getObject("robot 1");
                List<NearObject> around = world.search().nearest("robot 1", count, 5);
                same(around, nearest(world, robot, count, 5));
                assertThat(
                                around.isEmpty()
                                        ? Double.POSITIVE_INFINITY
                                        : around.get(0).distance())
                        .isEqualTo(world.getProximity("robot 1", 5));
            }
        }
    }

    /** Equally far: the one added first. */
    @Test
    void aTieIsWonByTheOneAddedFirst() {
        Geometry world = new Geometry(20, 20, 20);
        for (int k = 0; k < 6; k++) {
            Point at = new Point(k < 2 ? 4 - 8 * k : 0, k / 2 == 1 ? 20 - 8 * k : 0, k > 3 ? 36 - 8 * k : 0);
            world.addObject(new SphereObject(at, 1).named("ball " + k));
        }
        assertThat(world.search().nearest(new Point(), 4, 3))
                .extracting(near -> near.object().name())
                .containsExactly("ball 0", "ball 1", "ball 2", "ball 3");
        assertThat(world.search().nearest(new Point(), 6, 4))
                .extracting(NearObject::distance)
                .containsOnly(world.search().nearest(new Point(), 1, 4).get(0).distance())
                .allMatch(distance -> Math.abs(distance - 3) < 1e-12);
        assertThat(world.search().nearest(new Point(), 9, 2.99)).isEmpty();
        assertThat(world.search().nearest(new Point(), 0, 9)).isEmpty();
    }

    @Test
    void whatIsWrongIsNamed() {
        Geometry world = filled(new SplittableRandom(1), Dimension.SPATIAL, Accuracy.EXACT, 5, 1);
        ObjectSearch search = world.search();
        assertThatThrownBy(() -> search.touching(null)).hasMessageContaining("object");
        assertThatThrownBy(() -> search.firstTouching(null)).hasMessageContaining("object");
        assertThatThrownBy(() -> search.fits(null)).hasMessageContaining("object");
        assertThatThrownBy(() -> search.inTheWay("nobody", new Point(), 0)).hasMessageContaining("nobody");
        assertThatThrownBy(() -> search.inTheWay("thing 0", new Point(), 0)).hasMessageContaining("static");
        assertThatThrownBy(() -> search.inTheWay("robot 0", null, 0)).hasMessageContaining("center");
        assertThatThrownBy(() -> search.firstInTheWay("robot 0", new Point(), Double.NaN))
                .hasMessageContaining("heading");
        assertThatThrownBy(() -> search.nearest((Point) null, 1, 1)).hasMessageContaining("point");
        assertThatThrownBy(() -> search.nearest(new Point(), -1, 1)).hasMessageContaining("count");
        assertThatThrownBy(() -> search.nearest("robot 0", 1, Double.NaN)).hasMessageContaining("max");
        assertThatThrownBy(() -> search.nearest("nobody", 1, 1)).hasMessageContaining("nobody");
        assertThatThrownBy(() -> search.inBox(new Point(), -1, 1, 1)).hasMessageContaining("width");
        assertThat(world).hasToString("SPATIAL EXACT world of 20.0 x 6.0 x 20.0 with 6 objects, 1 of them moveable");
    }
}
