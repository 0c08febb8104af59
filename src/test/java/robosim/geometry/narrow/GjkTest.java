package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class GjkTest {
    private static final int PAIRS = 400;
    private final Gjk gjk = new Gjk();
    private final Support support = new Support();

    @Test
    void theBracketClosesForAllKindsOfPairs() {
        SplittableRandom random = new SplittableRandom(1);
        for (int kindA = 0; kindA < Leaf.KINDS; kindA++) {
            for (int kindB = 0; kindB < Leaf.KINDS; kindB++) {
                int apart = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 1.5);
                    double[] b = Rows.random(kindB, random, 1.5);
                    double lower = gjk.spatial(kindA, a, 0, kindB, b, 0);
                    String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b)
                            + " steps " + gjk.steps() + " lower " + gjk.lower() + " upper " + gjk.upper();
                    if (gjk.overlapping()) {
                        assertThat(lower).as(pair).isZero();
                        continue;
                    }
                    apart++;
                    assertThat(gjk.upper() - gjk.lower()).as(pair).isLessThan(0x1p-40 * (gjk.upper() + 3));
                    assertThat(gjk.upper()).as(pair).isGreaterThanOrEqualTo(gjk.lower());
                    separates(pair, kindA, a, kindB, b);
                }
                assertThat(apart).as(kindA + " " + kindB).isBetween(PAIRS / 10, PAIRS * 98 / 100);
            }
        }
    }

    /** The slab is empty and the witnesses lie on its sides. */
    private void separates(String pair, int kindA, double[] a, int kindB, double[] b) {
        double nx = gjk.nx();
        double ny = gjk.ny();
        double nz = gjk.nz();
        support.spatial(kindA, a, 0, 0, 0, 0, 1);
        support.find(-nx, -ny, -nz);
        double reachA = nx * support.x + ny * support.y + nz * support.z - support.margin;
        support.spatial(kindB, b, 0, 0, 0, 0, 1);
        support.find(nx, ny, nz);
        double reachB = nx * support.x + ny * support.y + nz * support.z + support.margin;
        assertThat(reachA - reachB).as(pair).isGreaterThanOrEqualTo(gjk.lower());
        assertThat(nx * gjk.ax() + ny * gjk.ay() + nz * gjk.az()).as(pair).isBetween(reachA - 1e-13, reachA + 1e-11);
        assertThat(nx * gjk.bx() + ny * gjk.by() + nz * gjk.bz()).as(pair).isBetween(reachB - 1e-11, reachB + 1e-13);
    }

    @Test
    void stepsAreFew() {
        SplittableRandom random = new SplittableRandom(2);
        int most = 0;
        for (int kindA = 0; kindA < Leaf.KINDS; kindA++) {
            for (int kindB = kindA; kindB < Leaf.KINDS; kindB++) {
                for (int n = 0; n < PAIRS; n++) {
                    gjk.spatial(kindA, Rows.random(kindA, random, 2), 0, kindB, Rows.random(kindB, random, 2), 0);
                    most = Math.max(most, gjk.steps());
                }
            }
        }
        assertThat(most).isBetween(20, 100);
    }

    @Test
    void projectionsAreApartWhereTheirShadowsAre() {
        SplittableRandom random = new SplittableRandom(3);
        for (int kindA = 0; kindA < Leaf.KINDS; kindA++) {
            for (int kindB = 0; kindB < Leaf.KINDS; kindB++) {
                int apart = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 2.5);
                    double[] b = Rows.random(kindB, random, 2.5);
                    gjk.planar(kindA, a, 0, kindB, b, 0);
                    String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
                    assertThat(gjk.ay()).isZero();
                    assertThat(gjk.by()).isZero();
                    if (gjk.overlapping()) {
                        continue;
                    }
                    apart++;
                    double lower = gjk.lower();
                    assertThat(gjk.ny()).as(pair).isZero();
                    assertThat(gjk.upper() - lower).as(pair).isLessThan(0x1p-40 * (gjk.upper() + 3));
                    gjk.spatial(kindA, a, 0, kindB, b, 0);
                    assertThat(gjk.upper()).as(pair).isGreaterThanOrEqualTo(lower);
                }
                assertThat(apart).as(kindA + " " + kindB).isBetween(PAIRS / 10, PAIRS * 98 / 100);
            }
        }
    }

    @Test
    void sizesAndPlacesFarApartKeepTheBracket() {
        SplittableRandom random = new SplittableRandom(4);
        int apart = 0;
        for (int n = 0; n < 4000; n++) {
            int kindA = random.nextInt(Leaf.PRISM);
            int kindB = random.nextInt(Leaf.PRISM);
            double scaleA = Math.scalb(1.0, random.nextInt(-40, 20));
            double scaleB = Math.scalb(1.0, random.nextInt(-40, 20));
            double[] a = scaled(kindA, Rows.random(kindA, random, 1), scaleA);
            double[] b = scaled(kindB, Rows.random(kindB, random, 1), scaleB);
            gjk.spatial(kindA, a, 0, kindB, b, 0);
            String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
            if (!gjk.overlapping()) {
                apart++;
                double size = scaleA + scaleB;
                assertThat(gjk.upper() - gjk.lower()).as(pair).isLessThan(0x1p-40 * (gjk.upper() + 4 * size));
            }
        }
        assertThat(apart).isBetween(400, 3600);
    }

    @Test
    void subnormalSizesAreScaledFirst() {
        double[] a = Rows.box(0, 0, 0, 1e-310, 1e-310, 1e-310, Rows.identity());
        double[] b = Rows.box(5e-310, 0, 0, 1e-310, 1e-310, 1e-310, Rows.identity());
        assertThat(gjk.spatial(Leaf.BOX, a, 0, Leaf.BOX, b, 0)).isBetween(2.999999e-310, 3e-310);
    }

    @Test
    void eitherOrderGivesTheSameBits() {
        SplittableRandom random = new SplittableRandom(5);
        Gjk other = new Gjk();
        for (int n = 0; n < 4000; n++) {
            int kindA = random.nextInt(Leaf.KINDS);
            int kindB = random.nextInt(Leaf.KINDS);
            double[] a = Rows.random(kindA, random, 2);
            double[] b = Rows.random(kindB, random, 2);
            assertThat(gjk.spatial(kindA, a, 0, kindB, b, 0)).isEqualTo(other.spatial(kindB, b, 0, kindA, a, 0));
            assertThat(gjk.nx()).isEqualTo(-other.nx());
            assertThat(gjk.ax()).isEqualTo(other.bx());
        }
    }

    private static double[] scaled(int kind, double[] row, double scale) {
        int numbers = kind == Leaf.TRIANGLE ? 9 : 6;
        for (int k = 0; k < numbers; k++) {
            row[k] *= scale;
        }
        return row;
    }
}
