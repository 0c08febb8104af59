package robosim.geometry.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TwistTest {
    private final SplittableRandom random = new SplittableRandom(3);

    private double near() {
        return random.nextDouble(-5, 5);
    }

    private static double distance(Point a, Point b) {
        return Math.hypot(Math.hypot(a.x() - b.x(), a.y() - b.y()), a.z() - b.z());
    }

    private static double far(Pose a, Pose b) {
        double most = distance(a.center(), b.center());
        for (int k = 0; k < 9; k++) {
            most = Math.max(most, Math.abs(a.rotation(k) - b.rotation(k)));
        }
        return most;
    }

    @Test
    void straightAhead() {
        Pose start = Pose.of(new Point(1, 2, 3), 90);
        Pose end = Twist.drive(2, 0).after(start, 1.5);
        assertThat(end.center()).isEqualTo(new Point(1, 2, 0)); // heading 90 is towards -Z
        assertThat(end.heading()).isEqualTo(90);
        assertThat(new Twist(0, 1, 2, 0).after(start, -1).center()).isEqualTo(new Point(-1, 1, 3));
    }

    @Test
    void aCircle() {
        Twist drive = Twist.drive(Math.PI / 2, 90); // radius 1, to the left
        Pose quarter = drive.after(Pose.ORIGIN, 1);
        assertThat(distance(quarter.center(), new Point(1, 0, -1))).isLessThan(4e-16);
        assertThat(quarter.heading()).isEqualTo(90);
        Pose half = drive.after(Pose.ORIGIN, 2);
        assertThat(distance(half.center(), new Point(0, 0, -2))).isLessThan(1e-15);
        assertThat(half.heading()).isEqualTo(180);
        Pose whole = drive.after(Pose.ORIGIN, 4);
        assertThat(distance(whole.center(), new Point())).isLessThan(1e-15);
        assertThat(whole.heading()).isEqualTo(0);
    }

    @Test
    void atTimeZeroNothingChanges() {
        for (int k = 0; k < 1000; k++) {
            Pose start = Pose.of(new Point(near(), near(), near()), near() * 30).turned(k % 2 * near() * 9, near());
            assertThat(new Twist(near(), near(), near(), near() * 50).after(start, 0))
                    .isEqualTo(start);
        }
    }

    /** The slow way: many short straight moves, each followed by a turn; and two times are one after the other. */
    @Test
    void asManySmallSteps() {
        for (int k = 0; k < 40; k++) {
            Pose start = Pose.of(new Point(near(), near(), near()), near() * 30).turned(k % 2 * near() * 9, 0);
            Twist twist = new Twist(near(), near(), near(), k % 5 == 0 ? 1e-9 * near() : near() * 40);
            double time = near();
            Pose end = twist.after(start, time);
            int steps = 2000;
            Pose slow = start.turned(0, twist.ry() * time / steps / 2);
            for (int step = 0; step < steps; step++) {
                Point c = slow.center();
                double[] r = slow.rotation();
                double share = time / steps;
                slow = slow.movedTo(new Point(
                                c.x() + share * (r[0] * twist.x() + r[1] * twist.y() + r[2] * twist.z()),
                                c.y() + share * (r[3] * twist.x() + r[4] * twist.y() + r[5] * twist.z()),
                                c.z() + share * (r[6] * twist.x() + r[7] * twist.y() + r[8] * twist.z())))
                        .turned(0, twist.ry() * time / steps);
            }
            slow = slow.turned(0, -twist.ry() * time / steps / 2);
            assertThat(far(end, slow)).as("%s for %s", twist, time).isLessThan(1e-5);
            double part = time * random.nextDouble();
            assertThat(far(end, twist.after(twist.after(start, part), time - part)))
                    .isLessThan(1e-13);
            assertThat(far(start, twist.after(end, -time))).isLessThan(1e-13);
        }
    }

    @Test
    void refusals() {
        assertThatThrownBy(() -> new Twist(Double.NaN, 0, 0, 0)).hasMessageContaining("x must be a number");
        assertThatThrownBy(() -> new Twist(0, 0, 0, Double.POSITIVE_INFINITY)).hasMessageContaining("ry must be");
        assertThatThrownBy(() -> Twist.drive(1, 0).after(Pose.ORIGIN, 0x1p100))
                .hasMessageContaining("seconds must be a time at which coordinates are within 2^100");
        assertThatThrownBy(() -> Twist.drive(1, 0).after(Pose.ORIGIN, Double.NaN))
                .hasMessageContaining("(got: NaN with Twist[");
        assertThatThrownBy(() -> Twist.drive(0, 1e308).after(Pose.ORIGIN, 1e10)).hasMessageContaining("seconds");
        assertThat(Twist.drive(1, 1e-300).after(Pose.ORIGIN, 1e-10).center().x())
                .isCloseTo(1e-10, within(1e-24));
    }
}
