package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * Straight moves that are only answered yes or no, among what overlaps, touches and stands about: the same answer and the
 * same place as beside each other object alone by the way that also finds the contact.
 */
class StraightMovesTest {
    private static final double WORLD = 24;

    private static GeometryObject thing(SplittableRandom random, int k, Point at) {
        GeometryObject thing = switch (k % 10) {
            case 0, 1, 2, 3 -> new CylinderObject(at, 0.5, 1);
            case 4 -> new BoxObject(at, 0.8, 1, 0.5);
            case 5 -> new SphereObject(at, 0.4);
            case 6 ->
                new ObjectGroup(List.of(
                                new CylinderObject(new Point(0.3, 0, 0), 0.25, 1),
                                new BoxObject(new Point(-0.3, 0, 0), 0.4, 1, 0.4)))
                        .movedTo(at);
            case 7 -> new CylinderObject(at, 0.3, 1).turned(30, 20);
            case 8 -> // a disc off its centre
                new ObjectGroup(List.of(new SphereObject(new Point(-0.7, 0, 0.2), 0.3))).movedTo(at);
            default ->
                new MeshObject(
                                List.of(new Point(), new Point(1, 0, 0), new Point(0, 0, 1), new Point(0, 1, 0)),
                                new int[][] {{0, 1, 2}, {0, 1, 3}})
                        .movedTo(at);
        };
        return random.nextInt(3) == 0 ? thing.turned(0, random.nextDouble(360)) : thing;
    }

    private static Point place(SplittableRandom random, Dimension dimension, boolean isLattice) {
        double reach = WORLD / 2 - 1.5;
        double height = dimension == Dimension.PLANAR ? 0 : random.nextInt(-1, 2) * 0.75;
        return isLattice
                ? new Point(random.nextInt(-9, 10), height, random.nextInt(-9, 10))
                : new Point(random.nextDouble(-reach, reach), height, random.nextDouble(-reach, reach));
    }

    @ParameterizedTest
    @CsvSource({
        "PLANAR, 10, false",
        "PLANAR, 60, false",
        "PLANAR, 60, true",
        "SPATIAL, 12, true",
        "SPATIAL, 60, false",
        "SPATIAL, 60, true"
    })
    void goWhereEachPairAloneLetsThem(Dimension dimension, int count, boolean isLattice) {
        SplittableRandom random = new SplittableRandom(count + (isLattice ? 1 : 0));
        Geometry world = new Geometry(WORLD, WORLD, WORLD, dimension, Accuracy.EXACT);
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            GeometryObject thing = thing(random, k, place(random, dimension, isLattice));
            GeometryObject added = k % 5 == 4 ? thing : thing.moveable("robot " + k);
            if (world.addObjectUnchecked(added)) {
                objects.add(added);
            }
        }
        int made = 0;
        int refused = 0;
        for (int step = 0; step < 500; step++) {
            int own = random.nextInt(objects.size());
            String name = objects.get(own).name();
            if (name == null) {
                continue;
            }
            double far = random.nextInt(6) == 0 ? 20 : random.nextInt(4) == 0 ? 0x1p-40 : 1;
            double x = isLattice ? far * random.nextInt(-2, 3) * 0.5 : far * random.nextDouble(-1, 1);
            double z = isLattice ? far * random.nextInt(-2, 3) * 0.5 : far * random.nextDouble(-1, 1);
            double y = dimension == Dimension.SPATIAL && step % 4 == 0 ? random.nextInt(-1, 2) * 0.25 : 0;
            GeometryObject expected = alone(objects, own, new Move(x, y, z, 0, 0), dimension);
            String what = "%s by (%s, %s, %s)".formatted(objects.get(own), x, y, z);
            boolean isMade = world.simpleMove(name, x, y, z);
            assertThat(isMade).as(what).isEqualTo(expected != null);
            GeometryObject now = world.getObject(name);
            assertThat(now).as(what).isEqualTo(isMade ? expected : objects.get(own));
            objects.set(own, now);
            made += isMade ? 1 : 0;
            refused += isMade ? 0 : 1;
            assertThat(world.testObject(now.named("another").movedTo(now.center())))
                    .isTrue();
        }
        assertThat(made).isGreaterThan(100);
        assertThat(refused).isGreaterThan(50);
    }

    /** The object after the move, or null where any other one or the border is in its way. */
    private static GeometryObject alone(List<GeometryObject> objects, int own, Move move, Dimension dimension) {
        GeometryObject after = null;
        for (int k = 0; k < objects.size(); k++) {
            if (k == own) {
                continue;
            }
            Geometry pair = new Geometry(WORLD, WORLD, WORLD, dimension, Accuracy.EXACT);
            pair.addObjectUnchecked(objects.get(own));
            pair.addObjectUnchecked(objects.get(k));
            String name = String.valueOf(objects.get(own).name());
            if (!pair.moveToContact(name, move, 0).allowed()) {
                return null;
            }
            after = pair.getObject(name);
        }
        return after;
    }

    /** A group of a single disc that is not about its centre: the way of the disc counts, not that of the centre. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aDiscOffTheCentreOfItsGroup(Dimension dimension) {
        int free = 0;
        for (int k = 0; k < 72; k++) {
            double heading = Math.toRadians(5 * k);
            Geometry world = new Geometry(WORLD, WORLD, WORLD, dimension, Accuracy.EXACT);
            world.addObject(new CylinderObject(new Point(2, 0, 1), 0.1, 1).named("post"));
            world.addObject(new ObjectGroup(List.of(new SphereObject(new Point(-1, 0, 0), 0.3))).moveable("robot"));
            double x = 5 * Math.cos(heading);
            double z = 5 * Math.sin(heading);
            Snapshot before = world.snapshot();
            boolean isFree = world.simpleMove("robot", x, 0, z);
            assertThat(isFree)
                    .as("%s, %s degrees", dimension, 5 * k)
                    .isEqualTo(before.toGeometry()
                            .move("robot", new Move(x, 0, z, 0, 0))
                            .allowed());
            free += isFree ? 1 : 0;
        }
        assertThat(free).isBetween(60, 71);
    }
}
