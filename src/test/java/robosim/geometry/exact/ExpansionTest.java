package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.exact.Samples.big;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ExpansionTest {
    @Test
    void everyOperationIsExact() {
        SplittableRandom random = new SplittableRandom(41);
        for (int i = 0; i < 5_000; i++) {
            double[] e = new double[8];
            double[] f = new double[2];
            int n = grown(random, e, 7);
            int m = random.nextBoolean()
                    ? Expansion.scale(new double[] {wide(random)}, 1, wide(random), f)
                    : Expansion.difference(wide(random), wide(random), f);
            double[] h = new double[32];
            assertExact(h, Expansion.sum(e, n, f, m, h), value(e, n).add(value(f, m)));
            assertExact(h, Expansion.product(e, n, f, m, h), value(e, n).multiply(value(f, m)));
            double b = wide(random);
            int length = Expansion.scale(e, n, b, h);
            BigDecimal truth = value(e, n).multiply(big(b));
            assertExact(h, length, truth);
            Expansion.negate(h, length);
            assertExact(h, length, truth.negate());
        }
    }

    @Test
    void whatCancelsIsZero() {
        double[] e = new double[4];
        int n = Expansion.grow(e, 0, 0x1p60);
        n = Expansion.grow(e, n, 1);
        n = Expansion.grow(e, n, -0x1p60);
        n = Expansion.grow(e, n, -1);
        assertThat(n).isZero();
        assertThat(Expansion.sign(e, n)).isZero();
        assertThat(Expansion.difference(3, 3, e)).isZero();
        assertThat(Expansion.scale(new double[] {3}, 1, 0, e)).isZero();
    }

    @Test
    void theGuardLetsNothingThroughThatUnderflows() {
        for (int degree = 1; degree <= 8; degree++) {
            int least = 0;
            while (Expansion.fits(StrictMath.scalb(1.0, least - 1), degree)) {
                least--;
            }
            double ulp = Math.ulp(StrictMath.scalb(1.0, least));
            double product = 1;
            for (int i = 0; i < degree; i++) {
                product *= ulp;
            }
            assertThat(product).as("degree " + degree).isPositive();
            assertThat(least).as("and no more timid than it must").isLessThan(60 - 1074 / degree);
            assertThat(Expansion.fits(0x1p100, degree)).isTrue();
        }
        assertThat(Expansion.fits(Double.NaN, 1)).isFalse();
        assertThat(Expansion.fits(Double.POSITIVE_INFINITY, 1)).isFalse();
        assertThat(Expansion.fits(Double.MIN_VALUE, 2)).isFalse();
        assertThat(Expansion.fits(-0.0, 8)).isTrue();
    }

    @Test
    void doubleDoublesKeepAHundredBits() {
        SplittableRandom random = new SplittableRandom(42);
        MathContext digits = new MathContext(60);
        double[] out = new double[2];
        double worst = 0;
        for (int i = 0; i < 5_000; i++) {
            double a = Samples.ordinary(random);
            double aLo = Math.ulp(a) * random.nextDouble(-0.5, 0.5);
            double b = Samples.ordinary(random);
            double bLo = Math.ulp(b) * random.nextDouble(-0.5, 0.5);
            BigDecimal x = big(a).add(big(aLo));
            BigDecimal y = big(b).add(big(bLo));
            DoubleDouble.multiply(a, aLo, b, bLo, out, 0);
            worst = Math.max(worst, off(out, x.multiply(y), x.multiply(y)));
            DoubleDouble.divide(a, aLo, b, bLo, out, 0);
            worst = Math.max(worst, off(out, x.divide(y, digits), x.divide(y, digits)));
            DoubleDouble.add(a, aLo, b, bLo, out, 0);
            worst = Math.max(worst, off(out, x.add(y), x.abs().add(y.abs())));
            DoubleDouble.subtract(a, aLo, b, bLo, out, 0);
            worst = Math.max(worst, off(out, x.subtract(y), x.abs().add(y.abs())));
            if (a > 0) {
                DoubleDouble.sqrt(a, aLo, out, 0);
                worst = Math.max(worst, off(out, x.sqrt(digits), x.sqrt(digits)));
            }
            DoubleDouble.sum(a, bLo, out, 0);
            assertThat(value(out, 2)).isEqualByComparingTo(big(a).add(big(bLo)));
            DoubleDouble.product(a, bLo, out, 0);
            assertThat(value(out, 2)).isEqualByComparingTo(big(a).multiply(big(bLo)));
        }
        assertThat(worst).isBetween(0x1p-112, 0x1p-100);
        DoubleDouble.sqrt(0, 0, out, 0);
        assertThat(out).containsExactly(0, 0);
    }

    @Test
    void differencesOfProductsSurviveCancellation() {
        SplittableRandom random = new SplittableRandom(43);
        double worst = 0;
        for (int i = 0; i < 5_000; i++) {
            double a = Samples.ordinary(random);
            double b = Samples.ordinary(random);
            double c = Samples.near(b, random);
            double d = Samples.near(a, random);
            BigDecimal truth = big(a).multiply(big(b)).subtract(big(c).multiply(big(d)));
            double result = DoubleDouble.differenceOfProducts(a, b, c, d);
            assertThat(DoubleDouble.sumOfProducts(a, b, -c, d)).isEqualTo(result);
            worst = Math.max(
                    worst,
                    truth.signum() == 0
                            ? Math.abs(result)
                            : big(result).subtract(truth).abs().doubleValue() / Math.ulp(truth.doubleValue()));
        }
        assertThat(worst).isBetween(0.2, 2.0);
    }

    private static double off(double[] out, BigDecimal truth, BigDecimal scale) {
        return value(out, 2)
                .subtract(truth)
                .abs()
                .divide(scale.abs(), MathContext.DECIMAL64)
                .doubleValue();
    }

    private static double wide(SplittableRandom random) {
        return random.nextInt(5) == 0
                ? random.nextInt(-3, 4)
                : StrictMath.scalb(random.nextDouble(-1, 1), random.nextInt(-90, 90));
    }

    private static int grown(SplittableRandom random, double[] e, int count) {
        int n = 0;
        BigDecimal truth = BigDecimal.ZERO;
        for (int i = 0; i < count; i++) {
            double b = random.nextInt(4) == 0 && n > 0 ? -e[n - 1] : wide(random);
            truth = truth.add(big(b));
            n = Expansion.grow(e, n, b);
        }
        assertExact(e, n, truth);
        return n;
    }

    private static void assertExact(double[] h, int n, BigDecimal truth) {
        assertThat(value(h, n)).isEqualByComparingTo(truth);
        assertThat(Expansion.sign(h, n)).isEqualTo(truth.signum());
        for (int i = 1; i < n; i++) {
            assertThat(Math.abs(h[i - 1])).isLessThan(Math.abs(h[i]));
        }
    }

    private static BigDecimal value(double[] e, int n) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < n; i++) {
            sum = sum.add(big(e[i]));
        }
        return sum;
    }
}
