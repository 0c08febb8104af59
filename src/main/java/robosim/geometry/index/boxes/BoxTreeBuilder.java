package robosim.geometry.index.boxes;

import java.util.Arrays;

/**
 * Builds a {@link BoxTree}: splits by the surface area heuristic over sixteen bins, or in half where that does not
 * apply.
 */
final class BoxTreeBuilder {
    private static final int BINS = 16;

    /** From this depth on every split is in half, so the depth stays below this plus the 31 halvings of any array. */
    private static final int HEURISTIC_DEPTH = 48;

    static final int MAX_DEPTH = HEURISTIC_DEPTH + 32;

    /** The cost of testing the two children of a node, relative to that of testing an item. */
    private static final float NODE_COST = 1.5f;

    /** The greatest exponent of a scale, such that both the scale and its reciprocal are doubles. */
    private static final int MOST_EXPONENT = 1000;

    private final int[] order;
    private final double[] bounds = new double[6];
    private final double[] origin = new double[3];
    private final double scale;

    /** Six floats per item, minimum and maximum in the tree's units, rounded outward; reordered with {@link #order}. */
    private final float[] boxes;

    private float[] nodes;
    private int count = 1;

    // The bounds of the boxes, and of their doubled centres, in the current range.
    private final float[] range = new float[6];
    private final float[] middles = new float[6];

    private final float[] binBounds = new float[6 * BINS];
    private final int[] binCounts = new int[BINS];
    private final float[] costRight = new float[BINS];
    private final float[] grown = new float[6];

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
        boxes = new float[6 * n];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = outward(given[i], i % 6);
        }
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

    float[] nodes() {
        return nodes;
    }

    int[] order() {
        return order;
    }

    double[] bounds() {
        return bounds;
    }

    double[] origin() {
        return origin;
    }

    double scale() {
        return scale;
    }

    private void build(int node, int from, int to, int depth) {
        measure(from, to);
        write(node);
        int middle = to - from == 1 ? to : split(from, to, depth);
        int at = BoxTree.STRIDE * node;
        if (middle == to) {
            nodes[at + BoxTree.LINK] = Float.intBitsToFloat(from);
            nodes[at + BoxTree.COUNT] = Float.intBitsToFloat(to - from);
            return;
        }
        int parts = count;
        count += 2;
        nodes[at + BoxTree.LINK] = Float.intBitsToFloat(parts);
        build(parts, from, middle, depth + 1);
        build(parts + 1, middle, to, depth + 1);
    }

    private void measure(int from, int to) {
        empty(range, 0);
        empty(middles, 0);
        for (int k = 6 * from; k < 6 * to; k += 6) {
            for (int axis = 0; axis < 3; axis++) {
                float low = boxes[k + axis];
                float high = boxes[k + 3 + axis];
                float middle = low + high;
                range[axis] = Math.min(range[axis], low);
                range[axis + 3] = Math.max(range[axis + 3], high);
                middles[axis] = Math.min(middles[axis], middle);
                middles[axis + 3] = Math.max(middles[axis + 3], middle);
            }
        }
    }

    private void write(int node) {
        for (int axis = 0; axis < 3; axis++) {
            float low = range[axis];
            float high = range[axis + 3];
            float middle = 0.5f * (low + high);
            int at = BoxTree.STRIDE * node + axis;
            nodes[at] = middle;
            nodes[at + BoxTree.HALF] = up(Math.nextUp(Math.max((double) high - middle, (double) middle - low)));
        }
    }

    /** Where the right part begins; the end of the range if all of it is to be a leaf. */
    private int split(int from, int to, int depth) {
        int half = (from + to) >>> 1;
        int axis = longestAxis();
        float low = middles[axis];
        float extent = middles[axis + 3] - low;
        if (extent <= 0) {
            return to - from <= BoxTree.LEAF ? to : half; // all centres coincide: any half will do
        }
        float scaling = BINS / extent;
        if (depth < HEURISTIC_DEPTH && scaling < Float.POSITIVE_INFINITY) {
            float whole = (to - from) * area(range, 0);
            int cut = bestCut(from, to, axis, low, scaling);
            if (to - from <= BoxTree.LEAF && leastCost + NODE_COST * area(range, 0) >= whole) {
                return to;
            }
            int middle = partition(from, to, axis, low, scaling, cut);
            if (middle > from && middle < to) {
                return middle;
            }
        }
        if (to - from <= BoxTree.LEAF) {
            return to;
        }
        select(from, to - 1, half, axis);
        return half;
    }

    private int longestAxis() {
        float x = middles[3] - middles[0];
        float y = middles[4] - middles[1];
        float z = middles[5] - middles[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    private float leastCost;

    // The bin at which the right part begins, by the smallest sum of area times number of items.
    private int bestCut(int from, int to, int axis, float low, float scaling) {
        Arrays.fill(binCounts, 0);
        for (int bin = 0; bin < BINS; bin++) {
            empty(binBounds, 6 * bin);
        }
        for (int k = from; k < to; k++) {
            int bin = bin(k, axis, low, scaling);
            binCounts[bin]++;
            grow(binBounds, 6 * bin, boxes, 6 * k);
        }
        empty(grown, 0);
        int right = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            right += binCounts[bin];
            grow(grown, 0, binBounds, 6 * bin);
            costRight[bin] = right == 0 ? Float.POSITIVE_INFINITY : right * area(grown, 0);
        }
        empty(grown, 0);
        int left = 0;
        int best = BINS / 2;
        leastCost = Float.POSITIVE_INFINITY;
        for (int bin = 1; bin < BINS; bin++) {
            left += binCounts[bin - 1];
            grow(grown, 0, binBounds, 6 * (bin - 1));
            float cost = left == 0 ? Float.POSITIVE_INFINITY : left * area(grown, 0) + costRight[bin];
            if (cost < leastCost) {
                leastCost = cost;
                best = bin;
            }
        }
        return best;
    }

    private int partition(int from, int to, int axis, float low, float scaling, int cut) {
        int left = from;
        int right = to - 1;
        while (true) {
            while (left <= right && bin(left, axis, low, scaling) < cut) {
                left++;
            }
            while (left <= right && bin(right, axis, low, scaling) >= cut) {
                right--;
            }
            if (left >= right) {
                return left;
            }
            swap(left++, right--);
        }
    }

    private void swap(int p, int q) {
        int item = order[p];
        order[p] = order[q];
        order[q] = item;
        for (int k = 0; k < 6; k++) {
            float number = boxes[6 * p + k];
            boxes[6 * p + k] = boxes[6 * q + k];
            boxes[6 * q + k] = number;
        }
    }

    private int bin(int place, int axis, float low, float scaling) {
        return Math.min(BINS - 1, (int) ((middle(place, axis) - low) * scaling));
    }

    // Hoare's selection: order[k] becomes the item that sorting by centre would put there, with smaller ones before it.
    private void select(int from, int to, int k, int axis) {
        int low = from;
        int high = to;
        while (low < high) {
            float pivot = middle((low + high) >>> 1, axis);
            int i = low;
            int j = high;
            while (i <= j) {
                while (middle(i, axis) < pivot) {
                    i++;
                }
                while (middle(j, axis) > pivot) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (k <= j) {
                high = j;
            } else if (k >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    /** Twice the centre of an item's box. */
    private float middle(int place, int axis) {
        return boxes[6 * place + axis] + boxes[6 * place + 3 + axis];
    }

    private static float area(float[] of, int at) {
        float x = of[at + 3] - of[at];
        float y = of[at + 4] - of[at + 1];
        float z = of[at + 5] - of[at + 2];
        return x * y + y * z + z * x;
    }

    private static void empty(float[] of, int at) {
        Arrays.fill(of, at, at + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(of, at + 3, at + 6, Float.NEGATIVE_INFINITY);
    }

    private static void grow(float[] of, int at, float[] by, int from) {
        for (int i = 0; i < 3; i++) {
            of[at + i] = Math.min(of[at + i], by[from + i]);
            of[at + 3 + i] = Math.max(of[at + 3 + i], by[from + 3 + i]);
        }
    }
}
