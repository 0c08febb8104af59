package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** A body belongs to its object, not to the object's name. */
class BodiesAndNamesTest {
    private static final CylinderObject ROBOT = new CylinderObject(new Point(0, 0, 0), 0.3, 0.2).moveable("robot");

    private static Geometry world(Dimension dimension) {
        Geometry world = new Geometry(20, 5, 20, dimension, Accuracy.EXACT);
        world.addObject(ROBOT);
        world.addObject(new CylinderObject(new Point(0, 0, 4), 0.3, 0.2).moveable("other"));
        return world;
    }

    /** Without gravity in a SPATIAL world. */
    private static Dynamics floating(Geometry world) {
        return world.dimension() == Dimension.PLANAR
                ? new Dynamics(world, Surface.SMOOTH)
                : new Dynamics(world, Surface.SMOOTH, new Point());
    }

    private static Dynamics driven(Geometry world) {
        Dynamics dynamics = floating(world);
        dynamics.add("robot", Body.of(1, 1));
        dynamics.add("other", Body.of(1, 1));
        dynamics.setVelocity("robot", new Twist(1, 0, 0, 0));
        dynamics.setVelocity("other", new Twist(1, 0, 0, 0));
        dynamics.step(0.5);
        return dynamics;
    }

    private static void noBody(Dynamics dynamics) {
        assertThat(dynamics.has("robot")).isFalse();
        assertThat(dynamics.names()).containsExactly("other");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.velocity("robot"))
                .withMessage("name must be that of a body (got: \"robot\")");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.drive("robot", new ForceDrive(1, 0, 0)))
                .withMessage("name must be that of a body (got: \"robot\")");
        assertThat(dynamics.remove("robot")).isFalse();
    }

    @ParameterizedTest
    @EnumSource
    void aStaticObjectOfTheNameHasNoBody(Dimension dimension) {
        for (boolean isAsked : new boolean[] {true, false}) {
            Geometry world = world(dimension);
            Dynamics dynamics = driven(world);
            world.removeObject("robot");
            world.addObject(new BoxObject(new Point(3, 0, 4), 1, 1, 1).named("robot"));
            if (isAsked) {
                noBody(dynamics);
            }
            // 0.5 m are behind it; the box is 2.2 m ahead of its centre, less its radius.
            StepResult result = dynamics.step(10);
            assertThat(result.contacts()).extracting(BodyContact::other).contains("robot");
            assertThat(world.getObject("other").center().x()).isBetween(2.19, 2.2);
            noBody(dynamics);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aMoveableObjectOfTheNameInheritsNothing(Dimension dimension) {
        for (boolean isAsked : new boolean[] {true, false}) {
            Geometry world = world(dimension);
            Dynamics dynamics = driven(world);
            dynamics.drive("robot", new VelocityDrive(new Twist(1, 0, 0, 0)));
            world.removeObject("robot");
            world.addObject(ROBOT);
            if (isAsked) {
                noBody(dynamics);
            }
            dynamics.step(1);
            assertThat(world.getObject("robot").center()).isEqualTo(ROBOT.center());
            noBody(dynamics);
            dynamics.add("robot", Body.of(1, 1));
            assertThat(dynamics.velocity("robot")).isEqualTo(new Twist(0, 0, 0, 0));
            dynamics.step(1);
            assertThat(world.getObject("robot").center().x()).isZero();
            assertThat(world.getObject("other").center().x()).isBetween(2.49, 2.51);
        }
    }

    @ParameterizedTest
    @EnumSource
    void nothingIsLeftOfTheLastBody(Dimension dimension) {
        Geometry world = new Geometry(20, 5, 20, dimension, Accuracy.EXACT);
        world.addObject(ROBOT);
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("robot", Body.of(1, 1));
        dynamics.step(0.1);
        world.removeObject("robot");
        world.addObject(new BoxObject(new Point(3, 0, 4), 1, 1, 1).named("robot"));
        assertThat(dynamics.names()).isEmpty();
        assertThat(dynamics.step(1).stopped()).isEmpty();
        assertThat(dynamics.step(1).contacts()).isEmpty();
    }

    /** A body stays with its object while others come and go, also where static objects were shared with a snapshot. */
    @Test
    void otherChangesLeaveBodiesAlone() {
        Geometry first = world(Dimension.PLANAR);
        first.addObject(new BoxObject(new Point(8, 0, -8), 1, 1, 1).named("box"));
        Geometry world = first.snapshot().toGeometry();
        Dynamics dynamics = driven(world);
        world.removeObject("box");
        world.addObject(new BoxObject(new Point(8, 0, 8), 1, 1, 1).named("box"));
        world.simpleMove("robot", 0, 0, -1);
        dynamics.step(0.5);
        assertThat(dynamics.velocity("robot").x()).isEqualTo(1);
        assertThat(world.getObject("robot").center().x()).isEqualTo(1);
    }

    @Test
    void aSurfaceBelongsToItsObjectToo() {
        for (boolean isAnother : new boolean[] {false, true}) {
            Geometry world = new Geometry(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT);
            world.addObject(ROBOT);
            BoxObject wall = new BoxObject(new Point(3, 0, 0), 1, 5, 8).named("wall");
            world.addObject(wall);
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("robot", Body.of(1, 1).withSurface(new Surface(1, 0, 0)));
            dynamics.surface("wall", new Surface(1, 0, 0));
            dynamics.setVelocity("robot", new Twist(1, 0, 0, 0));
            if (isAnother) {
                world.removeObject("wall");
                world.addObject(wall);
            }
            dynamics.step(4);
            assertThat(dynamics.velocity("robot").x()).isEqualTo(isAnother ? 0 : -1);
        }
    }
}
