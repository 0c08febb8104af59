package robosim.geometry.viewer.space;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.viewer.space.Refinement.Step;

class RefinementTest {
    private static Refinement learned(double nanosPerSample) {
        Refinement refinement = new Refinement();
        for (int k = 0; k < 60; k++) {
            refinement.learn(1000, (long) (1000 * nanosPerSample));
        }
        return refinement;
    }

    @Test
    void thePictureGetsFinerUntilItHasSeveralSamplesInEachPixel() {
        assertThat(Refinement.from(new Step(8, 1)))
                .isEqualTo(List.of(new Step(8, 1), new Step(4, 1), new Step(2, 1), new Step(1, 1), new Step(1, 2)));
        assertThat(Refinement.after(new Step(1, 2))).isEqualTo(new Step(1, 2));
    }

    @Test
    void theFirstStepIsTheFinestThatIsThereAtOnce() {
        for (double nanos : new double[] {10, 100, 500, 1000, 3000}) {
            Refinement refinement = learned(nanos);
            Step first = refinement.first(1024, 768);
            double time = first.rays(1024, 768) * nanos;
            assertThat(time).as("%s at %f", first, nanos).isLessThanOrEqualTo(1.01 * Refinement.AT_ONCE);
            if (first.side() > 1) {
                // One step finer would be too late.
                assertThat(4 * time).isGreaterThan(0.98 * Refinement.AT_ONCE);
            }
        }
        assertThat(learned(10).first(1024, 768)).isEqualTo(new Step(1, 1));
        assertThat(learned(1e9).first(1024, 768)).isEqualTo(new Step(Refinement.COARSEST, 1));
    }

    @Test
    void allStepsTogetherTakeLittleMoreThanTheLast() {
        long rays = 0;
        for (Step step : Refinement.from(new Step(16, 1))) {
            rays += step.rays(1024, 768);
        }
        assertThat(rays).isLessThan((long) (1.34 * new Step(1, 2).rays(1024, 768)));
    }

    @Test
    void squaresCoverThePictureAndNoMore() {
        for (int pixels = 1; pixels < 70; pixels++) {
            for (int side = 1; side <= 16; side *= 2) {
                int squares = new Step(side, 1).squares(pixels);
                assertThat(squares * side).isBetween(pixels, pixels + side - 1);
            }
        }
    }
}
