package robosim.geometry.index.meshes;

import java.util.Arrays;

/** Builds a {@link BoxTree} by {@link SurfaceAreaSplits}. */
final class BoxTreeBuilder {
    static final int MAX_DEPTH = SurfaceAreaSplits.HEURISTIC_DEPTH + 32;

    /** The cost of testing the two children of a node, relative to that of testing an item. */
    private static final double NODE_COST = 1.5;

    /** The greatest exponent of a scale, such that both the scale and its reciprocal are doubles. */
    private static final int MOST_EXPONENT = 1000;

    final int[] order;
    final double[] bounds = new double[6];
    final double[] origin = new double[3];
    final double scale;

    private final SurfaceAreaSplits splits;
    float[] nodes;
    private int count = 1;
    private final float[] range = new float[6];

    BoxTreeBuilder(double[] given) {
        if (given.length == 0 || given.length % 6 != 0) {
            throw new IllegalArgumentException(
                    "boxes must be six numbers for each of at least one item (got: " + given.length + " numbers)");
        }
        measure(given);
        double largest = 0;
        for (int axis = 0; axis < 3; axis++) {
            origin[axis] = bounds[axis] / 2 + bounds[3 + axis] / 2;
            double reach = Math.max(bounds[3 + axis] - origin[axis], origin[axis] - bounds[axis]);
            largest = Math.max(largest, reach);
        }
        int exponent = largest == 0 ? 0 : Math.getExponent(Math.nextUp(largest)) + 1;
        scale = Math.scalb(1.0, -Math.max(-MOST_EXPONENT, Math.min(MOST_EXPONENT, exponent)));
        int n = given.length / 6;
        order = new int[n];
        Arrays.setAll(order, i -> i);
        // In the tree's units, rounded outward.
        float[] boxes = new float[6 * n];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = outward(given[i], i % 6);
        }
        splits = new SurfaceAreaSplits(boxes, order, 0);
        nodes = new float[BoxTree.STRIDE * (2 * n - 1)];
        build(0, 0, n, 0);
        nodes = Arrays.copyOf(nodes, BoxTree.STRIDE * count);
    }

    private void measure(double[] given) {
        Arrays.fill(bounds, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 3, 6, Double.NEGATIVE_INFINITY);
        for (int i = 0; i < given.length; i++) {
            int side = i % 6;
            double value = given[i];
            if (!Double.isFinite(value) || (side >= 3 && value < given[i - 3])) {
                throw new IllegalArgumentException(
                        "box must be finite and min at most max (got: " + value + " in box " + i / 6 + ")");
            }
            bounds[side] = side < 3 ? Math.min(bounds[side], value) : Math.max(bounds[side], value);
        }
    }

    /** A bound in the tree's units: the difference is off by half an ulp, the product is exact above the subnormals. */
    private float outward(double value, int side) {
        double own = (value - origin[side % 3]) * scale;
        return side < 3 ? down(Math.nextDown(own)) : up(Math.nextUp(own));
    }

    private static float down(double value) {
        float nearest = (float) value;
        return nearest > value ? Math.nextDown(nearest) : nearest;
    }

    private static float up(double value) {
        float nearest = (float) value;
        return nearest < value ? Math.nextUp(nearest) : nearest;
    }

    private void build(int node, int from, int to, int depth) {
        splits.measure(from, to);
        write(node);
        int at = BoxTree.STRIDE * node;
        if (isLeaf(from, to, depth)) {
            nodes[at + BoxTree.LINK] = Float.intBitsToFloat(from);
            nodes[at + BoxTree.COUNT] = Float.intBitsToFloat(to - from);
            return;
        }
        int middle = splits.divide(from, to);
        int parts = count;
        count += 2;
        nodes[at + BoxTree.LINK] = Float.intBitsToFloat(parts);
        build(parts, from, middle, depth + 1);
        build(parts + 1, middle, to, depth + 1);
    }

    /** Whether the range measured last is better not split. */
    private boolean isLeaf(int from, int to, int depth) {
        int items = to - from;
        return items == 1
                || (splits.cost(from, to, depth) + NODE_COST * splits.area() >= items * splits.area()
                        && items <= BoxTree.LEAF);
    }

    private void write(int node) {
        splits.copyBounds(range, 0);
        for (int axis = 0; axis < 3; axis++) {
            float low = range[axis];
            float high = range[axis + 3];
            float middle = 0.5f * (low + high);
            int at = BoxTree.STRIDE * node + axis;
            nodes[at] = middle;
            nodes[at + BoxTree.HALF] = up(Math.nextUp(Math.max((double) high - middle, (double) middle - low)));
        }
    }
}
