package robosim.geometry.narrow.gjk;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.narrow.CylinderTwin;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.SupportTwin;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

class GjkTest {
    private static final int PAIRS = 400;
    private final Gjk gjk = new Gjk();
    private final Support support = new Support();

    @Test
    void theBracketClosesForAllKindsOfPairs() {
        SplittableRandom random = new SplittableRandom(1);
        for (LeafKind kindA : Leaves.KINDS) {
            for (LeafKind kindB : Leaves.KINDS) {
                int apart = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 1.5);
                    double[] b = Rows.random(kindB, random, 1.5);
                    double lower = gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
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
    private void separates(String pair, LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
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
        for (LeafKind kindA : Leaves.KINDS) {
            for (LeafKind kindB : Leaves.KINDS) {
                for (int n = 0; n < PAIRS; n++) {
                    gjk.spatial(
                            new Leaf(kindA, Rows.random(kindA, random, 2), 0),
                            new Leaf(kindB, Rows.random(kindB, random, 2), 0));
                    most = Math.max(most, gjk.steps());
                }
            }
        }
        assertThat(most).isBetween(10, 20);
    }

    /** Where the nearest points have a closed form, they and the slab between them end the query; unless it cancels. */
    @ParameterizedTest
    @CsvSource({"CAPSULE, CAPSULE", "CAPSULE, SPHERE", "SPHERE, BOX", "UPRIGHT_BOX, SPHERE"})
    void closedFormsEndTheQuery(LeafKind kindA, LeafKind kindB) {
        SplittableRandom random = new SplittableRandom(7);
        int apart = 0;
        int atOnce = 0;
        for (int n = 0; n < 2000; n++) {
            double[] a = Rows.random(kindA, random, 1.5);
            double[] b = Rows.random(kindB, random, 1.5);
            gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
            if (gjk.lower() > 0) {
                String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
                apart++;
                atOnce += gjk.steps() == 1 ? 1 : 0;
                assertThat(gjk.upper() - gjk.lower()).as(pair).isBetween(0.0, 4 * gjk.error());
                separates(pair, kindA, a, kindB, b);
            }
        }
        assertThat(apart).isBetween(500, 1900);
        assertThat(atOnce).isGreaterThan(apart * 98 / 100);
    }

    @Test
    void projectionsAreApartWhereTheirShadowsAre() {
        SplittableRandom random = new SplittableRandom(3);
        for (LeafKind kindA : Leaves.KINDS) {
            for (LeafKind kindB : Leaves.KINDS) {
                int apart = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 2.5);
                    double[] b = Rows.random(kindB, random, 2.5);
                    gjk.planar(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
                    String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
                    assertThat(gjk.ay()).isZero();
                    assertThat(gjk.by()).isZero();
                    assertThat(gjk.ny()).as(pair).isZero();
                    if (gjk.overlapping()) {
                        continue;
                    }
                    apart++;
                    double lower = gjk.lower();
                    assertThat(gjk.upper() - lower).as(pair).isLessThan(0x1p-40 * (gjk.upper() + 3));
                    gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
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
            LeafKind kindA = Leaves.KINDS[random.nextInt(LeafKind.PRISM.ordinal())];
            LeafKind kindB = Leaves.KINDS[random.nextInt(LeafKind.PRISM.ordinal())];
            double scaleA = Math.scalb(1.0, random.nextInt(-40, 20));
            double scaleB = Math.scalb(1.0, random.nextInt(-40, 20));
            double[] a = scaled(kindA, Rows.random(kindA, random, 1), scaleA);
            double[] b = scaled(kindB, Rows.random(kindB, random, 1), scaleB);
            gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
            String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
            if (!gjk.overlapping()) {
                apart++;
                double size = scaleA + scaleB;
                assertThat(gjk.upper() - gjk.lower()).as(pair).isLessThan(0x1p-40 * (gjk.upper() + 4 * size));
            }
        }
        assertThat(apart).isBetween(400, 3600);
    }

    /**
     * A positive lower end is a proof: along the direction told the exact slab is as wide, for all kinds, within last bits of
     * contact and far from the origin.
     */
    @Test
    void theLowerEndIsTheWidthOfAnExactSlab() {
        SplittableRandom random = new SplittableRandom(6);
        int apart = 0;
        int close = 0;
        int count = 8_000;
        for (int n = 0; n < count; n++) {
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            double[] a = Rows.random(kindA, random, 1);
            double[] b = Rows.random(kindB, random, 1);
            if (random.nextInt(4) == 0) {
                shift(kindA, a, 1e3, -1e3, 1e3);
                shift(kindB, b, 1e3, -1e3, 1e3);
            }
            if (random.nextInt(4) > 0) {
                // Back along the slab, to within some last bits of contact.
                gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
                double back = gjk.reach() + random.nextInt(-40, 41) * gjk.error() / 16;
                shift(kindB, b, back * gjk.nx(), back * gjk.ny(), back * gjk.nz());
            }
            gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
            String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
            assertThat(roundoff(kindA, a, kindB, b)).as(pair).isLessThanOrEqualTo(1);
            if (gjk.lower() > 0) {
                assertThat(new BigDecimal(gjk.lower())).as(pair).isLessThanOrEqualTo(exactSlab(kindA, a, kindB, b));
                apart++;
                close += gjk.lower() < 64 * gjk.error() ? 1 : 0;
            }
        }
        assertThat(apart).isBetween(count / 5, count * 9 / 10);
        assertThat(close).isGreaterThan(count / 10);
    }

    // How much too wide rounding made the slab of a question, as a share of what is allowed for it.
    private double roundoff(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
        BigDecimal over = new BigDecimal(gjk.reach()).subtract(exactSlab(kindA, a, kindB, b));
        return over.doubleValue() / gjk.error();
    }

    private BigDecimal exactSlab(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        BigDecimal[] n = CylinderTwin.decimals(gjk.nx(), gjk.ny(), gjk.nz());
        return new SupportTwin(kindA, a).gap(new SupportTwin(kindB, b), n);
    }

    /** The quotas is not idle: found by climbing, rounding takes up more than a tenth of it. */
    @Test
    void aTenthOfTheRoundoffIsTooLittle() {
        double[] sphere =
                Rows.sphere(-0.4564606690476848, 0.17918489873570204, 0.9459578928290403, 0.07659840744679258);
        double[] box = {
            0.9408362819196328,
            -0.6487259072260412,
            -0.5600030507181311,
            0.281671697629819,
            0.36803967273088817,
            0.3392522892388996,
            -0.3485166533108847,
            -0.19703007826135857,
            0.9163598041300721,
            -0.7956828372419106,
            0.5789247592167142,
            -0.17814304837554962,
            -0.49540384019872585,
            -0.7912175879151023,
            -0.3585383712940125,
            0
        };
        assertThat(roundoff(LeafKind.SPHERE, sphere, LeafKind.BOX, box)).isBetween(0.1, 1.0);
    }

    /** An axis so nearly upright that the squares of what is aside underflow: no point beyond the rim is taken for one of it. */
    @Test
    void aHairFromUprightTheRimIsWhereItIs() {
        for (int power = -545; power <= -500; power++) {
            for (double share : new double[] {1, 1.3, 1.7}) {
                double tilt = share * Math.scalb(1.0, power);
                double[] r = {1, tilt, 0, -tilt, 1, 0, 0, 0, 1};
                double[] row = Rows.cylinder(0, 0, 0, 1, 1, r);
                support.spatial(LeafKind.CYLINDER, row, 0, 0, 0, 0, 1);
                support.find(0, 1, 0);
                assertThat(Math.hypot(support.x, support.z)).as("2^%d", power).isLessThanOrEqualTo(1 + 0x1p-50);
                assertThat(support.y).isEqualTo(1);
            }
        }
    }

    private static void shift(LeafKind kind, double[] row, double x, double y, double z) {
        if (kind == LeafKind.PRISM) {
            double[] by = {x, x, z, z, x + z, x + z, x - z, x - z, y, y};
            for (int k = 0; k < 10; k++) {
                row[k] += by[k];
            }
            return;
        }
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k += 3) {
            row[k] += x;
            row[k + 1] += y;
            row[k + 2] += z;
        }
    }

    @Test
    void subnormalSizesAreScaledFirst() {
        double[] a = Rows.box(0, 0, 0, 1e-310, 1e-310, 1e-310, Rows.identity());
        double[] b = Rows.box(5e-310, 0, 0, 1e-310, 1e-310, 1e-310, Rows.identity());
        assertThat(gjk.spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isBetween(2.999999e-310, 3e-310);
    }

    @Test
    void eitherOrderGivesTheSameBits() {
        SplittableRandom random = new SplittableRandom(5);
        Gjk other = new Gjk();
        for (int n = 0; n < 4000; n++) {
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            double[] a = Rows.random(kindA, random, 2);
            double[] b = Rows.random(kindB, random, 2);
            assertThat(gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0)))
                    .isEqualTo(other.spatial(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0)));
            assertThat(gjk.nx()).isEqualTo(-other.nx());
            assertThat(gjk.ax()).isEqualTo(other.bx());
        }
    }

    private static double[] scaled(LeafKind kind, double[] row, double scale) {
        int numbers = kind == LeafKind.TRIANGLE ? 9 : 6;
        for (int k = 0; k < numbers; k++) {
            row[k] *= scale;
        }
        return row;
    }
}
