package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.exact.Samples.big;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;

class DegreesTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal PI = new BigDecimal(
            "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534");
    private static final BigDecimal HALF_TURN = new BigDecimal(180);

    @Test
    void quarterTurnsAreExact() {
        double[] sines = {0, 1, 0, -1};
        for (int k = -4000; k <= 4000; k++) {
            assertQuarter(90.0 * k, sines[Math.floorMod(k, 4)], sines[Math.floorMod(k + 1, 4)]);
        }
        assertQuarter(0x1p90 * 360, 0, 1);
        assertQuarter(0x1p43 * 360 + 90, 1, 0);
        assertQuarter(-0.0, 0, 1);
    }

    private static void assertQuarter(double degrees, double sine, double cosine) {
        assertThat(Double.doubleToRawLongBits(Degrees.sin(degrees)))
                .as("sin " + degrees)
                .isEqualTo(Double.doubleToRawLongBits(sine));
        assertThat(Double.doubleToRawLongBits(Degrees.cos(degrees)))
                .as("cos " + degrees)
                .isEqualTo(Double.doubleToRawLongBits(cosine));
    }

    /** The reduction to a turn is that of Math.IEEEremainder, next to half turns and for any number of turns. */
    @Test
    void anglesAreReducedExactly() {
        SplittableRandom random = new SplittableRandom(26);
        for (int i = 0; i < 200_000; i++) {
            double size = StrictMath.scalb(random.nextDouble(1, 2), random.nextInt(7, 60));
            double tie = 180 * Math.rint(size / 180);
            double degrees = switch (i % 4) {
                case 0 -> size;
                case 1 -> tie;
                case 2 -> Math.nextUp(tie);
                default -> Math.nextDown(tie);
            };
            double reduced = Math.IEEEremainder(degrees, 360);
            assertThat(Degrees.sin(degrees)).as("sin " + degrees).isEqualTo(Degrees.sin(reduced) + 0.0);
            assertThat(Degrees.cos(-degrees)).as("cos " + degrees).isEqualTo(Degrees.cos(reduced));
        }
    }

    @Test
    void symmetricAtEighths() {
        double root = Math.sqrt(0.5);
        for (int k = -20; k < 20; k++) {
            double degrees = 45 + 90.0 * k;
            assertThat(Math.abs(Degrees.sin(degrees))).isEqualTo(root);
            assertThat(Math.abs(Degrees.cos(degrees))).isEqualTo(root);
        }
        assertThat(Degrees.sin(30)).isEqualTo(0.5);
        assertThat(Degrees.cos(60)).isEqualTo(0.5);
        assertThat(Degrees.sin(-150)).isEqualTo(-0.5);
    }

    @Test
    void withinOneAndAHalfUlpOfTheSeries() {
        SplittableRandom random = new SplittableRandom(21);
        double worst = 0;
        for (int i = 0; i < Effort.cases(600); i++) {
            double degrees = switch (i % 4) {
                case 0 -> random.nextDouble(-360, 360);
                case 1 -> random.nextDouble(-1e9, 1e9);
                case 2 -> 90.0 * random.nextInt(-8, 9) + StrictMath.scalb(1.0, -random.nextInt(2, 44));
                default -> StrictMath.scalb(random.nextDouble(1, 2), -random.nextInt(4, 900));
            };
            worst = Math.max(worst, ulps(Degrees.sin(degrees), sine(big(degrees))));
            worst = Math.max(worst, ulps(Degrees.cos(degrees), sine(big(degrees).add(big(90)))));
            double lo = random.nextDouble(-0.5, 0.5) * Math.ulp(degrees);
            worst = Math.max(
                    worst, ulps(Degrees.sin(degrees, lo), sine(big(degrees).add(big(lo)))));
            worst = Math.max(
                    worst,
                    ulps(
                            Degrees.cos(degrees, lo),
                            sine(big(degrees).add(big(lo)).add(big(90)))));
        }
        assertThat(worst).isBetween(0.4, 1.5);
    }

    @Test
    void oddAndEvenToTheBit() {
        SplittableRandom random = new SplittableRandom(22);
        for (int i = 0; i < 10_000; i++) {
            double degrees = random.nextDouble(0, 1000);
            assertThat(Degrees.sin(-degrees)).isEqualTo(-Degrees.sin(degrees));
            assertThat(Degrees.cos(-degrees)).isEqualTo(Degrees.cos(degrees));
            double grid = random.nextInt(0, 360 * 1024) / 1024.0;
            assertThat(Degrees.cos(grid)).isEqualTo(Degrees.sin(90 - grid));
        }
    }

    @Test
    void aMillionTurnsDoNotDrift() {
        for (double turn : new double[] {0.1, -0.1, 359.9, 123.456, 180, -90, 1e9 + 0.1}) {
            double[] heading = new double[3];
            int turns = 1_000_000;
            int outside = 0;
            for (int i = 0; i < turns; i++) {
                Degrees.add(heading, 1, turn);
                boolean above = heading[1] > -180 || (heading[1] == -180 && heading[2] > 0);
                boolean below = heading[1] < 180 || (heading[1] == 180 && heading[2] <= 0);
                outside += above && below ? 0 : 1;
            }
            assertThat(outside).isZero();
            BigDecimal error = big(heading[1])
                    .add(big(heading[2]))
                    .subtract(big(turn).multiply(new BigDecimal(turns)))
                    .remainder(new BigDecimal(360));
            double off = Math.abs(Math.IEEEremainder(error.doubleValue(), 360));
            assertThat(off).as("after turns of " + turn).isLessThan(1e-20);
        }
        double[] heading = new double[2];
        for (int i = 0; i < 1_000_000; i++) {
            Degrees.add(heading, 0, 0.1);
        }
        // The decimal 0.1 that was meant, not the double: 10^6 of them are 277 turns and 280 degrees.
        assertThat(Math.abs(heading[0] + 80)).isLessThan(1e-9);
    }

    @Test
    void headingsAreReduced() {
        double[] heading = {180, 0};
        Degrees.add(heading, 0, 360);
        assertThat(heading).containsExactly(180, 0);
        Degrees.add(heading, 0, -360.0 * 7);
        assertThat(heading).containsExactly(180, 0);
        Degrees.add(heading, 0, Math.ulp(1.0));
        assertThat(heading).containsExactly(-180, Math.ulp(1.0));
    }

    @Test
    void quartersOfPiBecomeQuarters() {
        SplittableRandom random = new SplittableRandom(23);
        for (int i = 0; i < 5000; i++) {
            long k = i < 2000 ? i - 1000 : random.nextLong(-(1L << 45), 1L << 45);
            double radians = PI.multiply(BigDecimal.valueOf(k))
                    .divide(BigDecimal.valueOf(2))
                    .doubleValue();
            assertThat(Degrees.toDegrees(radians)).as("quarter " + k).isEqualTo(90.0 * k);
        }
        assertThat(Degrees.toDegrees(Math.PI)).isEqualTo(180);
        assertThat(Degrees.toDegrees(-Math.PI / 2)).isEqualTo(-90);
        assertThat(Degrees.toDegrees(Math.nextUp(Math.PI))).isGreaterThan(180);
        assertThat(Degrees.toDegrees(Math.nextDown(Math.PI))).isLessThan(180);
        assertThat(Degrees.toDegrees(Double.NaN)).isNaN();
        assertThat(Degrees.toDegrees(Double.MAX_VALUE)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(Double.doubleToRawLongBits(Degrees.toDegrees(-0.0))).isZero();
    }

    @Test
    void radiansAreCorrectlyRounded() {
        SplittableRandom random = new SplittableRandom(24);
        int differentFromNaive = 0;
        for (int i = 0; i < 5000; i++) {
            double angle = StrictMath.scalb(random.nextDouble(-2, 2), random.nextInt(-40, 20));
            double degrees = big(angle).multiply(HALF_TURN).divide(PI, DIGITS).doubleValue();
            assertThat(Degrees.toDegrees(angle)).as("radians " + angle).isEqualTo(degrees);
            assertThat(Degrees.toRadians(angle))
                    .as("degrees " + angle)
                    .isEqualTo(big(angle).multiply(PI).divide(HALF_TURN, DIGITS).doubleValue());
            differentFromNaive += degrees != angle * 180 / Math.PI ? 1 : 0;
        }
        assertThat(differentFromNaive).isGreaterThan(500);
    }

    @Test
    void headingsOfAxes() {
        double[] r = new double[9];
        for (int eighth = -3; eighth <= 4; eighth++) {
            Rotations.yaw(45.0 * eighth, 0, r, 0);
            assertThat(Degrees.headingOf(r[0], r[6])).isEqualTo(45.0 * eighth);
        }
        SplittableRandom random = new SplittableRandom(25);
        for (int i = 0; i < 1000; i++) {
            double heading = random.nextDouble(-180, 180);
            Rotations.yaw(heading, 0, r, 0);
            assertThat(Math.abs(Degrees.headingOf(r[0], r[6]) - heading)).isLessThan(1e-13);
        }
        assertThat(Degrees.headingOf(0, 0)).isZero();
        assertThat(Degrees.headingOf(-1, -0.0)).isEqualTo(180);
    }

    private static double ulps(double value, BigDecimal truth) {
        return big(value)
                .subtract(truth)
                .abs()
                .divide(big(Math.ulp(truth.doubleValue())), DIGITS)
                .doubleValue();
    }

    private static BigDecimal sine(BigDecimal degrees) {
        BigDecimal reduced = degrees.remainder(new BigDecimal(360));
        BigDecimal x = reduced.multiply(PI).divide(HALF_TURN, new MathContext(90));
        BigDecimal square = x.multiply(x, new MathContext(90));
        BigDecimal term = x;
        BigDecimal sum = x;
        for (int n = 2; n < 90; n += 2) {
            term = term.multiply(square, new MathContext(90))
                    .divide(BigDecimal.valueOf(-n * (n + 1L)), new MathContext(90));
            sum = sum.add(term);
        }
        return sum;
    }
}
