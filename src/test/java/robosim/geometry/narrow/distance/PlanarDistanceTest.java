package robosim.geometry.narrow.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.PlanarOverlapTest;

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
}
