package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class OutwardTest {
    @Test
    void sumsAreRoundedUpByNoMoreThanAnUlp() {
        SplittableRandom random = new SplittableRandom(42);
        int rounded = 0;
        for (int k = 0; k < 2000; k++) {
            double a = random.nextDouble(-4, 4);
            double b = random.nextDouble(4);
            BigDecimal truth = new BigDecimal(a).add(new BigDecimal(b));
            double sum = Outward.sum(a, b);
            assertThat(new BigDecimal(sum)).isGreaterThanOrEqualTo(truth);
            assertThat(new BigDecimal(Math.nextDown(sum))).isLessThan(truth);
            rounded += new BigDecimal(sum).compareTo(truth) > 0 ? 1 : 0;
        }
        assertThat(rounded).isBetween(100, 1900);
    }

    @Test
    void aBoxAlongTheAxesIsExact() {
        double[] halves = {0.1, 0.2, 0.7};
        assertThat(Outward.ofBox(halves, 0, new double[] {0, -1, 0}, 0)).isEqualTo(0.2);
        assertThat(Outward.ofBox(halves, 0, new double[] {0.6, 0.8, 0}, 0)).isGreaterThan(0.22);
    }
}
