package robosim.geometry.dynamics.step;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** When two meet, against a walk through many times; also where they touch at first and another corner comes down later. */
class TimeOfImpactTest {
    private static final double GAP = 1e-10;
    private static final int TIMES = 400;

    private final Pieces pieces = new Pieces();
    private final Bodies bodies = new Bodies();
    private final TimeOfImpact impact = new TimeOfImpact(bodies, pieces);

    TimeOfImpactTest() {
        bodies.add();
        box(0, 0.225, 0.175);
        box(-1, 5, 0.5);
        impact.stayApart(GAP);
    }

    private void box(int body, double width, double length) {
        pieces.begin(body, 0, 0);
        pieces.corner(width, length);
        pieces.corner(-width, length);
        pieces.corner(-width, -length);
        pieces.corner(width, -length);
    }

    @Test
    void noMeetingIsLost() {
        SplittableRandom random = new SplittableRandom(7);
        int met = 0;
        int never = 0;
        for (int k = 0; k < 3000; k++) {
            double angle = random.nextInt(3) == 0 ? 0 : random.nextDouble(-1e-3, 1e-3);
            pieces.turn(0, Math.cos(angle), Math.sin(angle));
            bodies.x[0] = random.nextDouble(-4, 4);
            bodies.z[0] = 0.8;
            bodies.z[0] += GAP * random.nextDouble(1, 1.01) - impact.measure(0, 1, 0);
            bodies.w[0] = random.nextDouble(-1, 1);
            // The corner that touches parts from the wall.
            double corner = 0.225 * Math.abs(bodies.w[0]);
            bodies.vz[0] = corner * random.nextDouble(-1, 1.5);
            bodies.vx[0] = random.nextDouble(-0.2, 0.2);
            double time = impact.first(0, 1, 0, 0.05);
            double until = Math.min(time, 0.05);
            for (int n = 0; n <= TIMES; n++) {
                double t = until * n / TIMES;
                assertThat(impact.measure(0, 1, t))
                        .as("case %d at %s of %s", k, t, until)
                        .isPositive();
            }
            met += time < 0.05 ? 1 : 0;
            never += time < 0.05 ? 0 : 1;
        }
        assertThat(met).isGreaterThan(300);
        assertThat(never).isGreaterThan(300);
    }
}
