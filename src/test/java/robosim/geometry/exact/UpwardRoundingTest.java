package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class UpwardRoundingTest {
    @Test
    void sumsAreRoundedUpByNoMoreThanAnUlp() {
        SplittableRandom random = new SplittableRandom(42);
        int rounded = 0;
        for (int k = 0; k < 2000; k++) {
            double a = random.nextDouble(-4, 4);
            double b = random.nextDouble(4);
            BigDecimal truth = new BigDecimal(a).add(new BigDecimal(b));
            double sum = UpwardRounding.sum(a, b);
            assertThat(new BigDecimal(sum)).isGreaterThanOrEqualTo(truth);
            assertThat(new BigDecimal(Math.nextDown(sum))).isLessThan(truth);
            rounded += new BigDecimal(sum).compareTo(truth) > 0 ? 1 : 0;
        }
        assertThat(rounded).isBetween(100, 1900);
    }

    @Test
    void aBoxAlongTheAxesIsExact() {
        double[] halves = {0.1, 0.2, 0.7};
        assertThat(UpwardRounding.ofBox(halves, 0, new double[] {0, -1, 0}, 0)).isEqualTo(0.2);
        assertThat(UpwardRounding.ofBox(halves, 0, new double[] {0.6, 0.8, 0}, 0))
                .isGreaterThan(0.22);
    }

    /** Never below the truth, and above it by a few ulp at most; nothing is rounded where nothing has to be. */
    @Test
    void turnedShapesReachNoFurtherThanIsSaid() {
        SplittableRandom random = new SplittableRandom(43);
        for (int k = 0; k < 2000; k++) {
            int power = k % 4 == 0 ? random.nextInt(-1060, -900) : k % 4 == 1 ? 0 : random.nextInt(-30, 30);
            double[] halves = new double[3];
            double[] row = new double[3];
            BigDecimal box = BigDecimal.ZERO;
            for (int i = 0; i < 3; i++) {
                halves[i] = random.nextInt(6) == 0 ? 0 : Math.scalb(random.nextDouble(1, 2), power);
                row[i] = random.nextInt(6) == 0 ? random.nextInt(2) : random.nextDouble(-1, 1);
                box = box.add(new BigDecimal(halves[i]).multiply(new BigDecimal(row[i]).abs()));
            }
            hardlyAbove(UpwardRounding.ofBox(halves, 0, row, 0), box, 6);
            BigDecimal along = new BigDecimal(halves[1]).multiply(new BigDecimal(row[0]).abs());
            hardlyAbove(
                    UpwardRounding.ofCapsule(halves[0], halves[1], row[0]), along.add(new BigDecimal(halves[0])), 4);
            double length = Math.sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
            if (length > 0.01) {
                BigDecimal across = new BigDecimal(row[1]).pow(2).add(new BigDecimal(row[2]).pow(2));
                BigDecimal square = across.add(new BigDecimal(row[0]).pow(2));
                MathContext digits = new MathContext(60);
                BigDecimal rim = across.divide(square, digits).sqrt(digits).multiply(new BigDecimal(halves[0]));
                hardlyAbove(
                        UpwardRounding.ofCylinder(halves[0], halves[1], row[0], row[1], row[2], length),
                        along.add(rim),
                        40);
            }
        }
        assertThat(UpwardRounding.ofCapsule(0.25, 2, -1)).isEqualTo(2.25);
        assertThat(UpwardRounding.ofCapsule(0.25, 2, 0)).isEqualTo(0.25);
        assertThat(UpwardRounding.ofCylinder(0, 0, 1, 0, 0, 1)).isZero();
        assertThat(UpwardRounding.ofCylinder(0x1p-1074, 0, 1, 0x1p-30, 0, 1)).isPositive();
    }

    private static void hardlyAbove(double answer, BigDecimal truth, int ulps) {
        assertThat(new BigDecimal(answer)).isGreaterThanOrEqualTo(truth);
        BigDecimal slack = new BigDecimal(Math.ulp(answer)).multiply(BigDecimal.valueOf(ulps));
        assertThat(new BigDecimal(answer).subtract(slack)).isLessThanOrEqualTo(truth);
    }
}
