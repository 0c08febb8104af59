package robosim.geometry.index.meshes;

import java.util.Arrays;

/**
 * Builds a {@link WideTree}: chooses the nodes of the binary tree to keep so that the surface area heuristic's cost is the
 * least, from the leaves up (Ylitie, Karras and Laine 2017), then writes them, each before what is below it.
 */
final class WideTreeBuilder {
    /** The costs of a node and of a leaf, relative to that of an item: about what rays at meshes take. */
    private static final float NODE_COST = 4;

    private static final float LEAF_COST = 1.5f;

    private static final int WIDTH = WideTree.STRIDE / WideTree.PART;

    private final BoxTree tree;
    private final float[] nodes;

    /** For each node the least cost of what is below it as one child, as up to two and as up to three. */
    private final float[] costs;

    /** For each node the number of items below it, if it is best kept as a leaf; else 0. */
    private final byte[] items;

    private final int[] parts = new int[WIDTH];
    private float[] numbers = {};
    private int end;

    WideTreeBuilder(BoxTree tree) {
        this.tree = tree;
        nodes = tree.numbers();
        costs = new float[(WIDTH - 1) * tree.nodes()];
        items = new byte[tree.nodes()];
    }

    float[] build() {
        weigh(tree.root());
        numbers = new float[WideTree.STRIDE * count(tree.root())];
        fill(tree.root());
        return numbers;
    }

    /** Finds the costs of a node; returns the number of items below it, or more than a leaf may have. */
    private int weigh(int node) {
        int at = (WIDTH - 1) * node;
        float area = area(node);
        if (tree.isLeaf(node)) {
            int count = tree.count(node);
            items[node] = (byte) count;
            Arrays.fill(costs, at, at + WIDTH - 1, area * (LEAF_COST + count));
            return count;
        }
        int count = Math.min(weigh(tree.left(node)) + weigh(tree.right(node)), WideTree.LEAF + 1);
        float whole = count <= WideTree.LEAF ? area * (LEAF_COST + count) : Float.POSITIVE_INFINITY;
        float divided = area * NODE_COST + cost(node, WIDTH);
        items[node] = (byte) (whole <= divided ? count : 0);
        costs[at] = Math.min(whole, divided);
        for (int most = 2; most < WIDTH; most++) {
            costs[at + most - 1] = Math.min(costs[at + most - 2], cost(node, most));
        }
        return count;
    }

    /** The least cost of what is below an inner node's two children, as up to so many. */
    private float cost(int node, int most) {
        float least = Float.POSITIVE_INFINITY;
        for (int k = 1; k < most; k++) {
            least = Math.min(least, cost(tree.left(node), k, tree.right(node), most - k));
        }
        return least;
    }

    private float cost(int left, int ofLeft, int right, int ofRight) {
        return costs[(WIDTH - 1) * left + ofLeft - 1] + costs[(WIDTH - 1) * right + ofRight - 1];
    }

    private float area(int node) {
        int at = BoxTree.STRIDE * node + BoxTree.HALF;
        return nodes[at] * nodes[at + 1] + nodes[at + 1] * nodes[at + 2] + nodes[at + 2] * nodes[at];
    }

    /** Collects the children of a node that is kept, in order. */
    private int[] gather(int node) {
        int size = items[node] > 0 ? put(node, 0) : split(node, WIDTH, 0);
        return Arrays.copyOf(parts, size);
    }

    private int put(int node, int size) {
        parts[size] = node;
        return size + 1;
    }

    private int split(int node, int most, int size) {
        int left = tree.left(node);
        int right = tree.right(node);
        int best = 1;
        for (int k = 2; k < most; k++) {
            if (cost(left, k, right, most - k) < cost(left, best, right, most - best)) {
                best = k;
            }
        }
        return add(right, most - best, add(left, best, size));
    }

    /** Adds what stands for a node, at most so many. */
    private int add(int node, int most, int size) {
        int at = (WIDTH - 1) * node;
        int fewest = most;
        while (fewest > 1 && costs[at + fewest - 2] == costs[at + fewest - 1]) {
            fewest--;
        }
        return fewest == 1 ? put(node, size) : split(node, fewest, size);
    }

    /** The number of nodes from one that is kept on. */
    private int count(int node) {
        int count = 1;
        for (int part : gather(node)) {
            count += items[part] > 0 ? 0 : count(part);
        }
        return count;
    }

    /** Writes a node and what is below it; returns where it begins. */
    private int fill(int node) {
        int begin = end;
        end += WideTree.STRIDE;
        int[] own = gather(node);
        for (int k = 0; k < WIDTH; k++) {
            int at = begin + WideTree.PART * k;
            if (k >= own.length) {
                Arrays.fill(numbers, at + WideTree.HALF, at + WideTree.LINK, -WideTree.MISSING);
                continue;
            }
            System.arraycopy(nodes, BoxTree.STRIDE * own[k], numbers, at, WideTree.LINK);
            if (items[own[k]] > 0) {
                numbers[at + WideTree.LINK] = Float.intBitsToFloat(WideTree.link(first(own[k]), items[own[k]]));
            }
        }
        for (int k = 0; k < own.length; k++) {
            if (items[own[k]] == 0) {
                numbers[begin + WideTree.PART * k + WideTree.LINK] = Float.intBitsToFloat(fill(own[k]));
            }
        }
        return begin;
    }

    private int first(int node) {
        return tree.isLeaf(node) ? tree.first(node) : first(tree.left(node));
    }
}
