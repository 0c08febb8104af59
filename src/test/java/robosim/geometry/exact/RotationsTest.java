package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RotationsTest {
    private static final int AT = 2;

    @Test
    void yawTurnsForwardAgainstZ() {
        double[] r = new double[9];
        Rotations.yaw(90, 0, r, 0);
        assertThat(r).containsExactly(0, 0, 1, 0, 1, 0, -1, 0, 0);
        Rotations.yaw(30, 0, r, 0);
        assertThat(r[2]).isEqualTo(0.5);
        assertThat(r[6]).isEqualTo(-0.5);
        assertThat(Rotations.isUpright(r, 0)).isTrue();
        assertThat(Rotations.isOrthonormal(r, 0)).isTrue();
    }

    @Test
    void quarterTurnsAreExact() {
        SplittableRandom random = new SplittableRandom(31);
        double[] r = new double[AT + 9];
        Rotations.identity(r, AT);
        for (int i = 0; i < 10_000; i++) {
            double turn = 90.0 * random.nextInt(-5, 6);
            if (random.nextBoolean()) {
                Rotations.turnOwnX(r, AT, turn);
            } else {
                Rotations.turnOwnY(r, AT, turn);
            }
            for (int k = AT; k < r.length; k++) {
                assertThat(Math.abs(r[k])).isIn(0.0, 1.0);
                assertThat(Double.doubleToRawLongBits(r[k])).isNotEqualTo(Double.doubleToRawLongBits(-0.0));
            }
            assertThat(Rotations.isOrthonormal(r, AT)).isTrue();
        }
        // Four quarters of a rotation that is none of these give it back to the bit.
        Rotations.turnOwnX(r, AT, 12.3);
        Rotations.turnOwnY(r, AT, 45.6);
        double[] before = r.clone();
        for (int i = 0; i < 4; i++) {
            Rotations.turnOwnX(r, AT, 90);
        }
        assertThat(r).isEqualTo(before);
    }

    @Test
    void turnsAreProductsFromTheRight() {
        double[] r = new double[9];
        Rotations.yaw(20, 0, r, 0);
        Rotations.turnOwnX(r, 0, 30);
        double[] x = {1, 0, 0, 0, Degrees.cos(30), -Degrees.sin(30), 0, Degrees.sin(30), Degrees.cos(30)};
        double[] product = new double[9];
        Rotations.yaw(20, 0, product, 0);
        Rotations.multiply(product, 0, x, 0, product, 0);
        assertClose(r, product, 1e-15);
        Rotations.turnOwnY(r, 0, -70);
        double[] y = new double[9];
        Rotations.yaw(-70, 0, y, 0);
        Rotations.multiply(product, 0, y, 0, y, 0);
        assertClose(r, y, 1e-15);
    }

    @Test
    void aMillionTurnsStayOrthonormal() {
        SplittableRandom random = new SplittableRandom(32);
        double[] r = new double[AT + 9];
        Rotations.identity(r, AT);
        for (int i = 0; i < 1_000_000; i++) {
            if ((i & 1) == 0) {
                Rotations.turnOwnX(r, AT, random.nextDouble(-3, 3));
            } else {
                Rotations.turnOwnY(r, AT, 0.1);
            }
        }
        assertThat(offOrthonormal(r)).isLessThan(1e-15);
        assertThat(Rotations.isOrthonormal(r, AT)).isTrue();
    }

    @Test
    void uprightStaysUpright() {
        double[] r = new double[AT + 9];
        Rotations.yaw(17, 0, r, AT);
        for (int i = 0; i < 1000; i++) {
            Rotations.turnOwnY(r, AT, 0.7);
        }
        assertThat(Rotations.isUpright(r, AT)).isTrue();
        double[] expected = new double[AT + 9];
        Rotations.yaw(717, 0, expected, AT);
        assertClose(r, expected, 1e-12);
    }

    @Test
    void refusesWhatIsNoRotation() {
        double[] r = new double[9];
        Rotations.yaw(17, 0, r, 0);
        assertThat(Rotations.isOrthonormal(with(r, 1, 0.9e-9), 0)).isTrue();
        assertThat(Rotations.isOrthonormal(with(r, 1, 1e-8), 0)).isFalse();
        assertThat(Rotations.isOrthonormal(with(r, 4, -2), 0)).as("left-handed").isFalse();
        assertThat(Rotations.isOrthonormal(with(r, 8, Double.NaN), 0)).isFalse();
        assertThat(Rotations.isOrthonormal(new double[9], 0)).isFalse();
        double[] off = with(r, 0, 0.9e-9);
        Rotations.orthonormalise(off, 0);
        assertThat(offOrthonormal(shift(off))).isLessThan(1e-15);
    }

    private static double[] with(double[] r, int at, double more) {
        double[] changed = r.clone();
        changed[at] += more;
        return changed;
    }

    private static double[] shift(double[] r) {
        double[] shifted = new double[AT + 9];
        System.arraycopy(r, 0, shifted, AT, 9);
        return shifted;
    }

    private static double offOrthonormal(double[] r) {
        double worst = 0;
        for (int p = 0; p < 3; p++) {
            for (int q = 0; q < 3; q++) {
                double product = p == q ? -1 : 0;
                for (int row = AT; row < r.length; row += 3) {
                    product += r[row + p] * r[row + q];
                }
                worst = Math.max(worst, Math.abs(product));
            }
        }
        return worst;
    }

    private static void assertClose(double[] actual, double[] expected, double error) {
        for (int i = 0; i < actual.length; i++) {
            assertThat(Math.abs(actual[i] - expected[i])).as("number " + i).isLessThanOrEqualTo(error);
        }
    }
}
