package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.exact.Samples.big;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import java.util.function.DoubleConsumer;
import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;

class RadiansTest {
    private static final MathContext DIGITS = new MathContext(80);
    private static final BigDecimal PI = new BigDecimal(
            "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534");

    @Test
    void theBitsOfStrictMath() {
        SplittableRandom random = new SplittableRandom(31);
        for (int i = 0; i < 300_000; i++) {
            assertSameBits(random.nextDouble(-7, 7));
            assertSameBits(random.nextDouble(-900_000, 900_000));
            assertSameBits(StrictMath.scalb(random.nextDouble(-2, 2), random.nextInt(-60, 22)));
        }
        atTheEighths(RadiansTest::assertSameBits);
        // The next pieces of pi / 2 would be nearer here, and StrictMath leaves them out.
        assertSameBits(0x1.f6a76f5d3badap2);
        assertSameBits(0x1.5fdbce4e439a6p3);
        assertSameBits(0x1.f6a74c7dee25p3);
        for (double x : new double[] {0.0, -0.0, Double.NaN, Double.POSITIVE_INFINITY, Double.MIN_VALUE, 1e300}) {
            assertSameBits(x);
            assertSameBits(-x);
        }
    }

    /** Where the formula changes: beside each eighth of a turn, and where the limits of its parts are. */
    private static void atTheEighths(DoubleConsumer test) {
        SplittableRandom random = new SplittableRandom(32);
        for (int k = 1; k < 20_000; k++) {
            double x = (k < 1000 ? k : random.nextInt(1, 1 << 20)) * (Math.PI / 4);
            for (int ulps = -4; ulps <= 4; ulps++) {
                test.accept(x + ulps * Math.ulp(x));
            }
            test.accept(-x * (1 + StrictMath.scalb(random.nextDouble(-1, 1), -random.nextInt(8, 54))));
        }
        for (double limit : new double[] {0x1p-27, 0x1.33333p-2, 0x1.9p-1, 0x1.921fcp-1, 0x1p19 * Math.PI / 2}) {
            for (int k = -1000; k <= 1000; k++) {
                test.accept(limit + k * Math.ulp(limit));
                test.accept(limit * (1 + k * 0x1p-30));
            }
        }
    }

    private static void assertSameBits(double x) {
        if (bits(Radians.sin(x)) != bits(StrictMath.sin(x)) || bits(Radians.cos(x)) != bits(StrictMath.cos(x))) {
            assertThat(Radians.sin(x)).as("sin " + Double.toHexString(x)).isEqualTo(StrictMath.sin(x));
            assertThat(Radians.cos(x)).as("cos " + Double.toHexString(x)).isEqualTo(StrictMath.cos(x));
        }
    }

    private static long bits(double value) {
        return Double.doubleToLongBits(value);
    }

    @Test
    void withinOneUlpOfTheSeries() {
        SplittableRandom random = new SplittableRandom(33);
        double worst = 0;
        for (int i = 0; i < 1500; i++) {
            double x = switch (i % 3) {
                case 0 -> random.nextDouble(-7, 7);
                case 1 -> random.nextDouble(-800_000, 800_000);
                default -> random.nextInt(1, 400) * (Math.PI / 4) * (1 + random.nextDouble(-1, 1) * 0x1p-40);
            };
            BigDecimal truth = big(x);
            worst = Math.max(worst, ulps(Radians.sin(x), sine(truth)));
            worst = Math.max(worst, ulps(Radians.cos(x), sine(truth.add(PI.divide(big(2), DIGITS)))));
        }
        assertThat(worst).isBetween(0.5, 1.0);
    }

    @Test
    void nothingIsAllocated() {
        int calls = 100_000;
        assertThat(sum(calls)).isNotZero();
        assertThat(Allocated.everyTime(() -> sum(calls))).isLessThan(calls);
    }

    private static double sum(int calls) {
        double sum = 0;
        for (int k = 0; k < calls; k++) {
            sum += Radians.sin(k * 0.01) + Radians.cos(k * 0.01);
        }
        return sum;
    }

    private static double ulps(double value, BigDecimal truth) {
        return big(value)
                .subtract(truth)
                .abs()
                .divide(big(Math.ulp(truth.doubleValue())), DIGITS)
                .doubleValue();
    }

    private static BigDecimal sine(BigDecimal radians) {
        BigDecimal x = radians.remainder(PI.multiply(big(2)));
        BigDecimal square = x.multiply(x, DIGITS);
        BigDecimal term = x;
        BigDecimal sum = x;
        for (int n = 2; n < 90; n += 2) {
            term = term.multiply(square, DIGITS).divide(BigDecimal.valueOf(-n * (n + 1L)), DIGITS);
            sum = sum.add(term);
        }
        return sum;
    }
}
