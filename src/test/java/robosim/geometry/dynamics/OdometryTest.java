package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.Twist;

class OdometryTest {
    private static final int STEPS = 200_000;
    private static final Odometry ODOMETRY = new Odometry(0.02, 0.5, 3, 0.05, 42);

    /** Mean and variance of the errors over many steps, their shares beyond one and two deviations, and no correlation. */
    @Test
    void errorsAreNormalWithTheVariancesGiven() {
        Twist had = new Twist(0.6, 0, 0.8, 45);
        double seconds = 0.25;
        double way = Math.sqrt(0.02 * 0.02 * 0.25 + 0.5 * 0.5 * (11.25 / 360));
        double turn = Math.sqrt(9 * 0.25 + 0.05 * 0.05 * 11.25);
        double[] sum = new double[3];
        double[] squares = new double[3];
        double[] beyond = new double[3];
        double cross = 0;
        double lagged = 0;
        double before = 0;
        for (int k = 0; k < STEPS; k++) {
            Twist told = ODOMETRY.measured(had, seconds, "cart", k);
            double[] error = {
                (told.x() - had.x()) * seconds / way,
                (told.z() - had.z()) * seconds / way,
                (told.ry() - had.ry()) * seconds / turn
            };
            for (int i = 0; i < 3; i++) {
                sum[i] += error[i];
                squares[i] += error[i] * error[i];
                beyond[i] += Math.abs(error[i]) > 2 ? 1 : 0;
            }
            cross += error[0] * error[2];
            lagged += error[0] * before;
            before = error[0];
        }
        for (int i = 0; i < 3; i++) {
            // Five standard errors of each estimate.
            assertThat(sum[i] / STEPS).isCloseTo(0, within(5 / Math.sqrt(STEPS)));
            assertThat(squares[i] / STEPS).isCloseTo(1, within(5 * Math.sqrt(2.0 / STEPS)));
            assertThat(beyond[i] / STEPS).isCloseTo(0.0455, within(5 * Math.sqrt(0.0455 / STEPS)));
        }
        assertThat(cross / STEPS).isCloseTo(0, within(5 / Math.sqrt(STEPS)));
        assertThat(lagged / STEPS).isCloseTo(0, within(5 / Math.sqrt(STEPS)));
    }

    @Test
    void seedRobotAndStepMakeTheError() {
        Twist had = new Twist(1, 0, 0, 10);
        Twist told = ODOMETRY.measured(had, 0.1, "cart", 7);
        assertThat(ODOMETRY.measured(had, 0.1, new String("cart"), 7)).isEqualTo(told);
        assertThat(ODOMETRY.measured(had, 0.1, "cart", 8)).isNotEqualTo(told);
        assertThat(ODOMETRY.measured(had, 0.1, "carts", 7)).isNotEqualTo(told);
        assertThat(new Odometry(0.02, 0.5, 3, 0.05, 43).measured(had, 0.1, "cart", 7))
                .isNotEqualTo(told);
        assertThat(told.z()).isZero();
    }

    @Test
    void whoStandsMeasuresNothing() {
        Twist still = new Twist(0, 0, 0, 0);
        for (int k = 0; k < 100; k++) {
            assertThat(ODOMETRY.measured(still, 0.1, "cart", k)).isEqualTo(still);
        }
        Twist had = new Twist(1, 0, 2, 3);
        assertThat(new Odometry(0, 0, 0, 0, 1).measured(had, 0.1, "cart", 1)).isEqualTo(had);
    }

    /** The bits are part of the promise: a recorded run repeats everywhere. */
    @Test
    void theBitsAreTheSameEverywhere() {
        long digest = 17;
        for (int k = 0; k < 10_000; k++) {
            Twist told = ODOMETRY.measured(new Twist(1, 0, 0.5, k % 90), 0.1, "robot " + k % 10, k);
            digest = 31 * digest + Double.doubleToLongBits(told.x());
            digest = 31 * digest + Double.doubleToLongBits(told.z());
            digest = 31 * digest + Double.doubleToLongBits(told.ry());
        }
        assertThat(Long.toHexString(digest)).isEqualTo("d2497d16c98f96f9");
    }

    @Test
    void badNumbersAreNamed() {
        assertThatThrownBy(() -> new Odometry(-1, 0, 0, 0, 0)).hasMessageStartingWith("wayPerWay ");
        assertThatThrownBy(() -> new Odometry(0, 0, 0, Double.NaN, 0)).hasMessageStartingWith("turnPerTurn ");
        assertThatThrownBy(() -> ODOMETRY.measured(new Twist(0, 0, 0, 0), 0, "cart", 1))
                .hasMessageStartingWith("seconds ");
    }
}
