package robosim.geometry.index.meshes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Tag("slow")
class BoxTreeTest {
    enum Scene {
        SPREAD,
        FLAT,
        ON_A_LATTICE,
        ONE_PLACE,
        HUGE_AMONG_TINY,
        HALVING,
        FEW;

        double[] boxes(SplittableRandom random) {
            int n = this == FEW ? random.nextInt(1, 8) : 500;
            double[] boxes = new double[6 * n];
            for (int item = 0; item < n; item++) {
                for (int axis = 0; axis < 3; axis++) {
                    double centre = switch (this) {
                        case ON_A_LATTICE -> random.nextInt(-10, 11) * 0.5;
                        case ONE_PLACE -> 5;
                        case HALVING -> StrictMath.scalb(1.0, -(item * 2));
                        case FLAT -> axis == 1 ? 2 : random.nextDouble(-10, 10);
                        default -> random.nextDouble(-10, 10);
                    };
                    double half = switch (this) {
                        case ON_A_LATTICE -> random.nextInt(3) * 0.25;
                        case HUGE_AMONG_TINY -> random.nextInt(20) == 0 ? 10 : 0x1p-9;
                        case HALVING -> 0;
                        case FLAT -> axis == 1 ? 0 : random.nextDouble(1);
                        default -> random.nextInt(6) == 0 ? 0 : random.nextDouble(1);
                    };
                    boxes[6 * item + axis] = centre - half;
                    boxes[6 * item + 3 + axis] = centre + half;
                }
            }
            return boxes;
        }
    }

    @ParameterizedTest
    @EnumSource
    void nodesHoldTheirPartsTightly(Scene scene) {
        SplittableRandom random = new SplittableRandom(191);
        for (double scale : new double[] {1, 0x1p90, 0x1p-300, 0x1p-1060}) {
            double[] boxes = scene.boxes(random);
            for (int k = 0; k < boxes.length; k++) {
                boxes[k] *= scale;
            }
            check(new BoxTree(boxes), boxes);
        }
    }

    @Test
    void whatIsFarFromTheOriginIsHeldTightlyToo() {
        double[] boxes = Scene.SPREAD.boxes(new SplittableRandom(193));
        for (int k = 0; k < boxes.length; k++) {
            boxes[k] += 1e9;
        }
        check(new BoxTree(boxes), boxes);
    }

    private static void check(BoxTree tree, double[] boxes) {
        double[] all = unionOf(tree, boxes, tree.root());
        assertThat(tree.bounds()).isEqualTo(all);
        double size = 0;
        for (int axis = 0; axis < 3; axis++) {
            size = Math.max(size, all[3 + axis] - all[axis]);
        }
        for (int node = 0; node < tree.nodes(); node++) {
            double[] union = unionOf(tree, boxes, node);
            for (int axis = 0; axis < 3; axis++) {
                float middle = tree.numbers()[BoxTree.STRIDE * node + axis];
                float half = tree.numbers()[BoxTree.STRIDE * node + BoxTree.HALF + axis];
                assertThat(Math.abs(middle) + half).isLessThan(1.001f);
                BigDecimal low = place(tree, axis, new BigDecimal(middle).subtract(new BigDecimal(half)));
                BigDecimal high = place(tree, axis, new BigDecimal(middle).add(new BigDecimal(half)));
                assertThat(low).isLessThanOrEqualTo(new BigDecimal(union[axis]));
                assertThat(high).isGreaterThanOrEqualTo(new BigDecimal(union[3 + axis]));
                BigDecimal slack = new BigDecimal(Math.max(size, Double.MIN_NORMAL)).multiply(new BigDecimal(0x1p-21));
                assertThat(low.add(slack)).isGreaterThanOrEqualTo(new BigDecimal(union[axis]));
                assertThat(high.subtract(slack)).isLessThanOrEqualTo(new BigDecimal(union[3 + axis]));
                assertThat(tree.middle(node, axis))
                        .isCloseTo(low.add(high).doubleValue() / 2, within(0x1p-50 * size(all)));
            }
        }
        assertThat(depth(tree, tree.root())).isLessThanOrEqualTo(BoxTree.MAX_DEPTH);
    }

    private static BigDecimal place(BoxTree tree, int axis, BigDecimal own) {
        return new BigDecimal(tree.origin(axis)).add(own.multiply(new BigDecimal(1 / tree.scale())));
    }

    private static double size(double[] box) {
        return Arrays.stream(box).map(Math::abs).sum() + Double.MIN_NORMAL;
    }

    /** Of all items below a node. */
    private static double[] unionOf(BoxTree tree, double[] boxes, int node) {
        double[] union = new double[6];
        Arrays.fill(union, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(union, 3, 6, Double.NEGATIVE_INFINITY);
        if (tree.isLeaf(node)) {
            assertThat(tree.count(node)).isBetween(1, BoxTree.LEAF);
            for (int place = tree.first(node); place < tree.first(node) + tree.count(node); place++) {
                grow(union, boxes, 6 * tree.item(place));
            }
        } else {
            assertThat(tree.count(node)).isZero();
            assertThat(tree.left(node)).isGreaterThan(node);
            grow(union, unionOf(tree, boxes, tree.left(node)), 0);
            grow(union, unionOf(tree, boxes, tree.right(node)), 0);
        }
        return union;
    }

    @ParameterizedTest
    @EnumSource
    void everyItemIsInOneLeaf(Scene scene) {
        BoxTree tree = new BoxTree(scene.boxes(new SplittableRandom(197)));
        int[] inLeaves = new int[tree.size()];
        int[] placed = new int[tree.size()];
        for (int node = 0; node < tree.nodes(); node++) {
            for (int k = 0; k < tree.count(node); k++) {
                inLeaves[tree.first(node) + k]++;
                placed[tree.item(tree.first(node) + k)]++;
            }
        }
        assertThat(inLeaves).containsOnly(1);
        assertThat(placed).containsOnly(1);
    }

    /** What the heuristic is for: the parts of a node share little of its surface. */
    @Test
    void aPlaceIsInFewNodes() {
        SplittableRandom random = new SplittableRandom(181);
        int n = 20_000;
        double[] boxes = new double[6 * n];
        for (int item = 0; item < n; item++) {
            for (int axis = 0; axis < 3; axis++) {
                boxes[6 * item + axis] = random.nextDouble(100);
                boxes[6 * item + 3 + axis] = boxes[6 * item + axis] + 1;
            }
        }
        BoxTree tree = new BoxTree(boxes);
        long holding = 0;
        for (int i = 0; i < 1000; i++) {
            double[] point = {random.nextDouble(100), random.nextDouble(100), random.nextDouble(100)};
            for (int node = 0; node < tree.nodes(); node++) {
                boolean holds = true;
                for (int axis = 0; axis < 3; axis++) {
                    holds &= Math.abs(point[axis] - tree.middle(node, axis)) <= tree.half(node, axis);
                }
                holding += holds ? 1 : 0;
            }
        }
        assertThat(holding / 1000).isBetween(5L, 30L);
    }

    @Test
    void refusesWhatItCannotHold() {
        assertThatThrownBy(() -> new BoxTree(new double[0])).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new BoxTree(new double[7])).hasMessageContaining("got: 7");
        assertThatThrownBy(() -> new BoxTree(new double[] {0, 0, 0, 1, Double.NaN, 1}))
                .hasMessageContaining("got: NaN");
        assertThatThrownBy(() -> new BoxTree(new double[] {0, 2, 0, 1, 1, 1})).hasMessageContaining("box 0");
    }

    private static void grow(double[] union, double[] by, int at) {
        for (int i = 0; i < 3; i++) {
            union[i] = Math.min(union[i], by[at + i]);
            union[i + 3] = Math.max(union[i + 3], by[at + i + 3]);
        }
    }

    private static int depth(BoxTree tree, int node) {
        return tree.isLeaf(node) ? 1 : 1 + Math.max(depth(tree, tree.left(node)), depth(tree, tree.right(node)));
    }
}
