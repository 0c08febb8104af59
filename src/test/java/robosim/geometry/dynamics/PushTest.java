package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** What a robot that drives pushes along: it goes on, and every step has an end. */
class PushTest {
    private static final double STEP = 0.05;
    private static final Surface SURFACE = new Surface(0, 0.45, 0.35);

    private final Geometry world = new Geometry(60, 3, 60, Dimension.PLANAR, Accuracy.EXACT);

    private Dynamics scene(double aside, double friction, double heading) {
        Dynamics dynamics = new Dynamics(world, SURFACE);
        GeometryObject cart = new CylinderObject(new Point(-4, 0, 0), 0.3, 0.5).moveable("cart");
        GeometryObject crate = new BoxObject(new Point(-1, 0, aside), 0.5, 0.5, 0.5)
                .turned(0, heading)
                .moveable("crate");
        world.addObject(cart);
        world.addObject(crate);
        dynamics.add("cart", Body.ofMass(cart, 20).withSurface(SURFACE));
        dynamics.add("crate", Body.ofMass(crate, 8).withSurface(SURFACE).withFloorFriction(friction));
        return dynamics;
    }

    private void assertApart() {
        for (String name : new String[] {"cart", "crate"}) {
            assertThat(world.getProximity(name, 1)).as(name).isPositive();
        }
    }

    /** A crate that is met off its middle turns about the cart, whose round side rolls along the turning edge. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0.1, 0, 0", "0.1, 0.4, 0", "-0.2, 0.4, 0", "0.05, 0.4, 10", "0.3, 0.4, 45", "0.4, 0, 30"})
    void aCartPushesACrate(double aside, double friction, double heading) {
        Dynamics dynamics = scene(aside, friction, heading);
        dynamics.drive("cart", new DifferentialDrive(0.45, 1.2, 2).driving(0.8, 0));
        Assertions.assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            for (int step = 0; step < 240; step++) {
                Point before = world.getObject("cart").center();
                StepResult result = dynamics.step(STEP);
                assertThat(result.stopped()).as("step %d", step).isEmpty();
                assertApart();
                if (step > 75) {
                    Point after = world.getObject("cart").center();
                    double way = Math.hypot(after.x() - before.x(), after.z() - before.z());
                    // A third for a cart whose rims have to hold it straight as well.
                    assertThat(way / STEP).as("step %d", step).isBetween(0.7 * (0.8 - lost(friction)), 0.8 + 1e-6);
                }
            }
        });
    }

    /** What the floor takes from the crate in a step, at the speed at which the cart makes up for it in each. */
    private static double lost(double friction) {
        return friction * Body.GRAVITY * STEP * 8 / 20;
    }

    /** Straight ahead: the cart has its full speed again each step, less what it gives to the crate, which the floor slows. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.2, 0.4})
    void aCartPushesStraightAheadAtFullSpeedLessFriction(double friction) {
        Dynamics dynamics = scene(0, friction, 0);
        dynamics.drive("cart", new DifferentialDrive(0.45, 1.2, 2).driving(0.8, 0));
        for (int step = 0; step < 240; step++) {
            dynamics.step(STEP);
        }
        double apart = world.getObject("crate").center().x()
                - world.getObject("cart").center().x();
        assertThat(apart).isCloseTo(0.55, within(1e-9));
        assertThat(dynamics.velocity("cart").x()).isCloseTo(0.8 - lost(friction), within(1e-9));
    }
}
