package robosim.geometry.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Bumpers that are fed from the contacts of steps. */
class BumperStepTest {
    private static final DifferentialDrive DRIVE = new DifferentialDrive(0.5, 1, 5);

    @Test
    void bothRobotsKnowThatTheyBumped() {
        Geometry world = new Geometry(20, 4, 20, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(-2, 0, 0), 0.5, 1).moveable("a"));
        world.addObject(
                new CylinderObject(new Point(2, 0, 0.25), 0.5, 1).turned(0, 180).moveable("b"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("a", Body.of(2, 1));
        dynamics.add("b", Body.of(2, 1));
        dynamics.setVelocity("a", new Twist(1, 0, 0, 0));
        Bumper a = Bumper.on("a");
        Bumper b = Bumper.on("b");
        assertThat(a.isPressed(world, dynamics.step(1))).isFalse();
        StepResult step = dynamics.step(3);
        assertThat(a.isPressed(world, step)).isTrue();
        assertThat(b.isPressed(world, step)).isTrue();
        BodyContact ofA = a.contacts(world, step).get(0);
        BodyContact ofB = b.contacts(world, step).get(0);
        assertThat(ofA.body()).isEqualTo("a");
        assertThat(ofA.other()).isEqualTo("b");
        assertThat(ofB.body()).isEqualTo("b");
        assertThat(ofB.other()).isEqualTo("a");
        // A quarter of the sum of the radii to the side: a sees it on the right, and b, which looks back, on its right
        // too.
        double aside = StrictMath.toDegrees(StrictMath.asin(0.25));
        assertThat(a.bearing(world, ofA)).isCloseTo(-aside, within(1e-6));
        assertThat(b.bearing(world, ofB)).isCloseTo(-aside, within(1e-6));
        assertThat(a.bearing(world, ofB)).isCloseTo(-aside, within(1e-6));
        // They part, and what has ended presses nothing.
        StepResult after = dynamics.step(3);
        assertThat(after.ended()).isNotEmpty();
        assertThat(a.isPressed(world, after)).isFalse();
        BodyContact strange = new BodyContact("c", null, new Point(), new Point(1, 0, 0), 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> a.bearing(world, strange))
                .withMessage("contact must be one of \"a\" (got: \"c\" and \"null\")");
    }

    @Test
    void aStripAroundARobotFeelsTheWallAndNotTheFloor() {
        Geometry world = new Geometry(20, 6, 20, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 18, 1, 18).named("floor"));
        world.addObject(new BoxObject(new Point(2, 0.5 + 1e-6, 0), 1, 1, 4).named("wall"));
        world.addObject(new CylinderObject(new Point(0, 0.25 + 1e-8, 0), 0.3, 0.5).moveable("cart"));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 0.8, 0.8));
        dynamics.add("cart", Body.of(10, 0.5).withFloorFriction(0.8));
        dynamics.drive("cart", DRIVE.driving(0.5, 0));
        Bumper everywhere = Bumper.on("cart");
        Bumper strip = everywhere.shaped(new CylinderObject(new Point(0, 0.05, 0), 0.31, 0.3));
        StepResult rolls = dynamics.step(1);
        assertThat(everywhere.contacts(world, rolls))
                .extracting(BodyContact::other)
                .containsExactly("floor");
        assertThat(everywhere.bearing(world, everywhere.contacts(world, rolls).get(0)))
                .isNaN();
        assertThat(strip.isPressed(world, rolls)).isFalse();
        dynamics.step(3);
        StepResult presses = dynamics.step(0.05);
        assertThat(strip.contacts(world, presses))
                .extracting(BodyContact::other)
                .containsExactly("wall");
        assertThat(strip.bearing(world, strip.contacts(world, presses).get(0))).isCloseTo(0, within(1e-3));
        dynamics.drive("cart", DRIVE.driving(-0.5, 0));
        dynamics.step(1);
        assertThat(strip.isPressed(world, dynamics.step(0.05))).isFalse();
    }

    /** A floor and a wall of one object, or the border of the world, which is both. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void eachFaceHasItsSide(boolean isBorder) {
        Geometry world = new Geometry(5.5, 4, 40, Dimension.SPATIAL, Accuracy.EXACT);
        double ground = isBorder ? -2 : -1;
        if (!isBorder) {
            world.addObject(new ObjectGroup(List.of(
                            new BoxObject(new Point(0, -1.5, 0), 5, 1, 10),
                            new BoxObject(new Point(2, 0, 0), 0.5, 2, 10)))
                    .named("room"));
        }
        double wall = isBorder ? 2.75 : 1.75;
        world.addObject(new BoxObject(new Point(0, ground + 0.5 + 1e-8, 0), 1, 1, 1).moveable("crate"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("crate", Body.ofMass(world.getObject("crate"), 50));
        dynamics.step(0.2);
        dynamics.setVelocity("crate", new Twist(100, 0, 0, 0));
        StepResult step = dynamics.step(0.05);
        assertThat(step.contacts()).hasSize(2);
        BodyContact floor = step.contacts().get(0);
        // It has stood on the floor before, and been carried by it in this step too.
        assertThat(floor.phase()).isEqualTo(BodyContact.Phase.LAST);
        assertThat(floor.normal()).isEqualTo(new Point(0, 1, 0));
        // To within what the floor gives in a slice.
        assertThat(floor.impulse()).isCloseTo(50 * Body.GRAVITY * 0.05, within(50 * Body.GRAVITY * 1e-3));
        BodyContact contact = step.contacts().get(1);
        assertThat(contact.phase()).isEqualTo(BodyContact.Phase.BEGIN);
        assertThat(contact.impulse()).isCloseTo(5000, within(1e-3));
        assertThat(contact.normal()).isEqualTo(new Point(-1, 0, 0));
        assertThat(contact.point().x()).isCloseTo(wall, within(1e-7));
        assertThat(Math.abs(contact.point().y() - ground - 0.5)).isLessThan(0.5 + 1e-6);
        assertThat(Math.abs(contact.point().z())).isLessThan(0.5 + 1e-6);
        Bumper everywhere = Bumper.on("crate");
        Bumper front = everywhere.shaped(new BoxObject(new Point(0.5, 0.02, 0), 0.1, 1.02, 1.02));
        assertThat(everywhere.bearing(world, contact)).isCloseTo(0, within(1e-3));
        assertThat(everywhere.bearing(world, floor)).isNaN();
        assertThat(everywhere.isPressed(world, step)).isTrue();
        Bumper back = everywhere.shaped(new BoxObject(new Point(-0.5, 0.02, 0), 0.1, 0.9, 0.9));
        assertThat(front.isPressed(world, step)).isTrue();
        assertThat(back.isPressed(world, step)).isFalse();
    }
}
