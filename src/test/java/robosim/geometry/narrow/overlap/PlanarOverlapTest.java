package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

public class PlanarOverlapTest {
    private final Scratch scratch = new Scratch();

    private boolean test(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        boolean verdict = PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
        assertThat(PlanarOverlap.test(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0), scratch.overlap))
                .as(() -> pair(kindA, a, kindB, b) + " swapped")
                .isEqualTo(verdict);
        return verdict;
    }

    private boolean checked(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        boolean truth = PlanarRows.touch(kindA, a, kindB, b);
        assertThat(test(kindA, a, kindB, b)).as(() -> pair(kindA, a, kindB, b)).isEqualTo(truth);
        return truth;
    }

    public static String pair(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        return "kind %s %s, kind %s %s".formatted(kindA, Arrays.toString(a), kindB, Arrays.toString(b));
    }

    @Test
    void ofNoSizeAndInOnePlaceAllTouch() {
        double[][] rows = new double[5][];
        PlanarRows make = new PlanarRows(4);
        for (int k = 0; k < 5; k++) {
            rows[k] = make.row(PlanarRows.EXACT_KINDS[k], 1, 1);
            int corners = PlanarRows.EXACT_KINDS[k] == LeafKind.TRIANGLE ? 9 : 3;
            for (int n = 0; n < corners; n++) {
                rows[k][n] = 0.1 * (n % 3);
            }
            for (int n = corners; n < 6; n++) {
                rows[k][n] = 0;
            }
        }
        for (int k = 0; k < 5; k++) {
            for (int m = 0; m < 5; m++) {
                LeafKind kindA = PlanarRows.EXACT_KINDS[k];
                LeafKind kindB = PlanarRows.EXACT_KINDS[m];
                assertThat(checked(kindA, rows[k], kindB, rows[m])).isTrue();
                double[] moved = PlanarRows.moved(kindB, rows[m], 0, 0x1p-54);
                assertThat(checked(kindA, rows[k], kindB, moved)).isFalse();
            }
        }
    }

    @Test
    void subnormalAndHugeNumbersAreDecidedExactly() {
        PlanarRows rows = new PlanarRows(5);
        int hits = 0;
        int count = 0;
        for (int exponent : new int[] {-1060, -1000, -540, -300, 90, 97}) {
            for (int k = 0; k < 60; k++) {
                LeafKind kindA = rows.exactKind();
                LeafKind kindB = rows.exactKind();
                double factor = Math.scalb(1.0, exponent);
                double[] a = PlanarRows.scaled(kindA, rows.gridRow(kindA), factor);
                double[] b = PlanarRows.scaled(kindB, rows.gridRow(kindB), factor);
                hits += checked(kindA, a, kindB, b) ? 1 : 0;
                count++;
            }
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    /** An upright box whose axes are square only to 1e-9, as a caller may give them. */
    @Test
    void skewedBoxesAreTheParallelogramsThatTheyAre() {
        PlanarRows rows = new PlanarRows(6);
        int hits = 0;
        int count = Effort.cases(1000);
        for (int k = 0; k < count; k++) {
            LeafKind kind = rows.exactKind();
            double[] a = rows.row(LeafKind.UPRIGHT_BOX, 1, 1);
            a[6] *= 1 + 5e-10;
            a[12] += 4e-10;
            double[] b = rows.row(kind, 1, 1);
            hits += checked(LeafKind.UPRIGHT_BOX, a, kind, b) ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 7 / 10);
    }

    @Test
    void octagonsAndOvalsAreCertified() {
        PlanarRows rows = new PlanarRows(7);
        LeafKind[] kinds = Leaves.KINDS;
        int hits = 0;
        int count = Effort.cases(1000);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = k % 2 == 0 ? LeafKind.CYLINDER : LeafKind.PRISM;
            LeafKind kindB = kinds[rows.random().nextInt(kinds.length)];
            double[] a = rows.row(kindA, 1, 1);
            double[] b = rows.row(kindB, 1, 1);
            boolean verdict = test(kindA, a, kindB, b);
            double gap =
                    PlanarRows.twin(kindA, a).parted(PlanarRows.twin(kindB, b)).head();
            if (gap > 1e-12) {
                assertThat(verdict).as(pair(kindA, a, kindB, b)).isFalse();
            } else if (gap < -1e-12) {
                assertThat(verdict).as(pair(kindA, a, kindB, b)).isTrue();
            }
            hits += verdict ? 1 : 0;
        }
        assertThat(hits).isBetween(count * 3 / 10, count * 8 / 10);
    }

    private static double[] disc(double x, double z, double r) {
        double[] row = new double[Leaf.STRIDE];
        row[0] = x;
        row[2] = z;
        row[3] = r;
        return row;
    }

    /** A pair that a world told apart by its bounds and together without a look at them: octagons are in no doubt. */
    @Test
    void octagonsAreApartWhereOneOfTheirDirectionsPartsThem() {
        double[] still = {
            -2.0000000000001705,
            1.7053025658242404E-13,
            -3.0000000000001705,
            -0.9999999999998295,
            -4.414213562373277,
            -1.5857864376267226,
            -0.41421356237327744,
            2.4142135623732774,
            -3.0000000000001705,
            -0.9999999999998295,
            0,
            0,
            0,
            0,
            0,
            0
        };
        double[] other = {
            2.48694250966913E-13,
            1.000000000000584,
            -5.085786437626606,
            -2.0857864376262136,
            -5.085786437626203,
            -1.0857864376257826,
            2.085786437626616,
            6.0857864376270365,
            -2.8125000000001354,
            0.18750000000025646,
            0,
            0,
            0,
            0,
            0,
            0
        };
        Scratch s = new Scratch();
        assertThat(PlanarOverlap.test(
                        new Leaf(LeafKind.PRISM, still, 0), new Leaf(LeafKind.PRISM, other, 0), s.overlap))
                .isFalse();
        assertThat(PlanarOverlap.test(
                        new Leaf(LeafKind.PRISM, other, 0), new Leaf(LeafKind.PRISM, still, 0), s.overlap))
                .isFalse();
        assertThat(PlanarDistance.between(
                        new Leaf(LeafKind.PRISM, other, 0), new Leaf(LeafKind.PRISM, still, 0), s.distance))
                .isBetween(0.0, 1e-12);
        still[1] = other[0];
        assertThat(PlanarOverlap.test(
                        new Leaf(LeafKind.PRISM, still, 0), new Leaf(LeafKind.PRISM, other, 0), s.overlap))
                .isTrue();
        assertThat(PlanarDistance.between(
                        new Leaf(LeafKind.PRISM, other, 0), new Leaf(LeafKind.PRISM, still, 0), s.distance))
                .isZero();
    }
}
