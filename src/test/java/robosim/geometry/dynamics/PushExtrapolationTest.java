package robosim.geometry.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.Twist;

class PushExtrapolationTest {
    private static final double GYRATION = 0.25;

    private final PushExtrapolation response = new PushExtrapolation();

    /** Pushes to 1 m/s, round by round, where contacts leave a share of each push; answers how the next is stretched. */
    private double stretchAfter(long firstRound, double... shares) {
        double speed = 0;
        double stretch = 1;
        for (int k = 0; k < shares.length; k++) {
            Twist now = twist(speed);
            assertThat(response.stretch(now, firstRound + k, GYRATION)).isEqualTo(1);
            response.pushed(now, twist(1), firstRound + k);
            speed += shares[k] * (1 - speed);
        }
        return response.stretch(twist(speed), firstRound + shares.length, GYRATION);
    }

    /** A movement that turns as well, at a degree a second for each millimetre. */
    private static Twist twist(double speed) {
        return new Twist(speed, 0, -0.5 * speed, 1000 * speed);
    }

    @Test
    void whatIsKeptTwiceIsExpectedOnceMore() {
        assertThat(stretchAfter(7, 0.25, 0.25)).isCloseTo(4, within(1e-12));
        assertThat(stretchAfter(20, 0.1, 0.8, 0.8)).isCloseTo(1.25, within(1e-12));
    }

    @Test
    void onePushTellsNothing() {
        assertThat(stretchAfter(7, 0.25)).isEqualTo(1);
        assertThat(stretchAfter(20, 0.25, 0.3)).isEqualTo(1);
    }

    @Test
    void againstWhatCannotBeMovedNothingIsExpected() {
        assertThat(stretchAfter(7, 0, 0)).isEqualTo(1);
        assertThat(stretchAfter(20, 1e-3, 1e-3)).isEqualTo(1);
        assertThat(stretchAfter(40, 1, 1)).isEqualTo(1);
    }

    @Test
    void aCollisionBeginsAnew() {
        stretchAfter(7, 0.25);
        // The round after is left out, as the next collision has other contacts.
        assertThat(response.stretch(twist(0.25), 9, GYRATION)).isEqualTo(1);
    }

    @Test
    void aRoundIsKnown() {
        assertThat(response.isOf(7)).isFalse();
        response.pushed(twist(0), twist(1), 7);
        assertThat(response.isOf(7)).isTrue();
        assertThat(response.isOf(8)).isFalse();
    }
}
