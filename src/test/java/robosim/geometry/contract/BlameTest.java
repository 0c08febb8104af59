package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/**
 * Of obstacles that are met at the same time the one added first is blamed, also in a world that was made of a snapshot.
 * The obstacles are alike and stand in one place, so that they are met together whatever is rounded, also by a move that
 * ends within a few last bits of contact, where only the place at its end tells.
 */
@Tag("slow")
class BlameTest {
    private static final String MOVER = "mover";

    private static final int CASES = Effort.cases(60, 24);

    private final List<String> told = new ArrayList<>();
    private int blocked;
    private int barely;
    private int moved;

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT",
        "SPATIAL, EXACT",
        "PLANAR, DOP",
        "SPATIAL, DOP",
        "PLANAR, AABB",
        "SPATIAL, OBB",
        "SPATIAL, SPHERE"
    })
    void aCopyBlamesTheEarliest(Dimension dimension, Accuracy accuracy) {
        Random random = new Random(31 + dimension.ordinal() + 7L * accuracy.ordinal());
        for (int k = 0; k < CASES; k++) {
            Geometry world = world(dimension, accuracy, random);
            String earliest = world.objects().stream()
                    .map(GeometryObject::name)
                    .filter(name -> name != null && name.startsWith("twin"))
                    .findFirst()
                    .orElseThrow();
            told.add(earliest);
            Geometry copy = world.snapshot().toGeometry();
            List<Geometry> worlds =
                    new ArrayList<>(List.of(world, copy, copy.snapshot().toGeometry()));
            worlds.addAll(world.snapshot().toGeometries(2));
            ask(worlds, earliest, random);
        }
        assertThat(told).contains("twin 0", "twin 1", "twin 2");
        assertThat(blocked).isGreaterThan(CASES * 3);
        assertThat(barely).isGreaterThan(CASES);
        assertThat(moved).isGreaterThan(CASES);
    }

    /** Three that are one but for their names, and others; in any order of insertion, with numbers that are used again. */
    private static Geometry world(Dimension dimension, Accuracy accuracy, Random random) {
        Geometry world = new Geometry(40, 10, 40, dimension, accuracy);
        double heading = 360 * random.nextDouble();
        Point place = new Point(3 + random.nextDouble(), 0, 0.4 * random.nextDouble() - 0.2);
        List<GeometryObject> objects = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            BoxObject twin = new BoxObject(place, 1, 1, 2).turned(0, heading);
            objects.add(random.nextBoolean() ? twin.named("twin " + k) : twin.moveable("twin " + k));
        }
        for (int k = 0; k < 12; k++) {
            Point far = new Point(-5 - 10 * random.nextDouble(), 0, 20 * random.nextDouble() - 10);
            CylinderObject other = new CylinderObject(far, 0.3, 1);
            objects.add(random.nextBoolean() ? other.named("other " + k) : other.moveable("other " + k));
        }
        objects.add(
                random.nextBoolean()
                        ? new CylinderObject(new Point(), 0.4, 1).moveable(MOVER)
                        : new BoxObject(new Point(), 0.7, 1, 0.6).moveable(MOVER));
        Collections.shuffle(objects, random);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        for (int k = 0; k < 4; k++) {
            GeometryObject again = objects.get(random.nextInt(objects.size()));
            world.removeObject(String.valueOf(again.name()));
            assertThat(world.addObjectUnchecked(again)).isTrue();
        }
        return world;
    }

    private void ask(List<Geometry> worlds, String earliest, Random random) {
        Geometry first = worlds.get(0);
        double turn = 6 * random.nextDouble() - 3;
        worlds.forEach(world -> world.simpleTurn(MOVER, turn));
        GeometryObject start = first.getObject(MOVER);
        Move far = new Move(6, 0, 0, 0, 0);
        MoveResult way = first.move(MOVER, far);
        assertThat(way.allowed()).isFalse();
        double contact = 6 * way.fraction();
        for (int power = 0; power <= 12; power++) {
            double off = ((1 << power) - 3) * Math.ulp(contact);
            compare(worlds, earliest, start, new Move(contact + off, 0, 0, 0, 0), true);
        }
        compare(worlds, earliest, start, far, false);
        for (Geometry world : worlds) {
            MoveResult result = world.moveToContact(MOVER, far, 0.125);
            GeometryObject obstacle = result.obstacle();
            assertThat(obstacle == null ? "nothing" : obstacle.name()).isEqualTo(earliest);
            assertThat(result.fraction()).isBetween(0.1, 0.9);
            assertThat(world.getObject(MOVER).center())
                    .isEqualTo(first.getObject(MOVER).center());
        }
    }

    private void compare(List<Geometry> worlds, String earliest, GeometryObject start, Move move, boolean isNear) {
        boolean allowed = false;
        for (int k = 0; k < worlds.size(); k++) {
            Geometry world = worlds.get(k);
            MoveResult result = world.move(MOVER, move);
            assertThat(k == 0 || result.allowed() == allowed).isTrue();
            allowed = result.allowed();
            GeometryObject obstacle = result.obstacle();
            assertThat(obstacle == null ? null : obstacle.name())
                    .as("world %d, %s", k, move)
                    .isEqualTo(allowed ? null : earliest);
            if (allowed) {
                assertThat(world.placeObject(MOVER, start.center(), start.heading()))
                        .isTrue();
            }
        }
        blocked += allowed ? 0 : 1;
        moved += allowed ? 1 : 0;
        barely += !allowed && isNear ? 1 : 0;
    }
}
