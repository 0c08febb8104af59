package robosim.geometry.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.exact.Samples.big;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.IntSupplier;
import org.junit.jupiter.api.Test;

class OrientationTest {
    private final int[] signs = new int[3];
    private int quick;
    private int expanded;
    private int dyadic;

    @Test
    void sidesAreThoseOfTheDecimals() {
        SplittableRandom random = new SplittableRandom(11);
        int count = 12_000;
        double[] p = new double[6];
        for (int i = 0; i < count; i++) {
            planar(random, i % 6, p);
            String sample = Arrays.toString(p);
            int truth = side(p);
            assertThat(Orientation.side(p[0], p[1], p[2], p[3], p[4], p[5]))
                    .as(sample)
                    .isEqualTo(truth);
            assertThat(Orientation.side(p[2], p[3], p[0], p[1], p[4], p[5]))
                    .as(sample + " swapped")
                    .isEqualTo(-truth);
            assertThat(Orientation.dyadicSide(p[0], p[1], p[2], p[3], p[4], p[5]))
                    .as(sample)
                    .isEqualTo(truth);
            assertStages(
                    p,
                    2,
                    truth,
                    Orientation.quickSide(p[0], p[1], p[2], p[3], p[4], p[5]),
                    () -> Orientation.expandedSide(p[0], p[1], p[2], p[3], p[4], p[5]));
        }
        assertMixed(count);
    }

    @Test
    void volumesAreThoseOfTheDecimals() {
        SplittableRandom random = new SplittableRandom(12);
        int count = 6_000;
        double[] p = new double[12];
        for (int i = 0; i < count; i++) {
            spatial(random, i % 5, p);
            int truth = volume(p);
            assertThat(Orientation.volume(p, p[9], p[10], p[11]))
                    .as(Arrays.toString(p))
                    .isEqualTo(truth);
            assertStages(
                    p,
                    3,
                    truth,
                    Orientation.quickVolume(p, p[9], p[10], p[11]),
                    () -> Orientation.expandedVolume(p, p[9], p[10], p[11]));
        }
        assertMixed(count);
    }

    /** Each stage that decides is right; counts which has to. */
    private void assertStages(double[] p, int factors, int truth, int first, IntSupplier expansion) {
        String sample = Arrays.toString(p);
        boolean fits = Arrays.stream(p).allMatch(x -> Expansion.fits(x, factors));
        if (first != 0) {
            assertThat(first).as(sample).isEqualTo(truth);
            quick++;
        } else if (fits) {
            expanded++;
        } else {
            dyadic++;
        }
        if (fits) {
            assertThat(expansion.getAsInt()).as(sample).isEqualTo(truth);
        }
        signs[1 + truth]++;
    }

    private void assertMixed(int count) {
        assertThat(Arrays.stream(signs).min().orElse(0)).isGreaterThan(count / 20);
        assertThat(quick).isGreaterThan(count / 5);
        assertThat(expanded).isGreaterThan(count / 20);
        assertThat(dyadic).isGreaterThan(count / 20);
    }

    @Test
    void theFilterDecidesAlmostEverythingOrdinary() {
        SplittableRandom random = new SplittableRandom(13);
        int doubtful = 0;
        for (int i = 0; i < 100_000; i++) {
            doubtful += Orientation.quickSide(
                                    Samples.ordinary(random),
                                    Samples.ordinary(random),
                                    Samples.ordinary(random),
                                    Samples.ordinary(random),
                                    Samples.ordinary(random),
                                    Samples.ordinary(random))
                            == 0
                    ? 1
                    : 0;
        }
        assertThat(doubtful).isZero();
    }

    @Test
    void productsCompareExactly() {
        SplittableRandom random = new SplittableRandom(14);
        int ties = 0;
        for (int i = 0; i < 20_000; i++) {
            boolean wild = random.nextInt(3) == 0;
            double a = wild ? Samples.any(random) : Samples.ordinary(random);
            double b = wild ? Samples.any(random) : Samples.ordinary(random);
            double c = random.nextBoolean() ? b : Samples.near(a, random);
            double d = random.nextBoolean() ? a : Samples.near(b, random);
            if (!Double.isFinite(c) || !Double.isFinite(d)) {
                continue;
            }
            int truth = big(a).multiply(big(b)).compareTo(big(c).multiply(big(d)));
            assertThat(Orientation.compareProducts(a, b, c, d))
                    .as("%s %s %s %s", a, b, c, d)
                    .isEqualTo(truth);
            ties += a * b == c * d && truth != 0 ? 1 : 0;
        }
        assertThat(ties).isGreaterThan(500);
    }

    @Test
    void signsAreThoseOfTheDrawing() {
        assertThat(Orientation.side(0, 0, 1, 0, 0, 1)).isEqualTo(1);
        assertThat(Orientation.side(0, 0, 1, 0, 0, -1)).isEqualTo(-1);
        assertThat(Orientation.side(0, 0, 1, 1, 3, 3)).isZero();
        assertThat(Orientation.side(-0.0, 0, 0, 0, 5, 7)).isZero();
        assertThat(Orientation.volume(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, 0, 0, 1))
                .isEqualTo(1);
        assertThat(Orientation.volume(new double[] {0, 0, 0, 0, 1, 0, 1, 0, 0}, 0, 0, 1))
                .isEqualTo(-1);
    }

    private static void planar(SplittableRandom random, int family, double[] p) {
        for (int i = 0; i < p.length; i++) {
            p[i] = family == 0 ? Samples.any(random) : Samples.ordinary(random);
        }
        switch (family) {
            case 2 -> { // nearly on the line
                double t = random.nextDouble(-2, 3);
                p[4] = p[0] + t * (p[2] - p[0]);
                p[5] = p[1] + t * (p[3] - p[1]);
            }
            case 3 -> { // exactly on it, or an ulp beside
                onGrid(random, p);
                p[4] = random.nextBoolean() ? p[4] : Samples.near(p[4], random);
            }
            case 4 -> { // the same, too large or too small for products of doubles
                onGrid(random, p);
                double[] scales = {0x1p900, 0x1p-1060, 0x1p-539, 0x1p-541};
                scale(p, scales[random.nextInt(4)]);
            }
            case 5 -> { // mixed magnitudes
                onGrid(random, p);
                scale(p, 0x1p-1060);
                int at = random.nextInt(6);
                p[at] = random.nextBoolean() ? p[at] : Samples.ordinary(random);
            }
            default -> {}
        }
    }

    private static void onGrid(SplittableRandom random, double[] p) {
        double ux = random.nextInt(-9, 10);
        double uz = random.nextInt(-9, 10);
        p[0] = random.nextInt(-99, 100);
        p[1] = random.nextInt(-99, 100);
        int far = random.nextInt(-9, 10);
        int at = random.nextInt(-9, 10);
        p[2] = p[0] + far * ux;
        p[3] = p[1] + far * uz;
        p[4] = p[0] + at * ux;
        p[5] = p[1] + at * uz + (random.nextInt(3) == 0 ? random.nextInt(-1, 2) : 0);
    }

    private static void spatial(SplittableRandom random, int family, double[] p) {
        for (int i = 0; i < p.length; i++) {
            p[i] = family == 0 ? Samples.any(random) : Samples.ordinary(random);
        }
        if (family < 2) {
            return;
        }
        if (family == 2) { // nearly in the plane
            double s = random.nextDouble(-2, 2);
            double t = random.nextDouble(-2, 2);
            for (int i = 0; i < 3; i++) {
                p[9 + i] = p[i] + s * (p[3 + i] - p[i]) + t * (p[6 + i] - p[i]);
            }
            return;
        }
        int s = random.nextInt(-9, 10);
        int t = random.nextInt(-9, 10);
        for (int i = 0; i < 3; i++) {
            p[i] = random.nextInt(-99, 100);
            p[3 + i] = p[i] + random.nextInt(-9, 10);
            p[6 + i] = p[i] + random.nextInt(-9, 10);
            p[9 + i] = p[i] + s * (p[3 + i] - p[i]) + t * (p[6 + i] - p[i]);
        }
        int at = random.nextInt(12);
        p[at] = random.nextBoolean() ? p[at] : Samples.near(p[at], random);
        if (family == 4) {
            double[] scales = {0x1p800, 0x1p-1020, 0x1p-360, 0x1p-362};
            scale(p, scales[random.nextInt(4)]);
        }
    }

    private static void scale(double[] p, double factor) {
        for (int i = 0; i < p.length; i++) {
            p[i] *= factor;
        }
    }

    private static int side(double[] p) {
        return big(p[2])
                .subtract(big(p[0]))
                .multiply(big(p[5]).subtract(big(p[1])))
                .compareTo(big(p[3]).subtract(big(p[1])).multiply(big(p[4]).subtract(big(p[0]))));
    }

    private static int volume(double[] p) {
        BigDecimal[] u = new BigDecimal[9];
        for (int i = 0; i < 9; i++) {
            u[i] = big(p[3 + i]).subtract(big(p[i % 3]));
        }
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            BigDecimal minor = u[3 + j].multiply(u[6 + k]).subtract(u[3 + k].multiply(u[6 + j]));
            sum = sum.add(u[i].multiply(minor));
        }
        return sum.signum();
    }
}
