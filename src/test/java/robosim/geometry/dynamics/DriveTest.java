package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.world.body.ObjectBody;

class DriveTest {
    private static final int CASES = 20_000;
    private static final double NONE = Double.POSITIVE_INFINITY;
    private static final Twist STILL = new Twist(0, 0, 0, 0);
    private static final Body BODY = Body.of(10, 2);

    private final SplittableRandom random = new SplittableRandom(7);

    private double any(double most) {
        return random.nextDouble(-most, most);
    }

    /** The centre of the circle is where the wheels' rims, extended, stand still. */
    @Test
    void twoWheelsDriveTheCircleOfTheirSpeeds() {
        for (int k = 0; k < CASES; k++) {
            double track = random.nextDouble(0.1, 2);
            double left = any(3);
            double right = any(3);
            Twist made =
                    new DifferentialDrive(track, NONE, NONE).wheels(left, right).next(STILL, BODY, 0.1);
            // Each wheel is half a track from the middle; it drives its own arc.
            Pose before = Pose.of(new Point(), 0);
            Pose after = made.after(before, 0.5);
            double turned = StrictMath.toRadians(made.ry()) * 0.5;
            assertThat(turned * track).isCloseTo((right - left) * 0.5, within(1e-12));
            Point rightWheel =
                    Pose.of(new Point(0, 0, track / 2), 0).within(after).center();
            double chord = Math.sqrt(square(rightWheel.x()) + square(rightWheel.z() - track / 2));
            double half = turned / 2;
            double arc = Math.abs(half) < 1e-9 ? chord : chord * Math.abs(half) / Math.abs(StrictMath.sin(half));
            assertThat(arc).isCloseTo(Math.abs(right) * 0.5, within(1e-9));
            assertThat(made.z()).isZero();
        }
    }

    private static double square(double a) {
        return a * a;
    }

    @Test
    void twoWheelsTooFastKeepTheCurve() {
        int reduced = 0;
        for (int k = 0; k < CASES; k++) {
            DifferentialDrive drive = new DifferentialDrive(0.5, 1, NONE).wheels(any(3), any(3));
            Twist made = drive.next(STILL, BODY, 0.1);
            double aside = StrictMath.toRadians(made.ry()) * 0.25;
            assertThat(Math.max(Math.abs(made.x() - aside), Math.abs(made.x() + aside)))
                    .isLessThanOrEqualTo(1 + 1e-12);
            Twist free = new DifferentialDrive(0.5, NONE, NONE)
                    .wheels(drive.left(), drive.right())
                    .next(STILL, BODY, 0.1);
            assertThat(made.x() * free.ry()).isCloseTo(made.ry() * free.x(), within(1e-9));
            reduced += made.equals(free) ? 0 : 1;
        }
        assertThat(reduced).isBetween(CASES / 3, CASES * 99 / 100);
    }

    /** From any velocity, in steps of any length: within the limits always, and at the command after its time. */
    @Test
    void accelerationsStayWithinTheirLimits() {
        for (int k = 0; k < CASES / 10; k++) {
            DifferentialDrive two = new DifferentialDrive(0.5, 2, 1.5).driving(any(1), any(90));
            OmnidirectionalDrive round = new OmnidirectionalDrive(2, 1.5, 200, 300).driving(any(1), any(1), any(90));
            AckermannDrive car = new AckermannDrive(1.2, 35, 2, 1.5).driving(any(2), any(60));
            Twist a = new Twist(any(1), 0, 0, any(90));
            Twist b = new Twist(any(1), 0, any(1), any(90));
            Twist c = new Twist(any(2), 0, 0, 0);
            double time = 0;
            while (time < 4) {
                double seconds = random.nextDouble(0.2);
                time += seconds;
                double most = 1.5 * seconds * (1 + 1e-9) + 1e-12;
                Twist next = two.next(a, BODY, seconds);
                double aside = StrictMath.toRadians(next.ry() - a.ry()) * 0.25;
                assertThat(Math.abs(next.x() - a.x()) + Math.abs(aside)).isLessThanOrEqualTo(most);
                a = next;
                next = round.next(b, BODY, seconds);
                assertThat(Math.sqrt(square(next.x() - b.x()) + square(next.z() - b.z())))
                        .isLessThanOrEqualTo(most);
                assertThat(Math.abs(next.ry() - b.ry())).isLessThanOrEqualTo(300 * seconds + 1e-9);
                b = next;
                next = car.next(c, BODY, seconds);
                assertThat(Math.abs(next.x() - c.x())).isLessThanOrEqualTo(most);
                c = next;
            }
            assertThat(a.x()).isCloseTo((two.left() + two.right()) / 2, within(1e-12));
            assertThat(b).isEqualTo(round.command());
            assertThat(c.x()).isEqualTo(car.speed());
        }
    }

    /** The rear axle of a car at the angle of its front wheels: a circle of the radius wheelbase / tan(angle). */
    @Test
    void aCarDrivesItsCircle() {
        for (int k = 0; k < CASES; k++) {
            double wheelbase = random.nextDouble(0.2, 4);
            double angle = any(50);
            Twist made = new AckermannDrive(wheelbase, 35, NONE, NONE)
                    .driving(any(3), angle)
                    .next(STILL, BODY, 1);
            double steered = Math.max(-35, Math.min(35, angle));
            double radius = wheelbase / StrictMath.tan(StrictMath.toRadians(steered));
            assertThat(StrictMath.toRadians(made.ry()) * radius).isCloseTo(made.x(), within(1e-9));
        }
        AckermannDrive left = new AckermannDrive(1, 30, 2, NONE).driving(1, 20);
        assertThat(left.next(STILL, BODY, 1).ry()).isPositive();
        assertThat(left.driving(0, 20).next(STILL, BODY, 1)).isEqualTo(STILL);
        // A body that may not turn so fast goes more slowly on the same circle.
        Twist free = left.next(STILL, BODY, 1);
        Twist slow = left.next(STILL, BODY.withLimits(NONE, 5), 1);
        assertThat(slow.ry()).isEqualTo(5);
        assertThat(slow.x() / slow.ry()).isCloseTo(free.x() / free.ry(), within(1e-12));
    }

    /** A centre ahead of the rear axle, or behind it, goes round the same point on the line of that axle. */
    @Test
    void aCarTurnsAboutItsRearAxleWhereverItsCentreIs() {
        for (double ahead : new double[] {0, 0.4, -0.3}) {
            for (double angle : new double[] {20, -30}) {
                Geometry world = new Geometry(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT);
                world.addObject(new BoxObject(new Point(), 1, 1, 0.5).moveable("car"));
                Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
                dynamics.add("car", Body.of(10, 1));
                AckermannDrive car = new AckermannDrive(1, 35, NONE, NONE).withCentreAhead(ahead);
                dynamics.drive("car", car.driving(1, angle));
                double radius = 1 / StrictMath.tan(StrictMath.toRadians(angle));
                for (int step = 1; step <= 20; step++) {
                    dynamics.step(0.1);
                    double turn = 0.1 * step / radius;
                    double sin = StrictMath.sin(turn);
                    double cos = StrictMath.cos(turn);
                    // Its middle is beside the rear axle, to the left: at -Z.
                    Point at = world.getObject("car").center();
                    assertThat(at.x()).isCloseTo(-ahead + ahead * cos + radius * sin, within(1e-9));
                    assertThat(at.z()).isCloseTo(-radius - ahead * sin + radius * cos, within(1e-9));
                }
            }
        }
        AckermannDrive car = new AckermannDrive(1, 35, NONE, NONE).withCentreAhead(0.5);
        assertThat(car.driving(1, 5).centreAhead()).isEqualTo(0.5);
        assertThatThrownBy(() -> car.withCentreAhead(NONE)).hasMessageStartingWith("centreAhead ");
        assertThat(DriveSettings.of(car).centreAhead()).isEqualTo(0.5);
        assertThatThrownBy(() -> new ObjectBody(0, 0, Surface.SMOOTH, 0, 0, 0, NONE, NONE, 0, 0, Set.of(), car))
                .hasMessageStartingWith("drive must have its centre on its rear axle");
    }

    /** Half a second of a newton on ten kilograms, and the end speed of a damped body, F / (m c). */
    @Test
    void aForceAccelerates() {
        Twist pushed = new ForceDrive(1, -2, 0.5).next(new Twist(1, 0, 0, 10), BODY, 0.5);
        assertThat(pushed.x()).isCloseTo(1.05, within(1e-15));
        assertThat(pushed.z()).isCloseTo(-0.1, within(1e-15));
        assertThat(pushed.ry()).isCloseTo(10 + StrictMath.toDegrees(0.125), within(1e-12));
        Body damped = BODY.withDamping(2, 4);
        for (double seconds : new double[] {0.001, 0.1, 1000}) {
            Twist now = STILL;
            for (int k = 0; k < 20_000; k++) {
                Twist next = new ForceDrive(10, 0, 4).next(now, damped, seconds);
                assertThat(next.x()).isBetween(now.x() * (1 - 1e-15), 0.5 * (1 + 1e-9));
                now = next;
            }
            assertThat(now.x()).isCloseTo(0.5, within(1e-9));
            assertThat(now.ry()).isCloseTo(StrictMath.toDegrees(0.5), within(1e-7));
        }
        // It rolls out, and never backwards.
        assertThat(new ForceDrive(0, 0, 0)
                        .next(new Twist(3, 0, 0, 0), damped, 1e9)
                        .x())
                .isBetween(0.0, 1e-8);
    }

    @Test
    void aStepOfNoTimeChangesNothingButThroughLimits() {
        Twist now = new Twist(0.5, 0, 0, 10);
        for (Drive drive : List.of(
                new DifferentialDrive(0.5, NONE, NONE).driving(1, 40),
                new OmnidirectionalDrive(NONE, NONE, NONE, NONE).driving(1, 1, 40),
                new ForceDrive(5, 5, 5))) {
            Twist next = drive.next(now, BODY, 0);
            assertThat(next.x()).isCloseTo(0.5, within(1e-15));
            assertThat(next.ry()).isCloseTo(10, within(1e-14));
        }
        assertThat(new VelocityDrive(new Twist(3, 0, 4, 7)).next(now, BODY.withLimits(1, 90), 1))
                .isEqualTo(new Twist(3 * 0.2, 0, 4 * 0.2, 7));
    }

    @Test
    void badNumbersAreNamed() {
        assertThatThrownBy(() -> new DifferentialDrive(0, 1, 1)).hasMessageStartingWith("track ");
        assertThatThrownBy(() -> new DifferentialDrive(1, -1, 1)).hasMessageStartingWith("maxSpeed ");
        assertThatThrownBy(() -> new DifferentialDrive(1, 1, Double.NaN)).hasMessageStartingWith("maxAcceleration ");
        assertThatThrownBy(() -> new DifferentialDrive(1, 1, 1).wheels(NONE, 0)).hasMessageStartingWith("left ");
        assertThatThrownBy(() -> new DifferentialDrive(1, 1, 1).driving(Double.NaN, 0))
                .hasMessageStartingWith("forward ");
        assertThatThrownBy(() -> new DifferentialDrive(1, 1, 1).driving(1, NONE))
                .hasMessageStartingWith("turn ");
        assertThatThrownBy(() -> new AckermannDrive(1, 90, 1, 1)).hasMessageStartingWith("maxSteering ");
        for (double steering : new double[] {90, -90, 200, Double.NaN}) {
            assertThatThrownBy(() -> new AckermannDrive(1, 30, 1, 1).driving(1, steering))
                    .hasMessageStartingWith("steering ")
                    .hasMessageContaining("(got: " + steering);
        }
        assertThat(new AckermannDrive(1, 30, 1, 1).driving(1, -89.9).steering()).isEqualTo(-89.9);
        assertThatThrownBy(() -> new AckermannDrive(-1, 30, 1, 1)).hasMessageStartingWith("wheelbase ");
        assertThatThrownBy(() -> new OmnidirectionalDrive(1, 1, Double.NaN, 1)).hasMessageStartingWith("maxTurn ");
        assertThatThrownBy(() -> new ForceDrive(NONE, 0, 0)).hasMessageStartingWith("x ");
        assertThatThrownBy(() -> new ForceDrive(0, 0, 0).next(STILL, BODY, -1)).hasMessageStartingWith("seconds ");
        assertThatThrownBy(() -> new DifferentialDrive(1, 1, 1).next(STILL, BODY, Double.NaN))
                .hasMessageStartingWith("seconds ");
    }
}
