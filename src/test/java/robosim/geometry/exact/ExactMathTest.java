package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Rounded quotients and roots of exact numbers, at all magnitudes. */
class ExactMathTest {
    private static final MathContext DIGITS = new MathContext(400);

    private final SplittableRandom random = new SplittableRandom(81);

    private double positive(int reach) {
        return Math.scalb(random.nextDouble(1, 2), random.nextInt(-reach, reach));
    }

    @Test
    void aFlooredQuotientIsTheLargestDoubleNotAbove() {
        for (int k = 0; k < 1500; k++) {
            double p = positive(k % 3 == 0 ? 300 : 20);
            double q = k % 4 == 0 ? p / random.nextInt(1, 9) : positive(k % 3 == 0 ? 300 : 20);
            int power = k % 5 == 0 ? random.nextInt(-3000, 3000) : 0; // beyond the range of doubles
            double floor = ExactMath.floorQuotient(
                    Dyadic.of(p).scale(power), Dyadic.of(q).scale(power));
            BigDecimal under = new BigDecimal(q);
            assertThat(new BigDecimal(floor).multiply(under)).isLessThanOrEqualTo(new BigDecimal(p));
            assertThat(new BigDecimal(Math.nextUp(floor)).multiply(under)).isGreaterThan(new BigDecimal(p));
        }
        assertThat(ExactMath.floorQuotient(Dyadic.ZERO, Dyadic.of(3))).isZero();
        assertThat(ExactMath.floorQuotient(Dyadic.of(6), Dyadic.of(2))).isEqualTo(3);
    }

    @Test
    void aRootIsNotBelowAndHardlyAbove() {
        for (int k = 0; k < 600; k++) {
            double value = k % 3 == 0 ? random.nextInt(1, 1000) : positive(900);
            int power = 2 * (k % 5 == 0 ? random.nextInt(-2000, 2000) : 0);
            Dyadic root = ExactMath.sqrtUp(Dyadic.of(value).scale(power));
            Dyadic square = Dyadic.of(value).scale(power);
            assertThat(root.square().compareTo(square)).isNotNegative();
            Dyadic less = root.subtract(root.scale(-90));
            assertThat(less.square().compareTo(square)).isNegative();
        }
        assertThat(ExactMath.sqrtUp(Dyadic.of(144)).doubleValue()).isEqualTo(12);
        assertThat(ExactMath.sqrtUp(Dyadic.of(144)).subtract(Dyadic.of(12)).signum())
                .isZero();
        assertThat(ExactMath.sqrtUp(Dyadic.of(-1)).signum()).isZero();
        assertThat(ExactMath.sqrtUp(Dyadic.ZERO).signum()).isZero();
    }

    @Test
    void aNumberBesideATimesARoot() {
        for (double square : new double[] {0, 1, 2, 9, 0x1p-60, 0x1p200}) {
            for (double q : new double[] {-3, -1, 0, 1, 2.5}) {
                double product = q * Math.sqrt(square);
                for (double p : new double[] {-7, 0, 3, product, Math.nextUp(product), Math.nextDown(product)}) {
                    BigDecimal right =
                            new BigDecimal(square).sqrt(DIGITS).multiply(new BigDecimal(q), new MathContext(200));
                    int truth = new BigDecimal(p).compareTo(right);
                    assertThat(ExactMath.compareToRoot(Dyadic.of(p), Dyadic.of(q), Dyadic.of(square)))
                            .as("%s and %s times the root of %s", p, q, square)
                            .isEqualTo(truth);
                }
            }
        }
    }

    @Test
    void vectorsOfExactNumbers() {
        double[] row = {9, 1, 2, 3, 4, 5, 6, 7, 8, 10};
        ExactVector a = ExactVector.at(row, 1);
        ExactVector b = ExactVector.column(row, 1);
        is(a, 1, 2, 3);
        is(b, 1, 4, 7);
        is(a.plus(b), 2, 6, 10);
        is(a.minus(b), 0, -2, -4);
        is(a.times(Dyadic.of(-2)), -2, -4, -6);
        is(a.scale(3), 8, 16, 24);
        is(a.negate(), -1, -2, -3);
        is(a.cross(b), 2, -4, 2);
        assertThat(a.dot(b).doubleValue()).isEqualTo(30);
        assertThat(a.square().doubleValue()).isEqualTo(14);
        assertThat(a.minus(a).isZero()).isTrue();
        for (double[] one : new double[][] {{1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-1074}}) {
            assertThat(ExactVector.at(one, 0).isZero()).isFalse();
        }
        // Where doubles see nothing: (1 + 2^-60) - 1.
        assertThat(a.plus(ExactVector.of(0x1p-600, 0, 0)).minus(a).isZero()).isFalse();
    }

    private static void is(ExactVector v, double x, double y, double z) {
        assertThat(new double[] {v.x().doubleValue(), v.y().doubleValue(), v.z().doubleValue()})
                .containsExactly(x, y, z);
    }
}
