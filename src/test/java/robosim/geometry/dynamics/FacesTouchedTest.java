package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** A body that touches several faces of one object has the contacts that it has where each is an object of its own. */
@Tag("slow")
class FacesTouchedTest {
    private static final Surface SURFACE = new Surface(0, 0.4, 0.3);

    /** One without friction beside it, where the impulses at several points are those of one solution. */
    private static final Surface SMOOTH = new Surface(0, 0, 0);

    /** A room: its floor is at height 0, its walls stand at x = 2 and z = 2. */
    private static final List<GeometryObject> WALLS = List.of(box(2.5, 0, 0, 1, 2, 8), box(0, 0, 2.5, 4, 2, 1));

    private static final GeometryObject FLOOR = box(0, -0.5, 0, 8, 1, 8);

    private static BoxObject box(double x, double y, double z, double width, double height, double length) {
        return new BoxObject(new Point(x, y, z), width, height, length);
    }

    private static List<GeometryObject> room(String made, Dimension dimension) {
        List<GeometryObject> parts = new ArrayList<>(WALLS);
        if (dimension == Dimension.SPATIAL) {
            parts.add(FLOOR);
        }
        return switch (made) {
            case "parts" -> parts;
            case "group" -> List.of(new ObjectGroup(parts).named("room"));
            case "mesh" -> List.of(mesh(dimension == Dimension.SPATIAL));
            case "grid" -> List.of(grid());
            case "border" -> List.of();
            default -> throw new IllegalArgumentException(made);
        };
    }

    private static MeshObject mesh(boolean hasFloor) {
        List<Point> corners = List.of(
                new Point(-4, 0, -4),
                new Point(2, 0, -4),
                new Point(2, 0, 2),
                new Point(-4, 0, 2),
                new Point(2, 1, -4),
                new Point(2, 1, 2),
                new Point(-4, 1, 2));
        int[][] walls = {{1, 2, 5, 4}, {2, 3, 6, 5}};
        int[][] all = {walls[0], walls[1], {0, 1, 2, 3}};
        return new MeshObject(corners, hasFloor ? all : walls).named("room");
    }

    /** Cells of 0.5 from -4 to 4; those of the walls are occupied. */
    private static GridObject grid() {
        BitSet cells = new BitSet();
        for (int cell = 0; cell < 256; cell++) {
            cells.set(cell, cell % 16 >= 12 || cell / 16 >= 12);
        }
        return new GridObject(new Point(0, 0, 0), 0.5, 2, 16, 16, cells).named("room");
    }

    private static GeometryObject robot(String shape, double x, double y, double z) {
        Point center = new Point(x, y, z);
        GeometryObject robot = switch (shape) {
            case "box" -> new BoxObject(center, 0.6, 0.5, 0.4).moveable("robot");
            case "cylinder" -> new CylinderObject(center, 0.25, 0.5).moveable("robot");
            case "sphere" -> new SphereObject(center, 0.25).moveable("robot");
            default -> throw new IllegalArgumentException(shape);
        };
        return robot;
    }

    /** A contact as it is told whoever is touched; of unit normals, two are the same if they differ in rounding alone. */
    private record Touch(long nx, long ny, long nz, BodyContact.Phase phase) {
        static Touch of(BodyContact contact) {
            Point n = contact.normal();
            return new Touch(
                    Math.round(n.x() * 1e9), Math.round(n.y() * 1e9), Math.round(n.z() * 1e9), contact.phase());
        }

        @Override
        public String toString() {
            return "%s along (%s, %s, %s)".formatted(phase, nx / 1e9, ny / 1e9, nz / 1e9);
        }
    }

    /**
     * The contacts of each of some steps in which a robot drives into a corner, presses on both walls, is
     * placed away from one of them, and comes back.
     */
    private static List<List<BodyContact>> drive(String made, Dimension dimension, String shape, Surface surface) {
        boolean isBorder = made.equals("border");
        double size = isBorder ? 4 : 40;
        double floor = isBorder && dimension == Dimension.SPATIAL ? -2 : 0;
        Geometry world = new Geometry(size, size, size, dimension, Accuracy.EXACT);
        room(made, dimension).forEach(world::addObjectUnchecked);
        world.addObject(robot(shape, 1.2, floor + 0.25 + 1e-7, 1.3));
        Dynamics dynamics = new Dynamics(world, SURFACE);
        dynamics.add("robot", Body.of(10, 0.5).withFloorFriction(0.8).withSurface(surface));
        OmnidirectionalDrive drive = new OmnidirectionalDrive(1, 2, 90, 180);
        dynamics.drive("robot", drive.driving(0.6, 0.5, 0));
        List<List<BodyContact>> steps = new ArrayList<>();
        for (int step = 0; step < 50; step++) {
            if (step == 30) {
                Point here = world.getObject("robot").center();
                world.placeObject("robot", new Point(here.x() - 0.2, here.y(), here.z()), 0);
            }
            StepResult result = dynamics.step(0.05);
            List<BodyContact> contacts = new ArrayList<>(result.contacts());
            contacts.addAll(result.ended());
            contacts.sort(Comparator.comparing(contact -> Touch.of(contact).toString()));
            steps.add(contacts);
        }
        return steps;
    }

    /** The contacts with a room of several objects, by what drives there and how. */
    private static final Map<List<Object>, List<List<BodyContact>>> SEVERAL = new HashMap<>();

    private static List<Arguments> rooms() {
        List<Arguments> all = new ArrayList<>();
        for (String shape : List.of("box", "cylinder", "sphere")) {
            for (String made : List.of("group", "mesh", "border")) {
                all.add(Arguments.of(made, Dimension.SPATIAL, shape));
            }
            for (String made : List.of("group", "mesh", "grid", "border")) {
                all.add(Arguments.of(made, Dimension.PLANAR, shape));
            }
        }
        return all;
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void aRoomOfOneObjectIsTouchedAsOneOfSeveral(String made, Dimension dimension, String shape) {
        assertSame(made, dimension, shape, SMOOTH);
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void alsoWhereWallsRub(String made, Dimension dimension, String shape) {
        assertSame(made, dimension, shape, SURFACE);
    }

    private static void assertSame(String made, Dimension dimension, String shape, Surface surface) {
        List<List<BodyContact>> expected = SEVERAL.computeIfAbsent(
                List.of(dimension, shape, surface), key -> drive("parts", dimension, shape, surface));
        List<List<BodyContact>> got = drive(made, dimension, shape, surface);
        assertThat(expected.get(29)).hasSize(dimension == Dimension.SPATIAL ? 3 : 2);
        assertThat(expected)
                .anySatisfy(step -> assertThat(step)
                        .anySatisfy(contact -> assertThat(contact.phase()).isEqualTo(BodyContact.Phase.END)));
        double sum = 0;
        for (int step = 0; step < expected.size(); step++) {
            List<BodyContact> one = got.get(step);
            List<BodyContact> several = expected.get(step);
            String where = "step " + step;
            assertThat(touches(one)).as(where).isEqualTo(touches(several));
            for (int k = 0; k < one.size(); k++) {
                assertThat(one.get(k).other()).as(where).isEqualTo(made.equals("border") ? null : "room");
                double impulse = several.get(k).impulse();
                sum += impulse;
                if (surface == SMOOTH) {
                    // A hit is resolved a rounding earlier or later: the drive goes on from there.
                    assertThat(one.get(k).impulse()).as(where).isCloseTo(impulse, within(3e-5));
                }
            }
        }
        assertThat(sum).isGreaterThan(1);
    }

    private static List<Touch> touches(List<BodyContact> contacts) {
        return contacts.stream().map(Touch::of).toList();
    }

    /** Half of what it touches rises by ten degrees: less than what a face may turn by from one time to the next. */
    @Test
    void theFootOfARampIsTouchedAlongBothNormals() {
        double rise = 4 * Math.tan(Math.toRadians(10));
        List<Point> corners = List.of(
                new Point(-4, 0, -4),
                new Point(0, 0, -4),
                new Point(0, 0, 4),
                new Point(-4, 0, 4),
                new Point(4, rise, -4),
                new Point(4, rise, 4));
        int[] level = {0, 3, 2, 1};
        int[] ramp = {1, 2, 5, 4};
        List<List<Touch>> one = climb(new MeshObject(corners, new int[][] {level, ramp}));
        List<List<Touch>> two =
                climb(new MeshObject(corners, new int[][] {level}), new MeshObject(corners, new int[][] {ramp}));
        assertThat(one).isEqualTo(two);
        assertThat(one)
                .anySatisfy(step -> assertThat(step)
                        .extracting(Touch::phase)
                        .containsExactly(BodyContact.Phase.LAST, BodyContact.Phase.LAST));
        assertThat(one.get(one.size() - 1)).hasSize(1);
        assertThat(one.get(0)).hasSize(1).doesNotContainAnyElementsOf(one.get(one.size() - 1));
    }

    private static List<List<Touch>> climb(GeometryObject... ground) {
        Geometry world = new Geometry(40, 40, 40, Dimension.SPATIAL, Accuracy.EXACT);
        for (GeometryObject each : ground) {
            world.addObjectUnchecked(each); // they touch
        }
        world.addObject(robot("box", -0.5, 0.25 + 1e-7, 0));
        Dynamics dynamics = new Dynamics(world, SURFACE);
        dynamics.add("robot", Body.of(10, 0.5).withFloorFriction(0.8));
        dynamics.drive("robot", new DifferentialDrive(0.4, 1, 2).driving(0.5, 0));
        List<List<Touch>> steps = new ArrayList<>();
        for (int step = 0; step < 60; step++) {
            StepResult result = dynamics.step(0.05);
            steps.add(Stream.concat(result.contacts().stream(), result.ended().stream())
                    .map(Touch::of)
                    .sorted(Comparator.comparing(Touch::toString))
                    .toList());
        }
        return steps;
    }

    /** The face of a cart of two halves turns with it, and stays one. */
    @Test
    void aFaceThatTurnsIsOneContact() {
        BoxObject whole = box(0, 0, 0, 0.4, 1, 0.8);
        ObjectGroup halves = new ObjectGroup(List.of(box(0, 0, 0.2, 0.4, 1, 0.4), box(0, 0, -0.2, 0.4, 1, 0.4)));
        List<BodyContact.Phase> phases = turn(halves);
        assertThat(phases).isEqualTo(turn(whole)).hasSizeGreaterThan(10);
        assertThat(phases.subList(1, phases.size())).containsOnly(BodyContact.Phase.LAST);
    }

    private static List<BodyContact.Phase> turn(GeometryObject cart) {
        Geometry world = new Geometry(40, 4, 40, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(
                cart.kind() == GeometryObject.Kind.BOX
                        ? ((BoxObject) cart).moveable("cart")
                        : ((ObjectGroup) cart).moveable("cart"));
        world.addObject(new CylinderObject(new Point(0.5, 0, 0), 0.25, 1).moveable("puck"));
        Dynamics dynamics = new Dynamics(world, SURFACE);
        dynamics.add("cart", Body.of(50, 5));
        dynamics.add("puck", Body.of(2, 0.1).withFloorFriction(0.3));
        dynamics.drive("cart", new DifferentialDrive(0.6, 2, 5).driving(0.8, 60));
        List<BodyContact.Phase> phases = new ArrayList<>();
        for (int step = 0; step < 15; step++) {
            StepResult result = dynamics.step(0.05);
            result.contacts().forEach(contact -> phases.add(contact.phase()));
            result.ended().forEach(contact -> phases.add(contact.phase()));
        }
        return phases;
    }
}
