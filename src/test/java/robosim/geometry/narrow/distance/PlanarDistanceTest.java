package robosim.geometry.narrow.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.PlanarOverlapTest;
import robosim.geometry.reference.DecimalRoot;

class PlanarDistanceTest {
    private final Scratch scratch = new Scratch();

    private double between(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        double distance = PlanarDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance);
        assertThat(PlanarDistance.between(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0), scratch.distance))
                .as(() -> PlanarOverlapTest.pair(kindA, a, kindB, b) + " swapped")
                .isEqualTo(distance);
        boolean touch = PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
        if (touch) {
            assertThat(distance).isZero();
        }
        return distance;
    }

    /** Down to the least double, whose square is far below it: a corner at (3, 4) and what is about the origin. */
    @Test
    void nothingIsTooSmallToBeApart() {
        Scratch scratch = new Scratch();
        for (int power : new int[] {0, -500, -1000, -1040, -1070}) {
            double unit = Math.scalb(1.0, power);
            double[] point = new double[16];
            double[] corner = {3 * unit, 0, 4 * unit, 6 * unit, 0, 8 * unit, 9 * unit, 0, 4 * unit, 0, 0, 0, 0, 0, 0, 0
            };
            double[] box = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
            double[] small = {unit, 0, 0, 0, 0, 0, 0, 0, unit, 0, 0, 0, 0, 0, 0, 0};
            for (LeafKind kind : new LeafKind[] {LeafKind.SPHERE, LeafKind.UPRIGHT_BOX, LeafKind.BOX}) {
                double[] row = kind == LeafKind.SPHERE ? point : box;
                assertThat(PlanarDistance.between(
                                new Leaf(LeafKind.TRIANGLE, corner, 0), new Leaf(kind, row, 0), scratch.distance))
                        .as("%s at 2^%d", kind, power)
                        .isEqualTo(5 * unit);
            }
            assertThat(PlanarDistance.between(
                            new Leaf(LeafKind.TRIANGLE, corner, 0),
                            new Leaf(LeafKind.TRIANGLE, small, 0),
                            scratch.distance))
                    .as("triangles at 2^%d", power)
                    .isCloseTo(Math.sqrt(18) * unit, within(unit / 2));
        }
    }

    @Test
    void randomPairsAgreeWithTheReference() {
        PlanarRows rows = new PlanarRows(31);
        int apart = 0;
        int count = Effort.cases(3000);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = rows.exactKind();
            LeafKind kindB = rows.exactKind();
            double[] a = rows.row(kindA, 1, 1);
            double[] b = rows.row(kindB, 1, 1);
            double truth = PlanarRows.touch(kindA, a, kindB, b)
                    ? 0
                    : PlanarRows.twin(kindA, a)
                            .gap(PlanarRows.twin(kindB, b))
                            .distance()
                            .head();
            double distance = between(kindA, a, kindB, b);
            assertThat(Math.abs(distance - truth))
                    .as(PlanarOverlapTest.pair(kindA, a, kindB, b))
                    .isLessThan(8 * Math.ulp(2.5));
            apart += truth > 0 ? 1 : 0;
        }
        assertThat(apart).isBetween(count * 3 / 10, count * 7 / 10);
    }

    @Test
    void largeDiscsThatNearlyTouchAreApartByWhatIsLeft() {
        double[] a = new double[Leaf.STRIDE];
        double[] b = new double[Leaf.STRIDE];
        a[3] = 3e9;
        b[0] = 3e9;
        b[2] = 4e9;
        b[3] = Math.nextDown(2e9);
        assertThat(between(LeafKind.SPHERE, a, LeafKind.UPRIGHT_CYLINDER, b)).isEqualTo(Math.ulp(b[3]));
        b[3] = 2e9;
        assertThat(between(LeafKind.SPHERE, a, LeafKind.UPRIGHT_CYLINDER, b)).isZero();
    }

    @Test
    void ovalsAndOctagonsAgreeWithTheirOutlines() {
        PlanarRows rows = new PlanarRows(32);
        int apart = 0;
        int count = Effort.cases(600);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = k % 2 == 0 ? LeafKind.CYLINDER : LeafKind.PRISM;
            LeafKind kindB = Leaves.KINDS[k % 7];
            double[] a = rows.row(kindA, 1.5, 1);
            double[] b = rows.row(kindB, 1.5, 1);
            double truth = Math.max(
                    0,
                    PlanarRows.twin(kindA, a).parted(PlanarRows.twin(kindB, b)).head());
            double distance = between(kindA, a, kindB, b);
            assertThat(distance).as(PlanarOverlapTest.pair(kindA, a, kindB, b)).isCloseTo(truth, within(1e-11));
            apart += truth > 0 ? 1 : 0;
        }
        assertThat(apart).isBetween(count * 3 / 10, count * 8 / 10);
    }

    /** A turned cylinder that stands or lies is a disc or a rectangle: known closed forms. */
    @Test
    void bracketsOfOvalsAreTight() {
        PlanarRows rows = new PlanarRows(33);
        int apart = 0;
        double worst = 0;
        for (int k = 0; k < 1000; k++) {
            double[] standing = rows.row(LeafKind.UPRIGHT_CYLINDER, 1.5, 1);
            double[] lying = standing.clone();
            // own Y along the own X of a heading
            double[] box = rows.row(LeafKind.UPRIGHT_BOX, 0, 1);
            System.arraycopy(standing, 0, box, 0, 3);
            double c = box[6];
            double s = box[8];
            lying[6] = 0;
            lying[9] = -1;
            lying[12] = 0;
            lying[7] = c;
            lying[10] = 0;
            lying[13] = -s;
            lying[8] = s;
            lying[11] = 0;
            lying[14] = c;
            box[3] = lying[4];
            box[5] = lying[3];
            LeafKind kind = rows.exactKind();
            double[] other = rows.row(kind, 1.5, 1);
            double asDisc = between(LeafKind.UPRIGHT_CYLINDER, standing, kind, other);
            double asOval = between(LeafKind.CYLINDER, standing, kind, other);
            double asBox = between(LeafKind.UPRIGHT_BOX, box, kind, other);
            double asLying = between(LeafKind.CYLINDER, lying, kind, other);
            worst = Math.max(worst, Math.max(Math.abs(asDisc - asOval), Math.abs(asBox - asLying)));
            assertThat(asOval).isLessThanOrEqualTo(asDisc + 1e-15);
            assertThat(asLying).isLessThanOrEqualTo(asBox + 1e-15);
            apart += asDisc > 0 ? 1 : 0;
        }
        assertThat(worst).isLessThan(0x1p-43);
        assertThat(apart).isBetween(300, 800);
    }

    /** A large disc close to a box at any heading: as good as the distance, not as the radius. */
    @Test
    void aDiscBesideACornerIsWithinAnUlpOfTheDistance() {
        SplittableRandom random = new SplittableRandom(16);
        double[] box = new double[Leaf.STRIDE];
        double[] disc = new double[Leaf.STRIDE];
        int apart = 0;
        int corners = 0;
        int count = Effort.cases(20_000);
        for (int k = 0; k < count; k++) {
            double heading = random.nextDouble(-3, 3);
            double c = random.nextInt(4) == 0 ? 1 : StrictMath.cos(heading);
            double s = c == 1 ? 0 : StrictMath.sin(heading);
            box[6] = c;
            box[8] = s;
            box[10] = 1;
            box[12] = 0.0 - s;
            box[14] = c;
            box[0] = random.nextDouble(-3, 3);
            box[2] = random.nextDouble(-3, 3);
            box[3] = random.nextDouble(2);
            box[5] = random.nextDouble(2);
            double r = StrictMath.pow(10, random.nextDouble(-3, 8));
            double gap = r * StrictMath.pow(10, random.nextDouble(-13, 1));
            boolean isCorner = random.nextInt(4) != 0;
            double x = isCorner ? 1 : random.nextDouble(-1, 1);
            double along = isCorner ? random.nextDouble(1.57) : 1.5707963267948966;
            double wx = box[3] * x + (r + gap) * StrictMath.cos(along);
            double wz = box[5] + (r + gap) * StrictMath.sin(along);
            disc[0] = box[0] + c * wx + s * wz;
            disc[2] = box[2] - s * wx + c * wz;
            disc[3] = r;
            double truth = cornerDistance(disc, box);
            double distance = PlanarDistance.between(
                    new Leaf(LeafKind.SPHERE, disc, 0), new Leaf(LeafKind.UPRIGHT_BOX, box, 0), scratch.distance);
            assertThat(distance)
                    .as("disc %s, box %s", Arrays.toString(disc), Arrays.toString(box))
                    .isCloseTo(Math.max(0, truth), within(3 * Math.ulp(truth) + 0x1p-98 * r));
            apart += truth > 0 ? 1 : 0;
            corners += isCorner ? 1 : 0;
        }
        assertThat(apart).isBetween(count * 7 / 10, count);
        assertThat(corners).isBetween(count * 7 / 10, count * 8 / 10);
    }

    // To sixty digits, from the stored numbers.
    private static double cornerDistance(double[] disc, double[] box) {
        MathContext digits = new MathContext(60);
        BigDecimal c = new BigDecimal(box[6]);
        BigDecimal s = new BigDecimal(box[8]);
        BigDecimal square = c.multiply(c).add(s.multiply(s));
        BigDecimal dx = new BigDecimal(disc[0]).subtract(new BigDecimal(box[0]));
        BigDecimal dz = new BigDecimal(disc[2]).subtract(new BigDecimal(box[2]));
        BigDecimal x = dx.multiply(c).subtract(dz.multiply(s)).abs();
        BigDecimal z = dx.multiply(s).add(dz.multiply(c)).abs();
        x = x.subtract(new BigDecimal(box[3]).multiply(square)).max(BigDecimal.ZERO);
        z = z.subtract(new BigDecimal(box[5]).multiply(square)).max(BigDecimal.ZERO);
        BigDecimal far = DecimalRoot.of(x.multiply(x).add(z.multiply(z)).divide(square, digits), digits);
        return far.subtract(new BigDecimal(disc[3])).doubleValue();
    }
}
