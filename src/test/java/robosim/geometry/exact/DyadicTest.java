package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static robosim.geometry.exact.Samples.big;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class DyadicTest {
    @Test
    void everyDoubleComesBack() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 20_000; i++) {
            double value = Samples.any(random) + 0.0;
            Dyadic dyadic = Dyadic.of(value);
            assertThat(dyadic.doubleValue()).isEqualTo(value);
            assertThat(dyadic.negate().doubleValue()).isEqualTo(0.0 - value);
        }
        assertThat(Dyadic.of(Double.MAX_VALUE).doubleValue()).isEqualTo(Double.MAX_VALUE);
        assertThat(Dyadic.of(-Double.MIN_VALUE).doubleValue()).isEqualTo(-Double.MIN_VALUE);
    }

    @Test
    void polynomialsHaveTheSignsOfTheirDecimalTwins() {
        SplittableRandom random = new SplittableRandom(2);
        int[] signs = new int[3];
        for (int i = 0; i < 2_000; i++) {
            double a = Samples.any(random);
            double b = random.nextBoolean() ? Samples.any(random) : Samples.near(a, random);
            double c = random.nextInt(4) == 0 ? a : Samples.any(random);
            double d = random.nextInt(4) == 0 ? Samples.near(b, random) : b;
            if (!Double.isFinite(b) || !Double.isFinite(d)) {
                continue;
            }
            Dyadic result = Dyadic.product(a, b).subtract(Dyadic.product(c, d)).add(Dyadic.difference(a, c));
            BigDecimal truth =
                    big(a).multiply(big(b)).subtract(big(c).multiply(big(d))).add(big(a).subtract(big(c)));
            assertThat(result.signum()).as("%s %s %s %s", a, b, c, d).isEqualTo(truth.signum());
            assertThat(Dyadic.product(a, b).compareTo(Dyadic.product(c, d)))
                    .isEqualTo(big(a).multiply(big(b)).compareTo(big(c).multiply(big(d))));
            signs[1 + truth.signum()]++;
        }
        assertThat(Arrays.stream(signs).min().orElse(0)).isGreaterThan(50);
    }

    @Test
    void roundsToNearest() {
        SplittableRandom random = new SplittableRandom(3);
        int inexact = 0;
        for (int i = 0; i < 3_000; i++) {
            Dyadic value = Dyadic.product(Samples.any(random), Samples.any(random));
            if (random.nextBoolean()) {
                double around = StrictMath.scalb(random.nextDouble(-1, 1), random.nextInt(-1074, 1000));
                // A tie, or just beside one: half an ulp and perhaps a breath more.
                value = Dyadic.of(around).add(Dyadic.of(Math.ulp(around)).scale(-1));
                value = random.nextBoolean() ? value : value.add(Dyadic.ONE.scale(-3000));
            }
            double nearest = value.doubleValue();
            if (Double.isInfinite(nearest)) {
                continue;
            }
            int side = Dyadic.of(nearest).compareTo(value);
            double below = side < 0 ? nearest : Math.nextDown(nearest);
            double above = Math.nextUp(below);
            if (side == 0 || Double.isInfinite(below) || Double.isInfinite(above)) {
                continue;
            }
            inexact++;
            assertThat(Dyadic.of(below).compareTo(value)).isNegative();
            assertThat(Dyadic.of(above).compareTo(value)).isPositive();
            int doubled = Dyadic.of(below).add(Dyadic.of(above)).compareTo(value.scale(1));
            boolean evenBelow = (Double.doubleToRawLongBits(below) & 1) == 0;
            double expected = doubled > 0 || (doubled == 0 && evenBelow) ? below : above;
            assertThat(nearest).isEqualTo(expected);
        }
        assertThat(inexact).isGreaterThan(1000);
    }

    @Test
    void overflowRoundsAsIeeeDoes() {
        Dyadic huge = Dyadic.of(Double.MAX_VALUE).square();
        assertThat(huge.doubleValue()).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(huge.negate().doubleValue()).isEqualTo(Double.NEGATIVE_INFINITY);
        Dyadic tiny = Dyadic.of(Double.MIN_VALUE).square();
        assertThat(tiny.doubleValue()).isZero();
    }

    @Test
    void signsOfSumsAreExact() {
        SplittableRandom random = new SplittableRandom(4);
        int naiveWrong = 0;
        int zeros = 0;
        for (int i = 0; i < 20_000; i++) {
            double a = random.nextBoolean() ? Samples.any(random) : Samples.ordinary(random);
            double b = random.nextInt(3) == 0 ? Samples.any(random) : Samples.ordinary(random);
            double c = random.nextInt(3) == 0 ? Samples.near(a, random) : a + b;
            double d =
                    random.nextInt(3) == 0 ? Samples.near(b, random) : random.nextBoolean() ? b : Samples.any(random);
            if (!Double.isFinite(c) || !Double.isFinite(d)) {
                continue;
            }
            int three = big(a).add(big(b)).compareTo(big(c));
            int four = big(a).add(big(b)).compareTo(big(c).add(big(d)));
            String sample = "%s %s %s %s".formatted(a, b, c, d);
            assertThat(Dyadic.signOfSum(a, b, -c)).as(sample).isEqualTo(three);
            assertThat(Dyadic.signOfSum(a, b, -c, -d)).as(sample).isEqualTo(four);
            naiveWrong += three != Double.compare(a + b, c) || four != Double.compare(a + b, c + d) ? 1 : 0;
            zeros += four == 0 ? 1 : 0;
        }
        assertThat(naiveWrong).isGreaterThan(1000);
        assertThat(zeros).isGreaterThan(100);
        assertThat(Dyadic.signOfSum(Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE))
                .isEqualTo(1);
        assertThat(Dyadic.signOfSum(Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE))
                .isZero();
    }

    @Test
    void equalValuesAreEqual() {
        Dyadic six = Dyadic.of(6);
        Dyadic alsoSix = Dyadic.of(5.5).add(Dyadic.of(0.5));
        assertThat(alsoSix).isEqualTo(six).hasSameHashCodeAs(six);
        assertThat(six.subtract(alsoSix)).isEqualTo(Dyadic.ZERO).hasSameHashCodeAs(Dyadic.of(-0.0));
        assertThat(six).isNotEqualTo(Dyadic.of(7));
        assertThat(six.scale(-1).min(six).doubleValue()).isEqualTo(3);
        assertThat(six.negate().abs().max(Dyadic.ONE)).isEqualTo(six);
    }

    @Test
    void refusesWhatIsNoNumber() {
        assertThatThrownBy(() -> Dyadic.of(Double.NaN)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> Dyadic.of(Double.POSITIVE_INFINITY)).hasMessageContaining("got: Infinity");
    }
}
