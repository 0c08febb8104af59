package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CapsuleObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/**
 * Steps of a scene and of its mirror image are mirror images of each other, to the bit, unless a body has to stop where the world's
 * swept moves let it: they may round otherwise.
 */
class PlanarSymmetryTest {
    private static final int STEPS = 60;

    /**
     * An object, and what moves it. Its shape is its own mirror image, so it is mirrored in X by driving backwards at the
     * opposite heading, and in Z by driving forward there.
     *
     * @param velocity ahead, to the right, and degrees a second; the command where it drives
     */
    private record Item(
            String name,
            int kind,
            Point at,
            double width,
            double length,
            double heading,
            Twist velocity,
            double mass,
            boolean isDriven,
            double floor,
            Surface surface) {
        GeometryObject shape() {
            return switch (kind) {
                case 0 ->
                    new CylinderObject(at, width / 2, 1).turned(0, heading).moveable(name);
                case 1 -> new BoxObject(at, width, 1, length).turned(0, heading).moveable(name);
                case 2 ->
                    new CapsuleObject(at, width / 4, length).turned(90, heading).moveable(name);
                default -> new BoxObject(at, width, 1, length).turned(0, heading);
            };
        }

        Item mirrored(boolean isInX, String as) {
            return new Item(
                    as,
                    kind,
                    isInX ? new Point(0 - at.x(), 0, at.z()) : new Point(at.x(), 0, 0 - at.z()),
                    width,
                    length,
                    -heading,
                    isInX
                            ? new Twist(-velocity.x(), 0, velocity.z(), -velocity.ry())
                            : new Twist(velocity.x(), 0, -velocity.z(), -velocity.ry()),
                    mass,
                    isDriven,
                    floor,
                    surface);
        }

        boolean moves() {
            return kind < 3;
        }
    }

    private static double number(SplittableRandom random, double from, double to) {
        return Math.rint(random.nextDouble(from, to) * 1024) / 1024;
    }

    /** A wall, or a disc, a box or a lying capsule. */
    private static Item item(SplittableRandom random, String name, boolean isWall) {
        double[] frictions = {0, 0.25, 0.5};
        double friction = frictions[random.nextInt(3)];
        return new Item(
                name,
                isWall ? 3 : random.nextInt(3),
                new Point(number(random, -4, 4), 0, number(random, -4, 4)),
                number(random, 0.25, isWall ? 3 : 1),
                number(random, 0.25, isWall ? 0.5 : 1),
                random.nextInt(3) == 0 ? 90 * random.nextInt(-1, 2) : number(random, -179, 179),
                new Twist(
                        number(random, -2, 2),
                        0,
                        number(random, -2, 2),
                        random.nextBoolean() ? 0 : number(random, -100, 100)),
                number(random, 1, 20),
                random.nextInt(3) == 0,
                random.nextInt(3) == 0 ? 0.25 : 0,
                new Surface(0.5 * random.nextInt(2), friction, friction / 2));
    }

    private static List<Item> scene(SplittableRandom random, int count) {
        List<Item> items = new ArrayList<>();
        Geometry world = world();
        while (items.size() < count) {
            Item item = item(random, "item" + items.size(), items.size() < 2);
            if (world.addObject(item.shape())) {
                items.add(item);
            }
        }
        return items;
    }

    private static Geometry world() {
        return new Geometry(10, 5, 10, Dimension.PLANAR, Accuracy.EXACT);
    }

    private static Dynamics dynamics(Geometry world, List<Item> items) {
        Dynamics dynamics = new Dynamics(world, new Surface(0.25, 0.5, 0.25));
        for (Item item : items) {
            assertThat(world.addObject(item.shape())).isTrue();
            if (item.moves()) {
                Body body = Body.of(item.mass(), item.mass() / 8).withSurface(item.surface());
                dynamics.add(item.name(), item.isDriven() ? body : body.withFloorFriction(item.floor()));
                if (item.isDriven()) {
                    dynamics.drive(
                            item.name(),
                            new DifferentialDrive(0.5, 2, 4)
                                    .driving(
                                            item.velocity().x(), item.velocity().ry()));
                } else {
                    dynamics.setVelocity(item.name(), item.velocity());
                }
            }
        }
        return dynamics;
    }

    /** Place, heading and velocity; those of the mirror image are told as they would be if it were not one. */
    private static double[] state(Geometry world, Dynamics dynamics, String name, boolean isInX, boolean isInZ) {
        GeometryObject object = world.getObject(name);
        Twist velocity = dynamics.velocity(name);
        double[] rotation = object.rotation();
        double side = isInX || isInZ ? -1 : 1;
        // No zero is negative.
        return new double[] {
            (isInX ? -1 : 1) * object.center().x() + 0.0,
            (isInZ ? -1 : 1) * object.center().z() + 0.0,
            rotation[0] + 0.0,
            side * rotation[6] + 0.0,
            (isInX ? -1 : 1) * velocity.x() + 0.0,
            (isInZ ? -1 : 1) * velocity.z() + 0.0,
            side * velocity.ry() + 0.0
        };
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsMirroredStaysSo(boolean isInX) {
        int contacts = 0;
        for (int seed = 0; seed < Effort.cases(60); seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            double[] steps = {0.01, 0.0625, 0.25};
            double seconds = steps[random.nextInt(3)];
            List<Item> items = scene(random, random.nextInt(5, 16));
            List<Item> mirrored = new ArrayList<>();
            items.forEach(item -> mirrored.add(item.mirrored(isInX, item.name())));
            Geometry world = world();
            Geometry mirror = world();
            Dynamics here = dynamics(world, items);
            Dynamics there = dynamics(mirror, mirrored);
            for (int step = 0; step < STEPS; step++) {
                contacts += here.step(seconds).contacts().size();
                there.step(seconds);
                for (Item item : items) {
                    if (item.moves()) {
                        assertThat(state(mirror, there, item.name(), isInX, !isInX))
                                .as("seed %d, step %d, %s", seed, step, item.name())
                                .containsExactly(state(world, here, item.name(), false, false));
                    }
                }
            }
        }
        assertThat(contacts).isGreaterThan(Effort.cases(2000));
    }
}
