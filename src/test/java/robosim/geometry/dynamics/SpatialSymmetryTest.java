package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/** What is the same on both sides goes straight on in space, whichever way it looks. */
@Tag("slow")
class SpatialSymmetryTest {
    private static final Surface ROUGH = new Surface(0, 0.4, 0.4);

    /** A differential drive pushes a crate with little more than the friction; nothing steers it back. */
    @ParameterizedTest
    @CsvSource({"0, 1.1", "0, 1.3", "0, 2.5", "30, 1.1", "90, 1.3", "137, 1.6"})
    void whatIsPushedHeadOnGoesStraight(double heading, double force) {
        Geometry world = FallingTest.floor();
        double ahead = StrictMath.cos(StrictMath.toRadians(heading));
        double left = StrictMath.sin(StrictMath.toRadians(heading));
        GeometryObject robot = new BoxObject(new Point(0, 0.15 + 1e-7, 0), 0.6, 0.3, 0.5);
        GeometryObject crate = new BoxObject(new Point(0.6 * ahead, 0.15 + 1e-7, -0.6 * left), 0.5, 0.3, 0.5);
        world.addObject(robot.turned(0, heading).moveable("robot"));
        world.addObject(crate.turned(0, heading).moveable("crate"));
        Dynamics dynamics = new Dynamics(world, ROUGH);
        dynamics.add("robot", Body.ofMass(robot, 20).withSurface(ROUGH).withFloorFriction(2));
        dynamics.add("crate", Body.ofMass(crate, 5).withSurface(ROUGH));
        double acceleration = force * 0.4 * 5 * Body.GRAVITY / 20;
        dynamics.drive("robot", new DifferentialDrive(0.5, 1, acceleration).driving(0.5, 0));
        double seconds = Effort.cases(5, 2);
        dynamics.step(seconds);
        Point at = world.getObject("crate").center();
        // Where a tenth more than the friction pushes, that is all there is to speed both up.
        assertThat(at.x() * ahead - at.z() * left).isGreaterThan(0.6 + 0.036 * seconds * seconds);
        assertThat(at.x() * left + at.z() * ahead).isCloseTo(0, within(1e-3));
        assertThat(world.getObject("robot").heading()).isCloseTo(heading, within(0.02));
    }

    /** Friction is against the way, however a block lies across it. */
    @Test
    void whatSlidesIsRubbedStraightAgainstItsWay() {
        for (double heading = 0; heading < 180; heading += 15) {
            Geometry world = FallingTest.floor();
            GeometryObject block = new BoxObject(new Point(0, 0.01 + 1e-8, 0), 1.2, 0.02, 0.2);
            world.addObject(block.turned(0, heading).moveable("block"));
            Dynamics dynamics = new Dynamics(world, ROUGH);
            dynamics.add("block", Body.ofMass(block, 5).withSurface(ROUGH));
            dynamics.setSpatialVelocity("block", new SpatialVelocity(1.6, 0, 1.2, 0, 0, 0));
            dynamics.step(2);
            Point at = world.getObject("block").center();
            double along = 0.8 * at.x() + 0.6 * at.z();
            double aside = 0.8 * at.z() - 0.6 * at.x();
            assertThat(along).as("heading %s", heading).isCloseTo(4 / (2 * 0.4 * Body.GRAVITY), within(1e-3));
            assertThat(aside).as("heading %s", heading).isCloseTo(0, within(1e-6));
        }
    }
}
