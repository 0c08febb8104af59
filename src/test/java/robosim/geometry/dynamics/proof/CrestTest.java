package robosim.geometry.dynamics.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Geometry;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.SpatialVelocity;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Ordinary ground: over roofs, sills and edges of stages nobody is stopped, and only impulses take energy. */
@Tag("slow")
class CrestTest {
    private static final double MASS = 50;
    private static final double SECONDS = 1e-3;

    private final Geometry world = new Geometry(20, 6, 8, Dimension.SPATIAL, Accuracy.EXACT);

    private void roof(double degrees, boolean isMesh) {
        double h = 0.165;
        double run = h / Math.tan(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        if (isMesh) {
            List<Point> corners = List.of(
                    new Point(0, -2, -1),
                    new Point(run, h - 2, -1),
                    new Point(2 * run, -2, -1),
                    new Point(0, -2, 1),
                    new Point(run, h - 2, 1),
                    new Point(2 * run, -2, 1));
            int[][] faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {0, 2, 5, 3}};
            assertThat(world.addObjectUnchecked(
                            new MeshObject(corners, faces).solid().named("roof")))
                    .isTrue();
            return;
        }
        for (int side = -1; side <= 1; side += 2) {
            Point at = new Point((side < 0 ? 0.5 : 1.5) * run - side * s * 0.15, h / 2 - 2 - c * 0.15, 0);
            double[] rotation = {c, side * s, 0, -side * s, c, 0, 0, 0, 1};
            assertThat(world.addObjectUnchecked(new BoxObject(at, run / c, 0.3, 2)
                            .oriented(rotation)
                            .named("roof" + side)))
                    .isTrue();
        }
    }

    private static double energy(GeometryObject at, SpatialVelocity v) {
        double turn = Math.toRadians(v.rz());
        return 0.5 * MASS * v.speed() * v.speed()
                + MASS * Body.GRAVITY * (at.center().y() + 1.75)
                + 0.5 * MASS * (0.81 + 0.25) / 12 * turn * turn;
    }

    /** Without friction a contact takes at most its impulse times the speed with which it is met. */
    @ParameterizedTest
    @CsvSource({"11, 2.5, true", "15, 2.5, false", "18, 3, true", "22, 3.5, false"})
    void aBoxCoastsOverARoof(double degrees, double speed, boolean isMesh) {
        world.addObject(new BoxObject(new Point(0, -2.25, 0), 19, 0.5, 6).named("floor"));
        roof(degrees, isMesh);
        world.addObject(new BoxObject(new Point(-1, -1.75 + 1.5e-8, 0), 0.9, 0.5, 0.9).moveable("robot"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("robot", Body.ofMass(world.getObject("robot"), MASS));
        dynamics.setVelocity("robot", new Twist(speed, 0, 0, 0));
        double last = energy(world.getObject("robot"), dynamics.spatialVelocity("robot"));
        double highest = -2;
        for (int step = 0; step < 1200; step++) {
            SpatialVelocity before = dynamics.spatialVelocity("robot");
            StepResult result = dynamics.step(SECONDS);
            assertThat(result.stopped()).as("step %d", step).isEmpty();
            double impulse = 0;
            for (BodyContact contact : result.contacts()) {
                impulse += contact.impulse();
            }
            double now = energy(world.getObject("robot"), dynamics.spatialVelocity("robot"));
            double fastest = before.speed() + 0.7 * Math.toRadians(Math.abs(before.rz())) + Body.GRAVITY * SECONDS;
            assertThat(last - now)
                    .as("energy lost in step %d, impulse %s", step, impulse)
                    .isLessThan(impulse * fastest + 1e-3);
            highest = Math.max(highest, world.getObject("robot").center().y());
            last = now;
        }
        assertThat(highest).isGreaterThan(-1.72); // it has been on the roof
    }

    /**
     * A kerb stops what is met with a vertical face: without a bounce, the angular momentum about its edge stays, and the
     * energy of that alone. It takes five sixths of it, and the box falls back, as it is too slow to tip over.
     */
    @ParameterizedTest
    @CsvSource({"0.0065", "0.05", "0.12"})
    void aKerbTakesWhatIsNotATurnAboutItsEdge(double high) {
        world.addObject(new BoxObject(new Point(0, -2.25, 0), 19, 0.5, 6).named("floor"));
        world.addObjectUnchecked(new BoxObject(new Point(1, -2 + high / 2, 0), 1, high, 6).named("kerb"));
        world.addObject(new BoxObject(new Point(-0.2, -1.75 + 1.5e-8, 0), 0.9, 0.5, 0.9).moveable("robot"));
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("robot", Body.ofMass(world.getObject("robot"), MASS));
        dynamics.setVelocity("robot", new Twist(2.5, 0, 0, 0));
        while (Math.abs(dynamics.spatialVelocity("robot").rz()) < 1) {
            assertThat(dynamics.step(SECONDS).stopped()).isEmpty();
        }
        double above = 0.25 - high;
        double inertia = MASS * ((0.81 + 0.25) / 12 + 0.45 * 0.45 + above * above);
        double momentum = MASS * 2.5 * above;
        double turn = -Math.toRadians(dynamics.spatialVelocity("robot").rz());
        // Gravity acts for at most one step.
        assertThat(turn).isCloseTo(momentum / inertia, within(MASS * Body.GRAVITY * 0.45 * SECONDS / inertia));
    }

    /** What static friction cannot hold slides at once, by sliding friction; what it can hold stays. */
    @ParameterizedTest
    @CsvSource({"1, 2", "0.1, 2", "5, 1", "-0.1, 2", "-1, 1"})
    void aBlockOnASlopeSlidesBySlidingFriction(double above, double seconds) {
        double angle = Math.atan(0.5) + Math.toRadians(above);
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double[] rotation = {c, -s, 0, s, c, 0, 0, 0, 1};
        Geometry hall = new Geometry(400, 400, 400, Dimension.SPATIAL, Accuracy.EXACT);
        hall.addObject(new BoxObject(new Point(0, 0, 0), 100, 2, 20).oriented(rotation));
        double up = 1.1 + 1e-8;
        BoxObject block = new BoxObject(new Point(-s * up, c * up, 0), 1, 0.2, 1);
        hall.addObject(block.oriented(rotation).moveable("block"));
        Surface surface = new Surface(0, 0.5, 0.4);
        Dynamics dynamics = new Dynamics(hall, surface);
        dynamics.add("block", Body.ofMass(block, 2).withSurface(surface));
        dynamics.step(seconds);
        Point at = hall.getObject("block").center();
        double acceleration = above < 0 ? 0 : Body.GRAVITY * (s - 0.4 * c);
        assertThat(Math.hypot(at.x() + s * up, at.y() - c * up))
                .isCloseTo(0.5 * acceleration * seconds * seconds, within(above < 0 ? 1e-6 : 2e-8));
        assertThat(dynamics.spatialVelocity("block").speed()).isCloseTo(acceleration * seconds, within(2e-8));
    }

    /** Up a ramp of boxes, over a sill and off the end of a stage. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.6", "1, 0.9"})
    void aCartDrivesOverRampSillAndStage(double speed, double friction) {
        world.addObject(new BoxObject(new Point(0, -2.25, 0), 19, 0.5, 6).named("floor"));
        roof(8, true);
        world.addObject(new BoxObject(new Point(3.5, -1.99995, 0), 0.1, 0.0001, 6).named("sill"));
        world.addObject(new BoxObject(new Point(-5, -1.75, 0), 3, 0.4999, 4).named("stage"));
        Surface surface = new Surface(0, friction, 0.9 * friction);
        Dynamics dynamics = new Dynamics(world, surface);
        world.addObject(new BoxObject(new Point(-1.5, -1.9 + 1.5e-8, 0), 0.5, 0.2, 0.4).moveable("cart"));
        world.addObject(new BoxObject(new Point(-5, -1.4 + 1e-4, 0), 0.5, 0.2, 0.4).moveable("other"));
        for (String name : List.of("cart", "other")) {
            dynamics.add(name, Body.ofMass(world.getObject(name), 20).withSurface(surface));
            dynamics.drive(name, new DifferentialDrive(0.4, 1, 2).driving(speed, 0));
        }
        for (double time = 0; time < 4; time += 0.02) {
            assertThat(dynamics.step(0.02).stopped()).as("at %s s", time).isEmpty();
        }
        assertThat(world.getObject("cart").center().x()).isGreaterThan(-1.5 + 0.5 * 4 * speed * 0.8);
    }
}
