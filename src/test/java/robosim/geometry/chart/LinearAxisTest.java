package robosim.geometry.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class LinearAxisTest {
    @Test
    void fromZeroWithAFewRoundMarks() {
        for (double most : new double[] {0.7, 1, 3.3, 9.99, 47, 123, 99_999}) {
            LinearAxis axis = LinearAxis.upTo("n", most);
            assertThat(axis.high()).isGreaterThanOrEqualTo(most).isLessThan(most * 1.6);
            assertThat(axis.ticks()).as("marks up to %s", most).hasSizeBetween(3, 8);
            assertThat(axis.ticks())
                    .as("without noise")
                    .allMatch(tick -> tick.label().length() <= 7);
        }
    }

    @Test
    void marksAreRoundAndWithin() {
        SplittableRandom random = new SplittableRandom(9);
        for (int k = 0; k < 500; k++) {
            double low = random.nextDouble(-2, 2) * Math.pow(10, random.nextInt(9) - 4);
            double high = low + random.nextDouble(2) * Math.pow(10, random.nextInt(9) - 4);
            LinearAxis axis = LinearAxis.around("n", low, high);
            assertThat(axis.ticks()).hasSizeBetween(2, 13);
            assertThat(axis.at(low)).isPositive().isLessThanOrEqualTo(axis.at(high));
            assertThat(axis.at(high)).isLessThan(1);
            for (Axis.Tick tick : axis.ticks()) {
                BigDecimal told = new BigDecimal(tick.label().replace(",", ""));
                assertThat(told.remainder(axis.step())).isEqualByComparingTo(BigDecimal.ZERO);
                assertThat(axis.at(told.doubleValue())).isEqualTo(tick.at()).isBetween(0.0, 1.0);
            }
        }
    }
}
