package robosim.geometry.narrow.gjk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.ConvexOverlap;

/** What is called deep overlaps by exact decision, also when drawn apart a little; what overlaps by more is called deep. */
class HullOverlapTest {
    private static final int PAIRS = 600;
    private static final double LITTLE = 0x1p-30;

    private final Scratch s = new Scratch();

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void deepPairsOverlapAndMostThatOverlapAreDeep(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(20261122);
        for (LeafKind kindA : Leaves.KINDS) {
            for (LeafKind kindB : Leaves.KINDS) {
                int overlaps = 0;
                int deep = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 1.2);
                    double[] b = Rows.random(kindB, random, 1.2);
                    if (n % 2 == 0 && kindA != LeafKind.TRIANGLE && kindB != LeafKind.TRIANGLE) {
                        level(kindA, a);
                        level(kindB, b);
                    }
                    String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
                    boolean isDeep =
                            ConvexOverlap.isDeep(dimension, new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), s.overlap);
                    boolean overlap =
                            ConvexOverlap.test(dimension, new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), s.overlap);
                    assertThat(overlap || !isDeep).as(pair).isTrue();
                    if (isDeep) {
                        assertThat(ConvexOverlap.test(
                                        dimension,
                                        new Leaf(kindA, apart(kindA, a, b), 0),
                                        new Leaf(kindB, b, 0),
                                        s.overlap))
                                .as(pair)
                                .isTrue();
                    }
                    overlaps += overlap ? 1 : 0;
                    deep += isDeep ? 1 : 0;
                }
                String kinds = dimension + " " + kindA + " with " + kindB;
                assertThat(overlaps).as(kinds).isBetween(PAIRS / 20, PAIRS * 98 / 100);
                assertThat(deep).as(kinds).isBetween(overlaps * 8 / 10, overlaps);
            }
        }
    }

    /** Boxes and cylinders of one heading that stand on each other, or side by side: never deep, by any last bit. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void whatTouchesIsNotDeep(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(3);
        for (int n = 0; n < 5000; n++) {
            LeafKind kind = n % 2 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.UPRIGHT_CYLINDER;
            double[] a = {0, 0, 0, half(random), half(random), half(random), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
            double[] b = {0, 0, 0, half(random), half(random), half(random), 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
            if (dimension == Dimension.SPATIAL && random.nextBoolean()) {
                b[1] = a[4] + b[4];
            } else {
                b[0] = a[3] + b[3];
            }
            assertThat(ConvexOverlap.test(dimension, new Leaf(kind, a, 0), new Leaf(kind, b, 0), s.overlap))
                    .isTrue();
            assertThat(ConvexOverlap.isDeep(dimension, new Leaf(kind, a, 0), new Leaf(kind, b, 0), s.overlap))
                    .as(Arrays.toString(a) + Arrays.toString(b))
                    .isFalse();
        }
    }

    private static double half(SplittableRandom random) {
        return random.nextInt(1, 1 << 20) * 0x1p-18;
    }

    /** Gives it the height at which all stand. */
    private static void level(LeafKind kind, double[] row) {
        if (kind == LeafKind.PRISM) {
            double half = 0.5 * (row[9] - row[8]);
            row[8] = -half;
            row[9] = half;
        } else {
            row[1] = 0;
        }
    }

    /** The first, drawn away from the other by a little. */
    private static double[] apart(LeafKind kind, double[] a, double[] b) {
        double[] moved = a.clone();
        if (kind == LeafKind.PRISM) {
            moved[8] += LITTLE;
            moved[9] += LITTLE;
        } else if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                moved[k] += LITTLE;
            }
        } else {
            moved[0] += a[0] >= b[0] ? LITTLE : -LITTLE;
        }
        return moved;
    }
}
