package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class VectorMathTest {
    private static final MathContext DIGITS = new MathContext(60);

    @Test
    void legsOfAnySize() {
        for (double unit : new double[] {1, 0x1p-460, 0x1p-1070, 0x1p100}) {
            assertThat(VectorMath.legs(3 * unit, 4 * unit)).isEqualTo(5 * unit);
            assertThat(VectorMath.legs(0, 2 * unit)).isEqualTo(2 * unit);
            assertThat(VectorMath.legs(2 * unit, 0)).isEqualTo(2 * unit);
        }
        assertThat(VectorMath.length(2, -3, 6)).isEqualTo(7);
        assertThat(VectorMath.largest(1, -9, 4)).isEqualTo(9);
        assertThat(VectorMath.largest(-9, 1, 4)).isEqualTo(9);
        assertThat(VectorMath.largest(4, 1, -9)).isEqualTo(9);
    }

    @Test
    void signsAreTakenOver() {
        assertThat(VectorMath.signed(3, -2)).isEqualTo(-3);
        assertThat(VectorMath.signed(-3, -2)).isEqualTo(3);
        assertThat(VectorMath.signed(-3, 2)).isEqualTo(-3);
        assertThat(VectorMath.pick(-0x1p-1074, 1, 2)).isEqualTo(2);
        assertThat(VectorMath.pick(0, 1, 2)).isEqualTo(1);
        assertThat(VectorMath.pick(7, 1, 2)).isEqualTo(1);
    }

    /** With one rounding: half an ulp, and a little. */
    @Test
    void aDistanceAlongADirection() {
        SplittableRandom random = new SplittableRandom(91);
        double worst = 0;
        for (int k = 0; k < 3000; k++) {
            double dx = random.nextDouble(-2, 2);
            double dy = k % 3 == 0 ? 0 : random.nextDouble(-2, 2);
            double dz = random.nextDouble(-2, 2) * Math.scalb(1, -random.nextInt(30));
            double t = random.nextDouble(1, 1000);
            double tail = k % 2 == 0 ? 0 : random.nextDouble(-0.5, 0.5) * Math.ulp(t);
            BigDecimal square = square(dx).add(square(dy)).add(square(dz));
            BigDecimal truth = square.sqrt(DIGITS).multiply(new BigDecimal(t).add(new BigDecimal(tail)), DIGITS);
            double distance = VectorMath.along(t, tail, dx, dy, dz);
            double off = new BigDecimal(distance).subtract(truth).abs().doubleValue();
            worst = Math.max(worst, off / Math.ulp(distance));
        }
        assertThat(worst).isBetween(0.49, 0.501);
        assertThat(VectorMath.along(0, -1, 1, 0, 0)).as("not behind the start").isZero();
    }

    private static BigDecimal square(double x) {
        return new BigDecimal(x).multiply(new BigDecimal(x));
    }

    /** Three ulp of the larger of the distance and the coordinates. */
    @Test
    void whatIsFine() {
        assertThat(VectorMath.isFine(3 * Math.ulp(8.0), 8, 1)).isTrue();
        assertThat(VectorMath.isFine(Math.nextUp(3 * Math.ulp(8.0)), 8, 1)).isFalse();
        assertThat(VectorMath.isFine(3 * Math.ulp(64.0), 8, 64)).isTrue();
        assertThat(VectorMath.isFine(Double.NaN, 8, 64)).isFalse();
    }
}
