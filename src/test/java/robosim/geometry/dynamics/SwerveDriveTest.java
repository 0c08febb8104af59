package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** Wheels at given places: directions, motors, and the circle of friction, beside what is known of them on paper. */
class SwerveDriveTest {
    private static final double G = Body.GRAVITY;
    private static final Twist STILL = new Twist(0, 0, 0, 0);
    private static final Body BODY = Body.of(50, 5);

    /** A Kraken X60 with a limit of its current. */
    private static Motor motor(double limit, double supply) {
        return new Motor(7.09, 6000, 366, 6.75, 0.05, limit, supply);
    }

    private static Dynamics robot(Dimension dimension, Body body, Drive drive) {
        Geometry world = new Geometry(200, 40, 200, dimension, Accuracy.EXACT);
        if (dimension == Dimension.SPATIAL) {
            world.addObject(new BoxObject(new Point(0, -0.5, 0), 190, 1, 190).named("floor"));
        }
        world.addObject(new BoxObject(new Point(30, 0.5 + 1e-8, 0), 1, 0.98, 90).named("wall"));
        world.addObject(new BoxObject(new Point(0, 0.25 + 1e-8, 0), 0.7, 0.5, 0.7).moveable("robot"));
        Dynamics dynamics = new Dynamics(world, new Surface(0, 1.5, 1.5));
        dynamics.add("robot", body.withFloorFriction(dimension == Dimension.SPATIAL ? 1.5 : 0));
        dynamics.drive("robot", drive);
        return dynamics;
    }

    @Test
    void aMotorGivesWhatItsCurveAndItsLimitsAllow() {
        Motor free = motor(Double.POSITIVE_INFINITY, 0);
        assertThat(free.freeSpeed()).isCloseTo(6000 / 60.0 * 2 * Math.PI / 6.75 * 0.05, within(1e-12));
        double stall = 7.09 * 6.75 / 0.05;
        assertThat(free.force(0)).isCloseTo(stall, within(1e-9));
        assertThat(free.force(free.freeSpeed() / 4)).isCloseTo(0.75 * stall, within(1e-9));
        assertThat(free.force(free.freeSpeed())).isCloseTo(0, within(1e-9));
        assertThat(free.force(-free.freeSpeed())).isCloseTo(2 * stall, within(1e-9)); // it brakes against its back-EMF
        assertThat(motor(61, 0).force(0)).isCloseTo(stall / 6, within(1e-9));
        // 12 V over 366 A are 32.8 milliohms; as much again in the supply halves the current.
        assertThat(motor(1000, 12.0 / 366).force(0)).isCloseTo(stall / 2, within(1e-9));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> motor(-1, 0))
                .withMessageContaining("currentLimit must be at least 0");
    }

    @Test
    void commandsOfTheWholeRobotAreThoseOfItsModules() {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 200; k++) {
            SwerveDrive drive = SwerveDrive.of(0.6, 0.5, null, 1e6);
            Twist to = new Twist(random.nextDouble(-3, 3), 0, random.nextDouble(-3, 3), random.nextDouble(-300, 300));
            SwerveDrive told = drive.driving(to.x(), to.z(), to.ry());
            double w = StrictMath.toRadians(to.ry());
            for (SwerveDrive.Module module : told.modules()) {
                double angle = StrictMath.toRadians(module.angle());
                assertThat(Math.abs(module.angle())).isLessThanOrEqualTo(90 + 1e-9);
                assertThat(module.speed() * StrictMath.cos(angle)).isCloseTo(to.x() + w * module.z(), within(1e-9));
                assertThat(module.speed() * -StrictMath.sin(angle)).isCloseTo(to.z() - w * module.x(), within(1e-9));
            }
            Twist has = told.next(STILL, BODY, 1);
            assertThat(has.x()).isCloseTo(to.x(), within(1e-8));
            assertThat(has.z()).isCloseTo(to.z(), within(1e-8));
            assertThat(has.ry()).isCloseTo(to.ry(), within(1e-6));
            assertThat(told.wheelVelocity(has, BODY).ry()).isCloseTo(to.ry(), within(1e-6));
        }
    }

    @Test
    void aWheelThatWouldBeTooFastSlowsAll() {
        Motor motor = motor(80, 0);
        SwerveDrive told = SwerveDrive.of(0.6, 0.6, motor, 1).driving(10, 0, 90);
        double fastest = told.modules().stream()
                .mapToDouble(each -> Math.abs(each.speed()))
                .max()
                .orElseThrow();
        assertThat(fastest).isCloseTo(motor.freeSpeed(), within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aRobotSlidesWithItsFriction(Dimension dimension) {
        SwerveDrive stop = SwerveDrive.of(0.6, 0.6, null, 0.8);
        Dynamics dynamics = robot(dimension, BODY, stop);
        dynamics.setVelocity("robot", new Twist(5, 0, 0, 0));
        dynamics.advance(0.25);
        assertThat(dynamics.velocity("robot").x()).isCloseTo(5 - 0.25 * 0.8 * G, within(1e-6));
        dynamics.advance(2);
        assertThat(dynamics.world().getObject("robot").center().x()).isCloseTo(25 / (1.6 * G), within(0.02));
        assertThat(dynamics.velocity("robot").x()).isCloseTo(0, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.02, 0.25})
    void motorsSpeedUpARobotExponentially(double seconds) {
        Motor motor = motor(Double.POSITIVE_INFINITY, 0);
        Dynamics dynamics = robot(
                Dimension.PLANAR, BODY, SwerveDrive.of(0.6, 0.6, motor, 100).driving(99, 0, 0));
        for (int k = 0; k < 0.25 / seconds - 1e-9; k++) {
            dynamics.advance(seconds);
        }
        // m v' = 4 F (1 - v / v0): v0 (1 - exp(-4 F t / (m v0))).
        double rate = 4 * motor.force(0) / 50 / motor.freeSpeed();
        assertThat(dynamics.velocity("robot").x())
                .isCloseTo(motor.freeSpeed() * (1 - StrictMath.exp(-0.25 * rate)), within(0.02));
    }

    @Test
    void aCurrentLimitMakesItSpeedUpEvenly() {
        Motor motor = motor(30, 0);
        SwerveDrive drive = SwerveDrive.of(0.6, 0.6, motor, 2).driving(4, 0, 0);
        assertThat(drive.next(STILL, BODY, 0.25).x()).isCloseTo(0.25 * 4 * motor.force(0) / 50, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void wheelsSpinAgainstAWallWhereTheirMotorsAreStronger(Dimension dimension) {
        for (double limit : new double[] {5, 300}) {
            SwerveDrive drive = SwerveDrive.of(0.6, 0.6, motor(limit, 0), 1).driving(3, 0, 0);
            Dynamics dynamics = robot(dimension, BODY, drive);
            dynamics.world().placeObject("robot", new Point(29.1, 0.25 + 1e-8, 0), 0);
            for (int k = 0; k < 20; k++) {
                dynamics.advance(0.05);
            }
            Twist stands = dynamics.velocity("robot");
            assertThat(stands.x()).isCloseTo(0, within(1e-6));
            boolean spins = limit == 300;
            assertThat(drive.wheelVelocity(stands, BODY).x()).isCloseTo(spins ? 3 : 0, within(1e-6));
            double pushes = dynamics.step(0.1).contacts().stream()
                    .filter(each -> "wall".equals(each.other()))
                    .mapToDouble(BodyContact::impulse)
                    .sum();
            double force = spins ? 50 * G : 4 * motor(limit, 0).force(0);
            assertThat(pushes).isCloseTo(0.1 * force, within(1e-3 * force));
        }
    }

    @Test
    void whatPushesAcrossFixedWheelsOvercomesTheirFrictionFirst() {
        List<SwerveDrive.Module> six = List.of(
                new SwerveDrive.Module(0.3, -0.3),
                new SwerveDrive.Module(0, -0.3),
                new SwerveDrive.Module(-0.3, -0.3),
                new SwerveDrive.Module(0.3, 0.3),
                new SwerveDrive.Module(0, 0.3),
                new SwerveDrive.Module(-0.3, 0.3));
        SwerveDrive tank = new SwerveDrive(six, null, 0.5, 0);
        for (double share : new double[] {0.45, 0.6}) {
            Dynamics dynamics = robot(Dimension.PLANAR, BODY, tank.driving(0, 0, 0));
            for (int k = 0; k < 20; k++) {
                dynamics.applyForce("robot", new Point(0, 0, share * 50 * G));
                dynamics.advance(0.05);
            }
            double speed = Math.max(0, share - 0.5) * G;
            assertThat(dynamics.velocity("robot").z()).isCloseTo(speed, within(1e-9));
        }
        // Wheels that do not steer scrub when the robot turns on the spot, and turn it more slowly than they roll.
        Twist turning = tank.driving(0, 0, 180).next(STILL, BODY, 3);
        assertThat(turning.ry()).isBetween(20.0, 170.0);
        assertThat(turning.x()).isCloseTo(0, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void modulesTurnAsFastAsTheyCan(Dimension dimension) {
        SwerveDrive drive = SwerveDrive.of(0.6, 0.6, null, 1).steering(90);
        Dynamics dynamics = robot(dimension, BODY, drive);
        dynamics.advance(0.02);
        dynamics.drive(
                "robot",
                drive.with(drive.modules().stream().map(each -> each.to(45, 0)).toList()));
        for (int k = 0; k < 30; k++) {
            double angle =
                    ((SwerveDrive) dynamics.drive("robot")).modules().get(3).angle();
            assertThat(angle).isCloseTo(Math.min(45, k * 1.8), within(1e-9));
            dynamics.advance(0.02);
        }
    }

    @Test
    void stepsOfAnyLengthRepeatToTheBit() {
        SwerveDrive drive = SwerveDrive.of(0.6, 0.6, motor(60, 0.001), 1.1).steering(400);
        Point[] ends = new Point[2];
        for (int run = 0; run < 2; run++) {
            Dynamics dynamics = robot(Dimension.PLANAR, BODY, drive);
            for (int k = 0; k < 50; k++) {
                dynamics.drive("robot", drive.driving(3, k % 7 - 3, 40 * (k % 5)));
                dynamics.advance(0.02);
            }
            ends[run] = dynamics.world().getObject("robot").center();
        }
        assertThat(ends[0]).isEqualTo(ends[1]);
    }

    @Test
    void badModulesAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SwerveDrive(List.of(), null, 1, 0))
                .withMessageContaining("modules must be 1 to 64 (got: 0)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SwerveDrive.Module(Double.NaN, 0))
                .withMessageContaining("x must be");
    }

    /** Wheels that work against each other take long: a step may be ended, and is counted, between any two bodies. */
    @ParameterizedTest
    @EnumSource
    void aStepMayBeEndedBetweenTheDrivesOfTwoBodies(Dimension dimension) {
        int bodies = 20;
        int[] pauses = new int[2];
        for (int k = 0; k < 2; k++) {
            Geometry world = new Geometry(400, 40, 200, dimension, Accuracy.EXACT);
            Dynamics dynamics = new Dynamics(world);
            for (int b = 0; b < bodies; b++) {
                world.addObject(new BoxObject(new Point(10 * b - 190, -19.5, 0), 1, 1, 1).moveable("r" + b));
                dynamics.add("r" + b, Body.ofMass(world.getObject("r" + b), 50));
                Drive drive = k == 0
                        ? new OmnidirectionalDrive(1, 1, 90, 90).driving(1, 0, 0)
                        : SwerveDrive.of(0.6, 0.6, null, 1).driving(1, 0, 0);
                dynamics.drive("r" + b, drive);
            }
            int at = k;
            dynamics.pausing(() -> pauses[at]++);
            dynamics.step(0.02);
        }
        assertThat(pauses[1]).isGreaterThanOrEqualTo(pauses[0] + bodies);
    }
}
