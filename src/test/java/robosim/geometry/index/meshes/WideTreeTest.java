package robosim.geometry.index.meshes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.index.meshes.BoxTreeTest.Scene;

class WideTreeTest {
    @ParameterizedTest
    @EnumSource
    void everyItemIsBelowOneOfTheParts(Scene scene) {
        SplittableRandom random = new SplittableRandom(199);
        for (int trial = 0; trial < 20; trial++) {
            BoxTree tree = new BoxTree(scene.boxes(random));
            int[] times = new int[tree.size()];
            new Walk(tree, times).node(0);
            assertThat(times).containsOnly(1);
        }
    }

    /** Full nodes, and few items below a link: a third as many nodes as in the binary tree are what it is for. */
    @ParameterizedTest
    @EnumSource
    void hasFarFewerNodesThanTheBinaryTree(Scene scene) {
        BoxTree tree = new BoxTree(scene.boxes(new SplittableRandom(211)));
        Walk walk = new Walk(tree, new int[tree.size()]);
        walk.node(0);
        assertThat(walk.nodes).isEqualTo(walk.numbers.length / WideTree.STRIDE);
        assertThat(walk.nodes).isLessThanOrEqualTo(1 + tree.nodes() / 3);
    }

    /** No other choice of the binary tree's nodes costs less, by trying them all. */
    @Test
    void costsTheLeast() {
        SplittableRandom random = new SplittableRandom(223);
        for (int trial = 0; trial < 50; trial++) {
            double[] boxes = new double[6 * (2 + random.nextInt(30))];
            for (int k = 0; k < boxes.length; k++) {
                boxes[k] = random.nextDouble(10) + (k % 6 < 3 ? 0 : boxes[k - 3]);
            }
            BoxTree tree = new BoxTree(boxes);
            double least = leastBelow(tree, tree.root(), 4) + 4 * area(tree, tree.root());
            double whole = boxes.length / 6 <= WideTree.LEAF ? leaf(tree, tree.root()) : Double.POSITIVE_INFINITY;
            double wide = new Walk(tree, new int[tree.size()]).cost(0);
            // The root is a node even where a leaf would do, which then is its only child.
            double truth = whole <= least ? whole + 4 * area(tree, tree.root()) : least;
            assertThat(wide).isCloseTo(truth, within(1e-5 * truth));
        }
    }

    /** The least cost of a node as at most so many children. */
    private static double least(BoxTree tree, int node, int most) {
        double least = count(tree, node) <= WideTree.LEAF ? leaf(tree, node) : Double.POSITIVE_INFINITY;
        if (!tree.isLeaf(node)) {
            least = Math.min(least, leastBelow(tree, node, 4) + 4 * area(tree, node));
            least = Math.min(least, most > 1 ? leastBelow(tree, node, most) : least);
        }
        return least;
    }

    private static double leastBelow(BoxTree tree, int node, int most) {
        if (tree.isLeaf(node)) {
            return Double.POSITIVE_INFINITY;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int k = 1; k < most; k++) {
            least = Math.min(least, least(tree, tree.left(node), k) + least(tree, tree.right(node), most - k));
        }
        return least;
    }

    private static double leaf(BoxTree tree, int node) {
        return area(tree, node) * (1.5 + count(tree, node));
    }

    private static int count(BoxTree tree, int node) {
        return tree.isLeaf(node) ? tree.count(node) : count(tree, tree.left(node)) + count(tree, tree.right(node));
    }

    private static double area(BoxTree tree, int node) {
        return area(tree.numbers(), BoxTree.STRIDE * node);
    }

    private static double area(float[] numbers, int at) {
        double x = numbers[at + WideTree.HALF];
        double y = numbers[at + WideTree.HALF + 1];
        double z = numbers[at + WideTree.HALF + 2];
        return x * y + y * z + z * x;
    }

    private static final class Walk {
        private final BoxTree tree;
        private final float[] numbers;
        private final int[] times;
        private int nodes;

        Walk(BoxTree tree, int[] times) {
            this.tree = tree;
            this.times = times;
            numbers = new WideTree(tree).numbers();
        }

        /** Checks what is below a node; answers the places it holds, from the first to after the last. */
        int[] node(int at) {
            nodes++;
            int[] all = {Integer.MAX_VALUE, 0};
            for (int k = at; k < at + WideTree.STRIDE; k += WideTree.PART) {
                if (numbers[k + WideTree.HALF] < 0) {
                    assertThat(Arrays.copyOfRange(numbers, k + WideTree.HALF, k + WideTree.LINK))
                            .containsOnly(-WideTree.MISSING);
                    continue;
                }
                int link = Float.floatToRawIntBits(numbers[k + WideTree.LINK]);
                int[] held = link < 0 ? leaf(link) : node(link);
                assertThat(Arrays.copyOfRange(numbers, k, k + WideTree.LINK)).isEqualTo(boxOf(held));
                all[0] = Math.min(all[0], held[0]);
                all[1] = Math.max(all[1], held[1]);
            }
            return all;
        }

        /** The cost of the children of a node, and of the root's own. */
        double cost(int at) {
            double cost = at == 0 ? 4 * area(tree, tree.root()) : 0;
            for (int k = at; k < at + WideTree.STRIDE; k += WideTree.PART) {
                if (numbers[k + WideTree.HALF] >= 0) {
                    int link = Float.floatToRawIntBits(numbers[k + WideTree.LINK]);
                    cost += link < 0
                            ? area(numbers, k) * (1.5 + WideTree.last(link) - WideTree.first(link) + 1)
                            : area(numbers, k) * 4 + cost(link);
                }
            }
            return cost;
        }

        private int[] leaf(int link) {
            int[] held = {WideTree.first(link), WideTree.last(link) + 1};
            for (int place = held[0]; place < held[1]; place++) {
                times[place]++;
            }
            return held;
        }

        /** The box of the tree's node with these items. */
        private float[] boxOf(int[] held) {
            int node = tree.root();
            while (first(node) != held[0] || end(node) != held[1]) {
                node = end(tree.left(node)) > held[0] ? tree.left(node) : tree.right(node);
            }
            return Arrays.copyOfRange(tree.numbers(), BoxTree.STRIDE * node, BoxTree.STRIDE * node + BoxTree.LINK);
        }

        private int first(int node) {
            return tree.isLeaf(node) ? tree.first(node) : first(tree.left(node));
        }

        private int end(int node) {
            return tree.isLeaf(node) ? tree.first(node) + tree.count(node) : end(tree.right(node));
        }
    }
}
