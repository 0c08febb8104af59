package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.collision.Contact;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** Bumpers and proximity sensors. */
class TouchTest {
    private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

    @ParameterizedTest
    @EnumSource
    void touchingAreThoseThatIntersect(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(3);
        int pressed = 0;
        int worlds = 60;
        for (int w = 0; w < worlds; w++) {
            Geometry world = new Geometry(40, 20, 40, Dimension.SPATIAL, accuracy);
            GeometryObject robot = new BoxObject(new Point(0, 0, 0), 2, 1, 1)
                    .turned(10, random.nextDouble(360))
                    .moveable("robot");
            List<GeometryObject> truth = new ArrayList<>();
            for (int k = 0; k < 20; k++) {
                Point place = new Point(random.nextDouble(-8, 8), random.nextDouble(-2, 2), random.nextDouble(-8, 8));
                GeometryObject other = k % 2 == 0
                        ? new SphereObject(place, random.nextDouble(1.2))
                        : new BoxObject(place, 1, 2, 1)
                                .turned(0, random.nextDouble(90))
                                .named("box " + k);
                world.addObjectUnchecked(other);
                if (CollisionDetection.intersects(robot, other)) {
                    truth.add(other);
                }
            }
            world.addObjectUnchecked(robot);
            Bumper bumper = Bumper.on("robot");
            assertThat(bumper.touching(world)).isEqualTo(truth);
            assertThat(bumper.isPressed(world)).isEqualTo(!truth.isEmpty());
            assertThat(bumper.contacts(world)).hasSize(truth.size()); // convex pieces all
            pressed += truth.isEmpty() ? 0 : 1;
        }
        assertThat(pressed).isBetween(worlds / 10, worlds * 9 / 10);
    }

    @Test
    void theFloorIsNotOnTheBumper() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObjectUnchecked(new BoxObject(new Point(0, -1, 0), 10, 1, 10).named("floor"));
        world.addObjectUnchecked(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
        assertThat(Bumper.on("robot").touching(world)).hasSize(1);
        // A strip that sticks out touches what the robot does not.
        world.addObjectUnchecked(new BoxObject(new Point(-1.2, 0, 0), 1, 4, 1).named("behind"));
        assertThat(Bumper.on("robot").touching(world)).hasSize(1);
        Bumper wide = Bumper.on("robot").shaped(new CylinderObject(new Point(0, 0, 0), 0.75, 0.2));
        assertThat(wide.touching(world).get(0).name()).isEqualTo("behind");
        world.removeObject("behind");
        Bumper band = Bumper.on("robot").shaped(new CylinderObject(new Point(0, 0, 0), 0.5, 0.6));
        assertThat(band.isPressed(world)).isFalse();
        world.addObjectUnchecked(new BoxObject(new Point(0, 0, -1), 1, 0.2, 1).named("shelf")); // on the left
        assertThat(band.touching(world)).hasSize(1);
        assertThat(band.touching(world).get(0).name()).isEqualTo("shelf");
        Contact contact = band.contacts(world).get(0);
        assertThat(band.bearing(world, contact)).isCloseTo(90, Offset.offset(1e-6));
        world.simpleTurn("robot", 30);
        assertThat(band.bearing(world, band.contacts(world).get(0))).isCloseTo(60, Offset.offset(1e-6));
    }

    @Test
    void theSideOnWhichAMoveWasStopped() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 1, 10).named("wall"));
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
        Bumper bumper = Bumper.on("robot");
        MoveResult ahead = world.move("robot", new Move(9, 0, 0, 0, 0));
        assertThat(bumper.bearing(world, ahead)).isCloseTo(0, ROUNDING);
        world.simpleTurn("robot", 50);
        MoveResult slanted = world.moveGlobal("robot", new Move(9, 0, 0, 0, 0));
        assertThat(bumper.bearing(world, slanted)).isCloseTo(-50, ROUNDING); // the wall is to the right of its nose
        assertThat(bumper.bearing(world, world.move("robot", new Move(0.1, 0, 0, 0, 0))))
                .isNaN();
        MoveResult down = world.move("robot", new Move(0, -30, 0, 0, 0));
        assertThat(down.allowed()).isFalse();
        assertThat(bumper.bearing(world, down)).isNaN();
    }

    @Test
    void proximity() {
        Geometry world = new Geometry(20, 20, 20);
        world.addObject(new BoxObject(new Point(3, 0, 0), 1, 1, 1));
        world.addObject(new CylinderObject(new Point(0, 0, 0), 0.5, 1).moveable("robot"));
        ProximitySensor sensor = ProximitySensor.on("robot", 5);
        assertThat(sensor.read(world)).isEqualTo(world.getProximity("robot", 5)).isEqualTo(2);
        assertThat(ProximitySensor.on("robot", 1.9).read(world)).isEqualTo(Double.POSITIVE_INFINITY);
        ProximitySensor noisy = sensor.withNoise(Noise.gaussian(0.1), 4, 9);
        assertThat(noisy.read(world, 1)).isEqualTo(noisy.read(world, 1)).isNotEqualTo(noisy.read(world, 2));
        double sum = 0;
        int count = 10_000;
        for (int k = 0; k < count; k++) {
            sum += noisy.read(world, k);
        }
        assertThat(sum / count).isCloseTo(2, Offset.offset(5 * 0.1 / 100));
        assertThat(sensor.withNoise(Noise.gaussian(-9, 0), 1, 1).read(world, 0)).isZero();
    }

    @Test
    void valuesAndRefusals() {
        Geometry world = new Geometry();
        SphereObject ball = new SphereObject(new Point(), 1);
        assertThat(Bumper.on("a").shaped(ball))
                .isEqualTo(Bumper.on("a").shaped(new SphereObject(new Point(), 1)))
                .isNotEqualTo(Bumper.on("a"));
        assertThat(ProximitySensor.on("a", 2))
                .isEqualTo(ProximitySensor.on("a", 2))
                .isNotEqualTo(ProximitySensor.on("a", 3));
        refused("name must have a visible character", () -> Bumper.on(" "));
        refused("ownShape must be given (got: null)", () -> Bumper.on("a").shaped(null));
        refused("name must be", () -> Bumper.on("a").isPressed(world));
        refused("max must be at least min", () -> ProximitySensor.on("a", -1));
        refused(
                "a sensor with noise must be told the number of its frame",
                () -> ProximitySensor.on("a", 1)
                        .withNoise(Noise.gaussian(1), 1, 1)
                        .read(world));
        refused(
                "must not need the normals of rays",
                () -> ProximitySensor.on("a", 1).withNoise(Noise.grazing(1, 80), 1, 1));
    }

    private static void refused(String message, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
