package robosim.geometry.sensor.effects;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;

/** Numbers drawn by place have the moments and the distribution that they should have, and are the same everywhere. */
class DrawsTest {
    private static final int COUNT = Effort.cases(10_000_000);

    /** Five standard errors of a mean of numbers with this standard deviation. */
    private static Offset<Double> five(double deviation) {
        return Offset.offset(5 * deviation / Math.sqrt(COUNT));
    }

    /** The probability that a normal number is below a limit, by adding thin slices from zero: no code of the product. */
    private static double below(double limit) {
        int slices = 20_000;
        double sum = 0;
        for (int k = 0; k < slices; k++) {
            double x = limit * (k + 0.5) / slices;
            sum += Math.exp(-0.5 * x * x);
        }
        return 0.5 + sum * limit / slices / Math.sqrt(2 * Math.PI);
    }

    @Test
    void momentsOfNormalNumbers() {
        long key = Draws.key(7, 11);
        long step = Draws.step(key);
        double[] powers = new double[7];
        double product = 0;
        double last = 0;
        for (int k = 0; k < COUNT; k++) {
            double x = Draws.normal(Draws.bits(key, step, k));
            double power = 1;
            for (int p = 0; p < powers.length; p++) {
                powers[p] += power;
                power *= x;
            }
            product += x * last;
            last = x;
        }
        for (int p = 0; p < powers.length; p++) {
            powers[p] /= COUNT;
        }
        // E x^2 = 1, E x^4 = 3, E x^6 = 15; a power's deviation is the root of E x^2p - (E x^p)^2.
        assertThat(powers[1]).isCloseTo(0, five(1));
        assertThat(powers[2]).isCloseTo(1, five(Math.sqrt(2)));
        assertThat(powers[3]).isCloseTo(0, five(Math.sqrt(15)));
        assertThat(powers[4]).isCloseTo(3, five(Math.sqrt(96)));
        assertThat(powers[5]).isCloseTo(0, five(Math.sqrt(945)));
        assertThat(powers[6]).isCloseTo(15, five(Math.sqrt(10395 - 225)));
        assertThat(product / COUNT).as("correlation of neighbours").isCloseTo(0, five(1));
    }

    @Test
    void distributionOfNormalNumbers() {
        // Limits in the cores, in the wedges at both ends of the ziggurat, and in the tail, which begins at 3.654.
        double[] limits = {-4.2, -3.8, -3.66, -3.5, -3, -2, -1, -0.5, -0.21, -0.05, 0, 0.05, 0.3, 1, 2, 3, 3.6, 3.7, 4};
        long[] counts = new long[limits.length];
        long key = Draws.key(1, -3);
        long step = Draws.step(key);
        for (int k = 0; k < COUNT; k++) {
            double x = Draws.normal(Draws.bits(key, step, k));
            int at = Arrays.binarySearch(limits, x);
            int first = at < 0 ? -at - 1 : at;
            if (first < counts.length) {
                counts[first]++;
            }
        }
        long sum = 0;
        for (int k = 0; k < limits.length; k++) {
            sum += counts[k];
            double share = below(limits[k]);
            assertThat((double) sum / COUNT)
                    .as("share below " + limits[k])
                    .isCloseTo(share, five(Math.sqrt(share * (1 - share))));
        }
    }

    @Test
    void uniformNumbersAreEvenInEachBit() {
        long key = Draws.key(99, 0);
        long step = Draws.step(key);
        int[] ones = new int[Long.SIZE];
        double sum = 0;
        double squares = 0;
        int count = COUNT / 10;
        for (int k = 0; k < count; k++) {
            long bits = Draws.bits(key, step, k);
            for (int bit = 0; bit < Long.SIZE; bit++) {
                ones[bit] += (int) (bits >>> bit) & 1;
            }
            double x = Draws.uniform(bits);
            assertThat(x >= 0 && x < 1).isTrue();
            sum += x;
            squares += x * x;
        }
        Offset<Double> near = Offset.offset(5 * 0.5 / Math.sqrt(count));
        for (int one : ones) {
            assertThat((double) one / count).isCloseTo(0.5, near);
        }
        assertThat(sum / count).isCloseTo(0.5, near);
        assertThat(squares / count).isCloseTo(1.0 / 3, near);
    }

    @Test
    void neighbouringKeysHaveNothingInCommon() {
        int count = COUNT / 10;
        for (long other : new long[] {1, 2, -1, 1L << 32, 1L << 63}) {
            long first = Draws.key(5, 0);
            long second = Draws.key(5, other);
            double product = 0;
            int agreeing = 0;
            for (int k = 0; k < count; k++) {
                long a = Draws.bits(first, Draws.step(first), k);
                long b = Draws.bits(second, Draws.step(second), k);
                product += Draws.normal(a) * Draws.normal(b);
                agreeing += Long.SIZE - Long.bitCount(a ^ b);
            }
            assertThat(product / count).as("key " + other).isCloseTo(0, Offset.offset(5 / Math.sqrt(count)));
            assertThat(agreeing / (64.0 * count)).isCloseTo(0.5, Offset.offset(5 * 0.5 / Math.sqrt(64.0 * count)));
        }
    }

    /** The same bits on every JVM: what they were when this test was written. */
    @Test
    void theNumbersAreTheseOnEveryJvm() {
        long key = Draws.key(42, 1);
        long step = Draws.step(key);
        long hash = 0;
        for (int k = 0; k < 1_000_000; k++) {
            hash = 31 * hash + Double.doubleToLongBits(Draws.normal(Draws.bits(key, step, k)));
        }
        assertThat(Long.toHexString(hash)).isEqualTo("f84b4ad937e2a389");
    }
}
