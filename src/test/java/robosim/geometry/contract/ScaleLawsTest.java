package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/**
 * Every question about every shape has the same answer at all legal scales: times a power of two the same bits, and where
 * subnormal numbers round more coarsely the same verdict.
 */
@Tag("slow")
class ScaleLawsTest {
    /** Below this an answer may be rounded to fewer digits. */
    private static final int SUBNORMAL = -950;

    private static final int[] POWERS = {
        -1000, -930, -850, -700, -550, -536, -525, -450, -360, -300, -250, -210, -190, -170, -150, -130, -110, -60, 30,
        60, 90
    };

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void answersScale(Dimension dimension) {
        int compared = 0;
        int echoes = 0;
        int blocked = 0;
        for (int seed = 0; seed < Effort.cases(160); seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            Accuracy accuracy = seed % 5 == 0 ? Accuracy.values()[seed / 5 % 4] : Accuracy.EXACT;
            ScaledScene scene = new ScaledScene(random, dimension, accuracy);
            List<ScaledScene.Answer> ordinary = scene.answers(0);
            for (ScaledScene.Answer answer : ordinary) {
                echoes += answer.question().contains("width") && answer.value() < Double.POSITIVE_INFINITY ? 1 : 0;
                blocked += answer.question().contains("allowed") && answer.value() == 0 ? 1 : 0;
            }
            // The scales take turns, so that each is asked of as many scenes in a short run.
            for (int k = seed % 4; k < POWERS.length; k += 4) {
                if (scene.isLegalAt(POWERS[k])) {
                    compare(
                            ordinary,
                            scene.answers(POWERS[k]),
                            POWERS[k],
                            "seed " + seed + " at 2^" + POWERS[k] + ": " + scene);
                    compared += ordinary.size();
                }
            }
        }
        assertThat(compared).isGreaterThan(10_000 * Effort.cases(160) / 160);
        assertThat(echoes).isGreaterThan(Effort.cases(160));
        assertThat(blocked).isGreaterThan(Effort.cases(160));
    }

    private static void compare(
            List<ScaledScene.Answer> ordinary, List<ScaledScene.Answer> scaled, int power, String scene) {
        for (int k = 0; k < Math.min(ordinary.size(), scaled.size()); k++) {
            double expected = ordinary.get(k).value();
            String what = ordinary.get(k).question() + ", " + scene;
            if (power >= SUBNORMAL || Double.isInfinite(expected)) {
                assertThat(scaled.get(k).value()).as(what).isEqualTo(expected);
            } else {
                double slack = 0x1p-40 * Math.abs(expected) + 0x1p-50;
                assertThat(scaled.get(k).value()).as(what).isBetween(expected - slack, expected + slack);
            }
        }
        assertThat(scaled).as(scene).hasSameSizeAs(ordinary);
    }
}
