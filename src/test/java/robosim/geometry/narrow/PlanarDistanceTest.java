package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PlanarDistanceTest {
    private final Scratch scratch = new Scratch();

    private double between(int kindA, double[] a, int kindB, double[] b) {
        double distance = PlanarDistance.between(kindA, a, 0, kindB, b, 0, scratch);
        assertThat(PlanarDistance.between(kindB, b, 0, kindA, a, 0, scratch))
                .as(() -> PlanarOverlapTest.pair(kindA, a, kindB, b) + " swapped")
                .isEqualTo(distance);
        boolean touch = PlanarOverlap.test(kindA, a, 0, kindB, b, 0, scratch);
        if (touch) {
            assertThat(distance).isZero();
        }
        return distance;
    }

    @Test
    void randomPairsAgreeWithTheReference() {
        PlanarRows rows = new PlanarRows(31);
        int apart = 0;
        int count = 3000;
        for (int k = 0; k < count; k++) {
            int kindA = rows.exactKind();
            int kindB = rows.exactKind();
            double[] a = rows.row(kindA, 1, 1);
            double[] b = rows.row(kindB, 1, 1);
            double truth = PlanarReference.distance(PlanarReference.of(kindA, a, 0), PlanarReference.of(kindB, b, 0));
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
        assertThat(between(Leaf.SPHERE, a, Leaf.UPRIGHT_CYLINDER, b)).isEqualTo(Math.ulp(b[3]));
        b[3] = 2e9;
        assertThat(between(Leaf.SPHERE, a, Leaf.UPRIGHT_CYLINDER, b)).isZero();
    }

    @Test
    void ovalsAndOctagonsAgreeWithTheirOutlines() {
        PlanarRows rows = new PlanarRows(32);
        int apart = 0;
        int count = 600;
        for (int k = 0; k < count; k++) {
            int kindA = k % 2 == 0 ? Leaf.CYLINDER : Leaf.PRISM;
            int kindB = k % 7;
            double[] a = rows.row(kindA, 1.5, 1);
            double[] b = rows.row(kindB, 1.5, 1);
            double truth = PlanarSampling.between(PlanarSampling.points(kindA, a), PlanarSampling.points(kindB, b));
            double distance = between(kindA, a, kindB, b);
            boolean curved = PlanarShape.family(kindA) + PlanarShape.family(kindB) != 2 * PlanarShape.POLYGON
                    || kindA == Leaf.CYLINDER;
            assertThat(distance)
                    .as(PlanarOverlapTest.pair(kindA, a, kindB, b))
                    .isBetween(truth - (curved ? 1e-4 : 1e-11), truth + 1e-11);
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
            double[] standing = rows.row(Leaf.UPRIGHT_CYLINDER, 1.5, 1);
            double[] lying = standing.clone();
            // own Y along the own X of a heading
            double[] box = rows.row(Leaf.UPRIGHT_BOX, 0, 1);
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
            int kind = rows.exactKind();
            double[] other = rows.row(kind, 1.5, 1);
            double asDisc = between(Leaf.UPRIGHT_CYLINDER, standing, kind, other);
            double asOval = between(Leaf.CYLINDER, standing, kind, other);
            double asBox = between(Leaf.UPRIGHT_BOX, box, kind, other);
            double asLying = between(Leaf.CYLINDER, lying, kind, other);
            worst = Math.max(worst, Math.max(Math.abs(asDisc - asOval), Math.abs(asBox - asLying)));
            assertThat(asOval).isLessThanOrEqualTo(asDisc + 1e-15);
            assertThat(asLying).isLessThanOrEqualTo(asBox + 1e-15);
            apart += asDisc > 0 ? 1 : 0;
        }
        assertThat(worst).isLessThan(0x1p-43);
        assertThat(apart).isBetween(300, 800);
    }
}
