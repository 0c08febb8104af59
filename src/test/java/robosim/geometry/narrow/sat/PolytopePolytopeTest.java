package robosim.geometry.narrow.sat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.distance.SpatialDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.SpatialOverlap;

class PolytopePolytopeTest {
    private static final LeafKind[] KINDS = {LeafKind.BOX, LeafKind.UPRIGHT_BOX, LeafKind.TRIANGLE};
    private final Scratch scratch = new Scratch();
    private final PolytopePolytope polytopes = new PolytopePolytope();
    private static final StageCounters.Counter EXACT = StageCounters.counter("PolytopePolytope");

    /** The count when this test began. */
    private final long before = EXACT.total();

    private int hits;
    private int asked;

    @Test
    void randomPairsAgreeWithDecimalsAndSeldomNeedThem() {
        SplittableRandom random = new SplittableRandom(11);
        for (int n = 0; n < 80; n++) {
            for (LeafKind kindA : KINDS) {
                for (LeafKind kindB : KINDS) {
                    agree(kindA, Rows.random(kindA, random, 1), kindB, Rows.random(kindB, random, 1));
                }
            }
        }
        assertThat(hits).isBetween(asked * 3 / 10, asked * 8 / 10);
        assertThat(EXACT.total() - before).isZero();
    }

    /** Coordinates of few bits: corners on corners, edges on edges, coplanar sides, segments and points. */
    @Test
    void coarseNumbersTouchInEveryWay() {
        SplittableRandom random = new SplittableRandom(12);
        for (int n = 0; n < 1500; n++) {
            LeafKind kindA = KINDS[random.nextInt(3)];
            LeafKind kindB = KINDS[random.nextInt(3)];
            agree(kindA, coarse(kindA, random), kindB, coarse(kindB, random));
        }
        assertThat(hits).isBetween(asked * 3 / 10, asked * 8 / 10);
        assertThat(EXACT.total() - before).isGreaterThan(asked / 10);
    }

    /** A corner of one box put exactly on a corner of the other, and then an ulp off in each direction. */
    @Test
    void oneUlpDecides() {
        SplittableRandom random = new SplittableRandom(13);
        for (int n = 0; n < 60; n++) {
            double[] a = coarseTurned(random);
            double[] b = coarseTurned(random);
            for (int axis = 0; axis < 3; axis++) {
                b[axis] = a[axis];
                for (int k = 0; k < 3; k++) {
                    b[axis] += a[3 + k] * a[6 + 3 * axis + k] + b[3 + k] * b[6 + 3 * axis + k];
                }
            }
            agree(LeafKind.BOX, a, LeafKind.BOX, b);
            for (int axis = 0; axis < 3; axis++) {
                double exact = b[axis];
                b[axis] = Math.nextUp(exact);
                agree(LeafKind.BOX, a, LeafKind.BOX, b);
                b[axis] = Math.nextDown(exact);
                agree(LeafKind.BOX, a, LeafKind.BOX, b);
                b[axis] = exact;
            }
        }
        assertThat(hits).isBetween(asked * 3 / 10, asked * 9 / 10);
    }

    @Test
    void scalesByPowersOfTwoChangeNothing() {
        SplittableRandom random = new SplittableRandom(14);
        for (int n = 0; n < 200; n++) {
            double[] a = coarse(LeafKind.TRIANGLE, random);
            double[] b = coarse(LeafKind.TRIANGLE, random);
            boolean truth = SpatialOverlap.test(
                    new Leaf(LeafKind.TRIANGLE, a, 0), new Leaf(LeafKind.TRIANGLE, b, 0), scratch.overlap);
            for (int power : new int[] {-1060, -340, -40, 40, 100}) {
                double[] p = a.clone();
                double[] q = b.clone();
                for (int k = 0; k < 9; k++) {
                    p[k] = Math.scalb(p[k], power);
                    q[k] = Math.scalb(q[k], power);
                }
                assertThat(SpatialOverlap.test(
                                new Leaf(LeafKind.TRIANGLE, p, 0), new Leaf(LeafKind.TRIANGLE, q, 0), scratch.overlap))
                        .as(power + " " + Arrays.toString(a) + Arrays.toString(b))
                        .isEqualTo(truth);
            }
        }
    }

    private void agree(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
        boolean truth = Rows.touch(kindA, a, kindB, b);
        asked++;
        hits += truth ? 1 : 0;
        assertThat(polytopes.touch(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0)))
                .as(pair)
                .isEqualTo(truth);
        assertThat(polytopes.touch(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0)))
                .as(pair + " swapped")
                .isEqualTo(truth);
        assertThat(SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap))
                .as(pair)
                .isEqualTo(truth);
        double distance = SpatialDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance);
        assertThat(distance == 0).as(pair + " distance " + distance).isEqualTo(truth || distance == 0);
        if (truth) {
            assertThat(distance).as(pair).isZero();
        }
    }

    private static double[] coarse(LeafKind kind, SplittableRandom random) {
        if (kind == LeafKind.TRIANGLE) {
            double[] row = new double[Leaf.STRIDE];
            for (int k = 0; k < 9; k++) {
                row[k] = random.nextInt(-1, 3);
            }
            return row;
        }
        double[] row = Rows.box(
                random.nextInt(-1, 3),
                random.nextInt(-1, 3),
                random.nextInt(-1, 3),
                random.nextInt(3),
                random.nextInt(3),
                random.nextInt(3),
                Rows.identity());
        if (kind == LeafKind.BOX && random.nextBoolean()) {
            // Columns of few bits at right angles, of length 1/2 and 5/8: what is stored counts, whatever its length.
            double[] turned = {0.375, -0.5, 0, 0.5, 0.375, 0, 0, 0, 0.5};
            System.arraycopy(turned, 0, row, Leaf.ROTATION, 9);
        }
        return row;
    }

    private static double[] coarseTurned(SplittableRandom random) {
        double[] row = Rows.random(LeafKind.BOX, random, 4);
        for (int k = 0; k < 15; k++) {
            row[k] = Math.rint(row[k] * 0x1p16) * 0x1p-16;
        }
        return row;
    }
}
