package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.SpatialOverlap;

class MovingPrismTest {
    private static final MathContext DIGITS = new MathContext(60);

    /** How early a contact may be, as a share of its time. */
    private static final BigDecimal EARLY = new BigDecimal(0x1p-49);

    private static final BigDecimal LEAST = new BigDecimal(4 * Double.MIN_VALUE);

    @Test
    void compareWithSlabsInDecimals() {
        SplittableRandom random = new SplittableRandom(3);
        int[] counts = new int[4];
        for (int k = 0; k < Effort.cases(100_000); k++) {
            boolean planar = random.nextBoolean();
            boolean isCoarse = random.nextInt(3) == 0;
            double[] a = prism(random, isCoarse);
            double[] b = prism(random, isCoarse);
            double[] d = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                d[axis] = isCoarse ? random.nextInt(-3, 4) : random.nextDouble(-4, 4);
            }
            if (isCoarse) {
                int number = random.nextInt(10);
                a[number] += random.nextInt(-2, 3) * 0x1p-51;
            }
            double time = MovingPrism.time(planar, prism(a), d[0], d[1], d[2], prism(b));
            Supplier<String> pair = () ->
                    (planar ? "planar " : "spatial ") + Arrays.toString(a) + Arrays.toString(b) + Arrays.toString(d);
            BigDecimal[] span = span(planar, a, b, d);
            if (touch(planar, a, b)) {
                counts[0]++;
                assertThat(time).as(pair).isIn(0.0, Double.POSITIVE_INFINITY);
                boolean isParting = span[1].signum() < 0;
                assertThat(isParting && time == 0).as(pair).isFalse();
            } else if (span[0].compareTo(BigDecimal.ONE) > 0 || span[0].compareTo(span[1]) > 0) {
                BigDecimal wide = span[1].multiply(BigDecimal.ONE.add(EARLY));
                boolean isNear =
                        span[0].multiply(BigDecimal.ONE.subtract(EARLY)).compareTo(wide.min(BigDecimal.ONE)) <= 0;
                counts[isNear ? 1 : 2]++;
                assertThat(time == Double.POSITIVE_INFINITY || isNear).as(pair).isTrue();
            } else {
                counts[3]++;
                assertThat(new BigDecimal(time)).as(pair).isLessThanOrEqualTo(span[0]);
                assertThat(new BigDecimal(time))
                        .as(pair)
                        .isGreaterThanOrEqualTo(
                                span[0].subtract(span[0].multiply(EARLY)).subtract(LEAST));
            }
        }
        assertThat(counts[0]).isGreaterThan(Effort.cases(10_000));
        assertThat(counts[1]).isGreaterThan(Effort.cases(30));
        assertThat(counts[2]).isGreaterThan(Effort.cases(10_000));
        assertThat(counts[3]).isGreaterThan(Effort.cases(5_000));
    }

    /** From the latest time at which a gap closes to the earliest at which one opens, from the rows' numbers alone. */
    private static BigDecimal[] span(boolean planar, double[] a, double[] b, double[] d) {
        BigDecimal enter = new BigDecimal("-1e9");
        BigDecimal leave = new BigDecimal("1e9");
        BigDecimal[] speeds = {
            new BigDecimal(d[0]),
            new BigDecimal(d[2]),
            new BigDecimal(d[0]).add(new BigDecimal(d[2])),
            new BigDecimal(d[0]).subtract(new BigDecimal(d[2])),
            new BigDecimal(d[1])
        };
        for (int k = 0; k < (planar ? 4 : 5); k++) {
            BigDecimal toEnter = minus(b[2 * k], a[2 * k + 1]);
            BigDecimal toLeave = minus(b[2 * k + 1], a[2 * k]);
            if (speeds[k].signum() == 0) {
                if (toEnter.signum() > 0 || toLeave.signum() < 0) {
                    enter = new BigDecimal("1e9");
                }
                continue;
            }
            BigDecimal one = toEnter.divide(speeds[k], DIGITS);
            BigDecimal two = toLeave.divide(speeds[k], DIGITS);
            enter = enter.max(one.min(two));
            leave = leave.min(one.max(two));
        }
        return new BigDecimal[] {leave.signum() < 0 ? new BigDecimal("1e9") : enter, leave};
    }

    private static boolean touch(boolean planar, double[] a, double[] b) {
        for (int k = 0; k < (planar ? 8 : 10); k += 2) {
            if (minus(a[k], b[k + 1]).signum() > 0 || minus(b[k], a[k + 1]).signum() > 0) {
                return false;
            }
        }
        return true;
    }

    private static BigDecimal minus(double p, double q) {
        return new BigDecimal(p).subtract(new BigDecimal(q));
    }

    private static double[] prism(SplittableRandom random, boolean isCoarse) {
        double[] row = new double[Leaf.STRIDE];
        double x = isCoarse ? random.nextInt(-4, 5) : random.nextDouble(-4, 4);
        double y = isCoarse ? random.nextInt(-2, 3) : random.nextDouble(-2, 2);
        double z = isCoarse ? random.nextInt(-4, 5) : random.nextDouble(-4, 4);
        double[] middles = {x, z, x + z, x - z, y};
        for (int k = 0; k < 5; k++) {
            double half = isCoarse ? random.nextInt(1, 3) : random.nextDouble(0.5, 1.5);
            row[2 * k] = middles[k] - half;
            row[2 * k + 1] = middles[k] + half;
        }
        return row;
    }

    @Test
    void motionFromContactIsBlockedOnlyAgainstEveryShortestWayOut() {
        double[] wall = {0, 2, 0, 2, 0, 4, -2, 2, 0, 2};
        double[] flush = {2, 3, 0, 2, 2, 5, 0, 3, 0, 2};
        double[] corner = {1.5, 3, 1.5, 3, 3, 6, -1.5, 1.5, 0, 2};
        assertThat(MovingPrism.time(false, prism(flush), -1, 0, 0, prism(wall))).isZero();
        assertThat(MovingPrism.time(false, prism(flush), 0, 0, 1, prism(wall))).isInfinite();
        assertThat(MovingPrism.time(false, prism(flush), 1, 0, 0, prism(wall))).isInfinite();
        assertThat(MovingPrism.time(false, prism(flush), 0, 0, 0, prism(wall))).isInfinite();
        // As deep along x as along z: free along either way out, blocked against both.
        assertThat(MovingPrism.time(true, prism(corner), 1, 0, -1, prism(wall))).isInfinite();
        assertThat(MovingPrism.time(true, prism(corner), -1, 0, 1, prism(wall))).isInfinite();
        assertThat(MovingPrism.time(true, prism(corner), -1, 0, -1, prism(wall)))
                .isZero();
    }

    @Test
    void whatItAllowsTheOverlapFindsApart() {
        SplittableRandom random = new SplittableRandom(4);
        Scratch s = new Scratch();
        int free = 0;
        for (int k = 0; k < 20_000; k++) {
            double[] a = prism(random, true);
            double[] b = prism(random, true);
            double dx = random.nextInt(-3, 4);
            double dy = random.nextInt(-3, 4);
            double dz = random.nextInt(-3, 4);
            if (!touch(false, a, b)
                    && SpatialSweep.translation(
                                    new Leaf(LeafKind.PRISM, a, 0), dx, dy, dz, new Leaf(LeafKind.PRISM, b, 0), s.sweep)
                            > 1) {
                free++;
                double[] shifts = {dx, dx, dz, dz, dx + dz, dx + dz, dx - dz, dx - dz, dy, dy};
                for (int m = 0; m < 10; m++) {
                    a[m] += shifts[m];
                }
                assertThat(SpatialOverlap.test(
                                new Leaf(LeafKind.PRISM, a, 0), new Leaf(LeafKind.PRISM, b, 0), s.overlap))
                        .isFalse();
            }
        }
        assertThat(free).isBetween(5_000, 19_000);
    }

    private static Leaf prism(double[] row) {
        return new Leaf(LeafKind.PRISM, row, 0);
    }
}
