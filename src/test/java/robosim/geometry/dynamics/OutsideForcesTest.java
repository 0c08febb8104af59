package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.model.Twist;

/** Impulses and forces from outside, drag and rolling resistance, beside what is known of them on paper. */
class OutsideForcesTest {
    private static final double G = Body.GRAVITY;

    private static Geometry flat() {
        Geometry world = new Geometry(400, 5, 400, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(), 1, 1, 2).turned(0, 30).moveable("crate"));
        return world;
    }

    private static Dynamics crate(Body body) {
        Dynamics dynamics = new Dynamics(flat());
        dynamics.add("crate", body);
        return dynamics;
    }

    /** A ball far above anything. */
    private static Dynamics ball(Body body) {
        Geometry world = new Geometry(4000, 4000, 4000, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new SphereObject(new Point(), 0.1).moveable("ball"));
        Dynamics dynamics = new Dynamics(world);
        dynamics.add("ball", body);
        return dynamics;
    }

    @Test
    void anImpulseChangesBothMomenta() {
        Dynamics dynamics = crate(Body.of(4, 2));
        dynamics.applyImpulse("crate", new Point(8, 0, 0), new Point(0, 7, 0.5));
        double heading = StrictMath.toRadians(30);
        assertThat(dynamics.velocity("crate").x()).isCloseTo(2 * StrictMath.cos(heading), within(1e-12));
        assertThat(dynamics.velocity("crate").z()).isCloseTo(2 * StrictMath.sin(heading), within(1e-12));
        assertThat(dynamics.velocity("crate").ry()).isCloseTo(StrictMath.toDegrees(0.5 * 8 / 2), within(1e-9));
        dynamics.applyImpulse("crate", new Point(0, 0, -4));
        assertThat(dynamics.velocity("crate").ry()).isCloseTo(StrictMath.toDegrees(2), within(1e-9));
    }

    @Test
    void anImpulseInSpaceTurnsABoxAboutItsOwnAxes() {
        Geometry world = new Geometry(40, 40, 40, Dimension.SPATIAL, Accuracy.EXACT);
        BoxObject box = new BoxObject(new Point(), 1, 2, 3).turned(20, 30).moveable("box");
        world.addObject(box);
        Dynamics dynamics = new Dynamics(world);
        dynamics.add("box", Body.ofMass(box, 6).withInertia(3, 5, 7));
        Point impulse = new Point(1, -2, 4);
        Point at = new Point(0.5, 0.25, -1);
        dynamics.applyImpulse("box", impulse, at);
        SpatialVelocity v = dynamics.spatialVelocity("box");
        assertThat(v.y()).isCloseTo(-2.0 / 6, within(1e-12));
        // The angular momentum about the centre is that of the impulse, whatever the axes.
        double[] r = box.rotation();
        double[] w = {StrictMath.toRadians(v.rx()), StrictMath.toRadians(v.ry()), StrictMath.toRadians(v.rz())};
        double[] moments = {3, 5, 7};
        double[] spin = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double along = r[axis] * w[0] + r[3 + axis] * w[1] + r[6 + axis] * w[2];
            for (int row = 0; row < 3; row++) {
                spin[row] += r[3 * row + axis] * moments[axis] * along;
            }
        }
        assertThat(spin[0]).isCloseTo(at.y() * impulse.z() - at.z() * impulse.y(), within(1e-12));
        assertThat(spin[1]).isCloseTo(at.z() * impulse.x() - at.x() * impulse.z(), within(1e-12));
        assertThat(spin[2]).isCloseTo(at.x() * impulse.y() - at.y() * impulse.x(), within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 1})
    void aForceLastsForTheNextStep(double seconds) {
        Dynamics dynamics = crate(Body.of(4, 2));
        for (double t = 0; t < 1 - 1e-9; t += seconds) {
            dynamics.applyForce("crate", new Point(8, 0, 0));
            dynamics.applyForce("crate", new Point(0, 0, 4), new Point(1, 0, 0));
            dynamics.applyForce("crate", new Point(0, 0, -4), new Point(-1, 0, 0));
            dynamics.advance(seconds);
        }
        // a = 2 m/s^2 for a second; the couple of 8 N m turns it clockwise seen from above, by 4 rad/s^2.
        Point at = centre(dynamics);
        assertThat(at.x()).isCloseTo(1, within(seconds < 1 ? 0.02 : 1e-9));
        assertThat(StrictMath.toRadians(dynamics.velocity("crate").ry())).isLessThan(-3.9);
        double speed = speed(dynamics.velocity("crate"));
        assertThat(speed).isCloseTo(2, within(1e-9));
        dynamics.advance(1);
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(2, within(1e-9));
    }

    private static Point centre(Dynamics dynamics) {
        return dynamics.world().getObject("crate").center();
    }

    private static double speed(Twist v) {
        return StrictMath.sqrt(v.x() * v.x() + v.z() * v.z());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.39, 0.41, 1})
    void theFloorHoldsWhatIsPushedByLessThanItsFriction(double share) {
        Dynamics dynamics = crate(Body.of(10, 2).withFloorFriction(0.4));
        for (int k = 0; k < 20; k++) {
            dynamics.applyForce("crate", new Point(share * 10 * G, 0, 0));
            dynamics.advance(0.1);
        }
        double acceleration = Math.max(0, share - 0.4) * G;
        assertThat(centre(dynamics).x()).isCloseTo(0.5 * acceleration * 4, within(1e-9));
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(2 * acceleration, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aForceAgainstAWallIsItsImpulse(Dimension dimension) {
        Geometry world = new Geometry(40, 40, 40, dimension, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 40, 1, 40).named("floor"));
        if (dimension == Dimension.PLANAR) {
            world.removeObject("floor");
        }
        world.addObject(new BoxObject(new Point(2, 1.001, 0), 1, 2, 8).named("wall"));
        world.addObject(new BoxObject(new Point(0.95, 0.5 + 1e-8, 0), 0.98, 1, 1).moveable("crate"));
        Dynamics dynamics = new Dynamics(world);
        dynamics.add("crate", Body.of(10, 2).withSurface(Surface.SMOOTH));
        for (int k = 0; k < 10; k++) {
            dynamics.advance(0.1);
        }
        double given = 0;
        for (int k = 0; k < 20; k++) {
            dynamics.applyForce("crate", new Point(50, 0, 0));
            for (BodyContact contact : dynamics.step(0.1).contacts()) {
                given += "wall".equals(contact.other()) ? contact.impulse() : 0;
            }
        }
        assertThat(given).isCloseTo(100, within(1e-6)); // 50 N for 2 s, all of which the wall takes
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(0, within(1e-9));
    }

    @Test
    void aForceActsBesideADrive() {
        Dynamics dynamics = crate(Body.of(10, 2));
        dynamics.drive("crate", new OmnidirectionalDrive(9, 2, 90, 90));
        for (int k = 0; k < 10; k++) {
            dynamics.applyForce("crate", new Point(50, 0, 0)); // 5 m/s^2 against at most 2
            dynamics.advance(0.1);
        }
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(3, within(1e-9));
        assertThat(centre(dynamics).x()).isCloseTo(1.5, within(1e-9));
        dynamics.drive("crate", new VelocityDrive(new Twist(0, 0, 0, 0)));
        dynamics.applyForce("crate", new Point(50, 0, 0));
        dynamics.advance(0.1);
        assertThat(speed(dynamics.velocity("crate"))).isZero();
        dynamics.drive("crate", new ForceDrive(-30, 0, 0));
        dynamics.applyForce("crate", new Point(30 * StrictMath.cos(StrictMath.toRadians(30)), 0, -15));
        dynamics.advance(0.5);
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(0, within(1e-9));
    }

    @Test
    void whatLosesItsDriveGoesOnByItself() {
        Dynamics dynamics = crate(Body.of(10, 2).withFloorFriction(0.1));
        dynamics.drive("crate", new VelocityDrive(new Twist(1, 0, 0, 0)));
        dynamics.advance(1);
        assertThat(dynamics.clearDrive("crate")).isTrue();
        assertThat(dynamics.clearDrive("crate")).isFalse();
        dynamics.advance(0.5);
        assertThat(dynamics.velocity("crate").x()).isCloseTo(1 - 0.05 * G, within(1e-9));
    }

    @Test
    void flatWorldsRefusePushesUpward() {
        Dynamics dynamics = crate(Body.of(10, 2));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.applyImpulse("crate", new Point(0, 1, 0)))
                .withMessageContaining("impulse must be level in a PLANAR world; set y to 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> dynamics.applyForce("none", new Point(0, 0, 0), new Point()))
                .withMessageContaining("name must be that of a body");
    }

    // ---- drag ----

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.3, 3})
    void quadraticDragInThePlaneIsExact(double seconds) {
        Dynamics dynamics = crate(Body.of(2, 1).withDamping(0.25, 0).withDrag(0.5, 0));
        dynamics.setVelocity("crate", new Twist(6, 0, 0, 0));
        for (double t = 0; t < 3 - 1e-9; t += seconds) {
            dynamics.advance(seconds);
        }
        // v' = -c v - k v^2 with c = 1/4, k = 1/4: 1/v + k/c grows by exp(c t).
        double grown = StrictMath.exp(0.75);
        double speed = 1 / ((1.0 / 6 + 1) * grown - 1);
        assertThat(speed(dynamics.velocity("crate"))).isCloseTo(speed, within(1e-9));
        double way = StrictMath.log(1 + 0.25 * 6 * (1 - StrictMath.exp(-0.75)) / 0.25) / 0.25;
        Point at = centre(dynamics);
        assertThat(StrictMath.hypot(at.x(), at.z())).isCloseTo(way, within(1e-9));
    }

    @Test
    void aBallThatFallsReachesTheSpeedAtWhichDragCarriesIt() {
        Dynamics dynamics =
                ball(Body.ofMass(new SphereObject(new Point(), 0.1), 0.2).withDrag(0.02, 0));
        dynamics.advance(1.5);
        // v = V tanh(g t / V), and the way V^2 / g log cosh(g t / V), with V = sqrt(m g / drag).
        double terminal = StrictMath.sqrt(0.2 * G / 0.02);
        double at = 1.5 * G / terminal;
        assertThat(dynamics.spatialVelocity("ball").y()).isCloseTo(-terminal * StrictMath.tanh(at), within(2e-6));
        double way = terminal * terminal / G * StrictMath.log(StrictMath.cosh(at));
        assertThat(dynamics.world().getObject("ball").center().y()).isCloseTo(-way, within(2e-6));
        dynamics.advance(20);
        assertThat(dynamics.spatialVelocity("ball").y()).isCloseTo(-terminal, within(1e-5));
    }

    @Test
    void aBallThatIsThrownIsSlowedAlongItsPath() {
        Dynamics dynamics =
                ball(Body.ofMass(new SphereObject(new Point(), 0.1), 0.2).withDrag(0.02, 0));
        dynamics.setSpatialVelocity("ball", new SpatialVelocity(12, 9, -5, 0, 0, 0));
        dynamics.advance(1.5);
        double[] expected = flight(new double[] {12, 9, -5}, 0.1, 1.5); // Runge-Kutta, in steps of 0.1 ms
        Point at = dynamics.world().getObject("ball").center();
        assertThat(at.x()).isCloseTo(expected[0], within(5e-6));
        assertThat(at.y()).isCloseTo(expected[1], within(5e-6));
        assertThat(at.z()).isCloseTo(expected[2], within(5e-6));
    }

    private static double[] flight(double[] v, double k, double seconds) {
        double[] s = {0, 0, 0, v[0], v[1], v[2]};
        int steps = 15_000;
        double h = seconds / steps;
        for (int n = 0; n < steps; n++) {
            double[] a = slope(s, k);
            double[] b = slope(plus(s, a, h / 2), k);
            double[] c = slope(plus(s, b, h / 2), k);
            double[] d = slope(plus(s, c, h), k);
            for (int i = 0; i < 6; i++) {
                s[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
            }
        }
        return s;
    }

    private static double[] slope(double[] s, double k) {
        double speed = StrictMath.sqrt(s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
        return new double[] {s[3], s[4], s[5], -k * speed * s[3], -G - k * speed * s[4], -k * speed * s[5]};
    }

    private static double[] plus(double[] s, double[] slope, double by) {
        double[] sum = s.clone();
        for (int i = 0; i < 6; i++) {
            sum[i] += by * slope[i];
        }
        return sum;
    }

    @Test
    void linearDragSlowsWhatFallsToItsTerminalSpeed() {
        Dynamics dynamics =
                ball(Body.ofMass(new SphereObject(new Point(), 0.1), 0.2).withDamping(2, 0));
        dynamics.advance(1);
        assertThat(dynamics.spatialVelocity("ball").y())
                .isCloseTo(-G / 2 * (1 - StrictMath.exp(-2)), within(0.01)); // of the first order: 0.1 % of 4.2 m/s
    }

    @Test
    void aForceInSpaceIsExact() {
        Dynamics dynamics = ball(Body.ofMass(new SphereObject(new Point(), 0.1), 0.2));
        dynamics.applyForce("ball", new Point(0.4, 0.2 * G, 0), new Point(0, 0, 0.1));
        dynamics.advance(2);
        Point at = dynamics.world().getObject("ball").center();
        assertThat(at.x()).isCloseTo(4, within(1e-9));
        assertThat(at.y()).isCloseTo(0, within(1e-9));
        // The torque r x F is (-0.1 m g, 0.04, 0), on a ball of 2/5 m r^2.
        double inertia = 0.4 * 0.2 * 0.01;
        SpatialVelocity v = dynamics.spatialVelocity("ball");
        assertThat(StrictMath.toRadians(v.ry())).isCloseTo(0.04 / inertia * 2, within(1e-6));
        assertThat(StrictMath.toRadians(v.rx())).isCloseTo(-0.02 * G / inertia * 2, within(1e-5));
        dynamics.advance(1);
        assertThat(dynamics.spatialVelocity("ball").x()).isCloseTo(4, within(1e-9));
        assertThat(dynamics.spatialVelocity("ball").y()).isCloseTo(-G, within(1e-9));
    }

    // ---- rolling ----

    private static Dynamics rolling(double coefficient) {
        Geometry world = new Geometry(100, 10, 100, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -0.5, 0), 90, 1, 90).named("floor"));
        world.addObject(new SphereObject(new Point(0, 0.25 + 1e-8, 0), 0.25).moveable("ball"));
        Surface surface = new Surface(0, 0.6, 0.6);
        Dynamics dynamics = new Dynamics(world, surface);
        dynamics.add(
                "ball",
                Body.ofMass(world.getObject("ball"), 0.3).withSurface(surface).withDrag(0, coefficient));
        dynamics.step(0.1);
        return dynamics;
    }

    @Test
    void aBallThatRollsSlowsEvenlyAndRests() {
        Dynamics dynamics = rolling(0.05);
        dynamics.setSpatialVelocity("ball", new SpatialVelocity(2, 0, 0, 0, 0, -StrictMath.toDegrees(2 / 0.25)));
        double slowing = 0.05 * G / 1.4; // I + m r^2 = 7/5 m r^2
        dynamics.advance(1);
        assertThat(dynamics.spatialVelocity("ball").x()).isCloseTo(2 - slowing, within(1e-4));
        dynamics.advance(9);
        assertThat(dynamics.world().getObject("ball").center().x()).isCloseTo(2 * 2 / (2 * slowing), within(0.01));
        assertThat(dynamics.spatialVelocity("ball")).isEqualTo(SpatialVelocity.REST);
    }

    @Test
    void aBallRestsWhereASlopePullsByLess() {
        for (double coefficient : new double[] {0.04, 0.06}) {
            Dynamics dynamics = rolling(coefficient);
            for (int k = 0; k < 20; k++) {
                // As a slope of 5 %: m g / 20 through the centre.
                dynamics.applyForce("ball", new Point(0.3 * G / 20, 0, 0));
                dynamics.advance(0.1);
            }
            double speed = dynamics.spatialVelocity("ball").x();
            if (coefficient > 0.05) {
                assertThat(speed).isCloseTo(0, within(1e-6));
            } else {
                assertThat(speed).isCloseTo(0.01 * G / 1.4 * 2, within(1e-3));
            }
        }
    }

    @Test
    void inThePlaneRollingIsLikeALittleFriction() {
        Dynamics dynamics = crate(Body.of(10, 2).withDrag(0, 0.02));
        dynamics.setVelocity("crate", new Twist(1, 0, 0, 0));
        dynamics.advance(1);
        assertThat(dynamics.velocity("crate").x()).isCloseTo(1 - 0.02 * G, within(1e-9));
    }
}
