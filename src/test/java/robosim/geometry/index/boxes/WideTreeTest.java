package robosim.geometry.index.boxes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.index.boxes.BoxTreeTest.Scene;

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

    /** Fewer than four parts are only where all of them are leaves: half as many nodes on the way are what it is for. */
    @ParameterizedTest
    @EnumSource
    void aNodeIsFullWhereItsPartsCanBeDivided(Scene scene) {
        BoxTree tree = new BoxTree(scene.boxes(new SplittableRandom(211)));
        Walk walk = new Walk(tree, new int[tree.size()]);
        walk.node(0);
        assertThat(walk.nodes).isEqualTo(tree.wide().numbers().length / WideTree.STRIDE);
        assertThat(walk.divisible).isZero();
    }

    private static final class Walk {
        private final BoxTree tree;
        private final float[] numbers;
        private final int[] times;
        private int nodes;

        /** How many nodes lack a part that a part which is no leaf could give. */
        private int divisible;

        Walk(BoxTree tree, int[] times) {
            this.tree = tree;
            this.times = times;
            numbers = tree.wide().numbers();
        }

        /** Checks what is below a node; answers the places it holds, from the first to after the last. */
        int[] node(int at) {
            nodes++;
            int[] all = {Integer.MAX_VALUE, 0};
            boolean isFull = true;
            boolean hasInner = false;
            for (int k = at; k < at + WideTree.STRIDE; k += WideTree.PART) {
                if (numbers[k + WideTree.HALF] < 0) {
                    assertThat(Arrays.copyOfRange(numbers, k + WideTree.HALF, k + WideTree.LINK))
                            .containsOnly(-WideTree.MISSING);
                    isFull = false;
                    continue;
                }
                int link = Float.floatToRawIntBits(numbers[k + WideTree.LINK]);
                int[] held = link < 0 ? leaf(link) : node(link);
                hasInner |= link >= 0;
                assertThat(Arrays.copyOfRange(numbers, k, k + WideTree.LINK)).isEqualTo(boxOf(held));
                all[0] = Math.min(all[0], held[0]);
                all[1] = Math.max(all[1], held[1]);
            }
            divisible += !isFull && hasInner ? 1 : 0;
            return all;
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
