package robosim.geometry.dynamics.spatial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is taken from the energy of bodies that touch. */
class FreeGroupTest {
    /** A ball of mass 2 and inertia 1 on the X axis, which moves along it. */
    private static RigidBody ball(double x, double speed) {
        RigidBody ball = new RigidBody(0, 2, new double[] {1, 1, 1}, true, 0.5);
        ball.place[0] = x;
        ball.start[0] = x;
        for (int k = 0; k < 3; k++) {
            ball.place[3 + 4 * k] = 1;
        }
        ball.v[0] = speed;
        ball.turnInertia();
        return ball;
    }

    private static void brake(double excess, RigidBody... balls) {
        List<RigidBody> bodies = List.of(balls);
        double[] gravity = {0, -9.81, 0};
        Clusters cluster = new Clusters(bodies, gravity, (one, other) -> false);
        cluster.member = new int[] {0, 1};
        cluster.count = balls.length;
        double moving = 0;
        for (RigidBody each : balls) {
            moving += each.v[0] * each.v[0]; // of a mass of 2
        }
        FreeGroup group = new FreeGroup(bodies, gravity, null, null);
        group.list(cluster);
        group.brake(0, moving, excess);
    }

    /** What bodies lose first is how they move against each other; both momenta stay as long as that suffices. */
    @ParameterizedTest
    @CsvSource({
        "0.5, 1, -1, .866025403784, -.866025403784",
        "0.5, 2, 0, 1.866025403784, .133974596216",
        "2, 2, 0, 1, 1",
        "3, 2, 0, .707106781187, .707106781187"
    })
    void energyIsTakenFromTheDeviationFirst(double excess, double a, double b, double thenA, double thenB) {
        RigidBody one = ball(-1, a);
        RigidBody other = ball(1, b);
        brake(excess, one, other);
        assertThat(one.v[0]).isCloseTo(thenA, within(1e-11));
        assertThat(other.v[0]).isCloseTo(thenB, within(1e-11));
    }

    /** Where more is to be taken than there is, nothing moves afterwards: a head-on pair, a ball alone, one at rest. */
    @ParameterizedTest
    @CsvSource({"2, 1, -1", "2.5, 1, -1", "5, 2, 0", "1, 0, 0"})
    void noMoreIsTakenThanThereIs(double excess, double a, double b) {
        RigidBody one = ball(-1, a);
        RigidBody other = ball(1, b);
        brake(excess, one, other);
        assertThat(one.v).containsExactly(new double[6], within(1e-15));
        assertThat(other.v).containsExactly(new double[6], within(1e-15));
        RigidBody alone = ball(0, a);
        brake(a * a + 1, alone);
        assertThat(alone.v).containsExactly(new double[6], within(1e-15));
    }
}
