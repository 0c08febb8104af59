package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.Allocated;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/** What nothing is in the way of is where the formulae say, whatever the length of the steps. */
class UnhinderedTest {
    private static final double RATE = 0.5;
    private static final double TURN_RATE = 0.8;

    private static Geometry world() {
        Geometry world = new Geometry(60, 5, 60, Dimension.PLANAR, Accuracy.EXACT);
        world.addObject(new CylinderObject(new Point(), 0.3, 1).moveable("body"));
        return world;
    }

    private static void run(Dynamics dynamics, double time, double seconds) {
        for (int k = 0; k < Math.round(time / seconds); k++) {
            dynamics.step(seconds);
        }
    }

    /** {@code v exp(-c t)}, and the way {@code v (1 - exp(-c t)) / c}. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.5, 4})
    void dampingIsExponential(double seconds) {
        Geometry world = world();
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("body", Body.of(20, 2).withDamping(RATE, TURN_RATE));
        dynamics.setVelocity("body", new Twist(2, 0, 0, 90));
        run(dynamics, 4, seconds);
        double left = StrictMath.exp(-4 * RATE);
        double turnLeft = StrictMath.exp(-4 * TURN_RATE);
        Twist velocity = dynamics.velocity("body");
        assertThat(Math.hypot(velocity.x(), velocity.z())).isCloseTo(2 * left, within(1e-12));
        assertThat(velocity.ry()).isCloseTo(90 * turnLeft, within(1e-11));
        assertThat(world.getObject("body").center().x()).isCloseTo(2 * (1 - left) / RATE, within(1e-9));
        assertThat(world.getObject("body").center().z()).isCloseTo(0, within(1e-9));
        assertThat(world.getObject("body").heading()).isCloseTo(90 * (1 - turnLeft) / TURN_RATE, within(1e-9));
    }

    /** To the end speed {@code u = F / (m c)}: {@code u (1 - exp(-c t))}. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.5, 4})
    void aForceAgainstDampingIsExponential(double seconds) {
        Geometry world = world();
        Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
        dynamics.add("body", Body.of(20, 2).withDamping(RATE, TURN_RATE));
        dynamics.drive("body", new ForceDrive(30, 0, 0));
        run(dynamics, 4, seconds);
        double end = 30 / (20 * RATE);
        double gained = 1 - StrictMath.exp(-4 * RATE);
        assertThat(dynamics.velocity("body").x()).isCloseTo(end * gained, within(1e-12));
        assertThat(world.getObject("body").center().x()).isCloseTo(end * (4 - gained / RATE), within(1e-9));
    }

    /** A half of {@code a t^2} until the command is reached, which is within a part of a step, then straight on. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.5", "0.05, 0.5", "0.25, 0.5", "1, 0.5", "0.05, 2", "1, 2"})
    void aCommandMayBeReachedWithinAStep(double seconds, double acceleration) {
        double speed = 0.513;
        double infinite = Double.POSITIVE_INFINITY;
        for (Drive drive : new Drive[] {
            new DifferentialDrive(0.5, 2, acceleration).driving(speed, 0),
            new OmnidirectionalDrive(infinite, acceleration, infinite, infinite).driving(speed, 0, 0),
            new AckermannDrive(0.5, 30, 2, acceleration).driving(speed, 0)
        }) {
            Geometry world = world();
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("body", Body.of(20, 2));
            dynamics.drive("body", drive);
            run(dynamics, 3, seconds);
            double reached = speed / acceleration;
            assertThat(world.getObject("body").center().x())
                    .as("%s", drive)
                    .isCloseTo(speed * (3 - reached / 2), within(1e-9));
            assertThat(dynamics.velocity("body").x()).isCloseTo(speed, within(1e-12));
        }
    }

    /** Against the power series, and beyond where that is of use against what connects the three. */
    @Test
    void theFunctionsAreThoseOfTheSeries() {
        for (double x = 1e-9; x < 700; x *= 1.01) {
            double kept = Decay.kept(x);
            double mean = Decay.mean(x);
            double gain = Decay.meanGain(x);
            assertThat(1 - x * mean).isCloseTo(kept, within(3e-16));
            assertThat(1 - x * gain).isCloseTo(mean, within(3e-16));
            double series = 0;
            double term = 1.0 / 2;
            for (int k = 0; k < 40 && x < 1; k++) {
                series += term;
                term *= -x / (k + 3);
            }
            if (x < 1) {
                assertThat(gain).as("%s", x).isCloseTo(series, within(1e-13));
            }
        }
        assertThat(new double[] {Decay.kept(0), Decay.mean(0), Decay.meanGain(0)})
                .containsExactly(1, 1, 0.5);
        assertThat(Decay.kept(1e30)).isZero();
    }

    /** However long a step, it is divided into parts of 1/16 s. */
    @Test
    void aLongStepIsThatManyShortOnes() {
        String[] ends = new String[2];
        double[] seconds = {100, 1.0 / 16};
        for (int k = 0; k < 2; k++) {
            Geometry world = new Geometry(4000, 5, 4000, Dimension.PLANAR, Accuracy.EXACT);
            world.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("cart"));
            Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
            dynamics.add("cart", Body.of(20, 1));
            dynamics.drive("cart", new DifferentialDrive(0.5, 1, 0.5).driving(0.7, 20));
            for (double time = 0; time < 100; time += seconds[k]) {
                dynamics.advance(seconds[k]);
            }
            ends[k] = world.getObject("cart").toString();
        }
        assertThat(ends[0]).isEqualTo(ends[1]);
    }

    @Test
    void theyAllocateNothing() {
        double[] sum = new double[1];
        long bytes = Allocated.everyTime(() -> {
            for (int k = 1; k <= 20_000; k++) {
                double x = k * 1e-3;
                sum[0] += Decay.kept(x) + Decay.mean(x) + Decay.meanGain(x);
            }
        });
        assertThat(bytes).isLessThan(20_000);
        assertThat(sum[0]).isPositive();
    }
}
