package robosim.geometry.index;

import java.util.Arrays;

/** Builds a {@link BoxTree}: cuts where the surface area heuristic over sixteen bins says, in half where it cannot. */
final class BoxTreeBuilder {
    private static final int BINS = 16;
    /** From here down every cut is in half: the depth stays below this and the 31 halvings of any array. */
    private static final int HEURISTIC_DEPTH = 48;

    static final int MAX_DEPTH = HEURISTIC_DEPTH + 32;

    private final double[] boxes;
    private final int[] order;
    private double[] bounds;
    private int[] counts;
    private int[] links;
    private int nodes;

    private final double[] span = new double[6];
    private final double[] binBounds = new double[6 * BINS];
    private final int[] binCounts = new int[BINS];
    private final double[] areaRight = new double[BINS];

    BoxTreeBuilder(double[] boxes) {
        if (boxes.length == 0 || boxes.length % 6 != 0) {
            throw new IllegalArgumentException(
                    "boxes must be six numbers for each of at least one item (got: " + boxes.length + " numbers)");
        }
        for (int i = 0; i < boxes.length; i++) {
            if (!Double.isFinite(boxes[i]) || (i % 6 >= 3 && boxes[i] < boxes[i - 3])) {
                throw new IllegalArgumentException(
                        "box must be finite and min at most max (got: " + boxes[i] + " in box " + i / 6 + ")");
            }
        }
        this.boxes = boxes;
        int n = boxes.length / 6;
        order = new int[n];
        Arrays.setAll(order, i -> i);
        bounds = new double[6 * (2 * n - 1)];
        counts = new int[2 * n - 1];
        links = new int[2 * n - 1];
        build(0, n, 0);
        bounds = Arrays.copyOf(bounds, 6 * nodes);
        counts = Arrays.copyOf(counts, nodes);
        links = Arrays.copyOf(links, nodes);
    }

    double[] bounds() {
        return bounds;
    }

    int[] counts() {
        return counts;
    }

    int[] links() {
        return links;
    }

    int[] order() {
        return order;
    }

    private int build(int from, int to, int depth) {
        int node = nodes++;
        empty(bounds, 6 * node);
        for (int k = from; k < to; k++) {
            grow(bounds, 6 * node, boxes, 6 * order[k]);
        }
        if (to - from <= BoxTree.LEAF) {
            counts[node] = to - from;
            links[node] = from;
            return node;
        }
        int middle = split(from, to, depth);
        build(from, middle, depth + 1);
        links[node] = build(middle, to, depth + 1);
        return node;
    }

    private int split(int from, int to, int depth) {
        int axis = longestAxis(from, to);
        double low = span[axis];
        double extent = span[axis + 3] - low;
        int half = (from + to) >>> 1;
        if (extent == 0) {
            return half; // all in one place: any half is as good
        }
        if (depth < HEURISTIC_DEPTH) {
            double scale = BINS / extent;
            if (Double.isFinite(scale)) {
                int cut = bestCut(from, to, axis, low, scale);
                int middle = partition(from, to, axis, low, scale, cut);
                if (middle > from && middle < to) {
                    return middle;
                }
            }
        }
        select(from, to - 1, half, axis);
        return half;
    }

    private int longestAxis(int from, int to) {
        empty(span, 0);
        for (int k = from; k < to; k++) {
            for (int axis = 0; axis < 3; axis++) {
                double centre = centre(order[k], axis);
                span[axis] = Math.min(span[axis], centre);
                span[axis + 3] = Math.max(span[axis + 3], centre);
            }
        }
        double x = span[3] - span[0];
        double y = span[4] - span[1];
        double z = span[5] - span[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    // The bin at which the right part begins, by the least sum of area times items.
    private int bestCut(int from, int to, int axis, double low, double scale) {
        Arrays.fill(binCounts, 0);
        for (int bin = 0; bin < BINS; bin++) {
            empty(binBounds, 6 * bin);
        }
        for (int k = from; k < to; k++) {
            int bin = bin(order[k], axis, low, scale);
            binCounts[bin]++;
            grow(binBounds, 6 * bin, boxes, 6 * order[k]);
        }
        empty(span, 0);
        int right = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            right += binCounts[bin];
            grow(span, 0, binBounds, 6 * bin);
            areaRight[bin] = right == 0 ? Double.POSITIVE_INFINITY : right * area(span);
        }
        empty(span, 0);
        int left = 0;
        int best = BINS / 2;
        double least = Double.POSITIVE_INFINITY;
        for (int bin = 1; bin < BINS; bin++) {
            left += binCounts[bin - 1];
            grow(span, 0, binBounds, 6 * (bin - 1));
            double cost = left == 0 ? Double.POSITIVE_INFINITY : left * area(span) + areaRight[bin];
            if (cost < least) {
                least = cost;
                best = bin;
            }
        }
        return best;
    }

    // Keeps the order within each part, so equal input gives equal trees whatever the cut.
    private int partition(int from, int to, int axis, double low, double scale, int cut) {
        int[] behind = new int[to - from];
        int left = from;
        int right = 0;
        for (int k = from; k < to; k++) {
            if (bin(order[k], axis, low, scale) < cut) {
                order[left++] = order[k];
            } else {
                behind[right++] = order[k];
            }
        }
        System.arraycopy(behind, 0, order, left, right);
        return left;
    }

    private int bin(int item, int axis, double low, double scale) {
        return Math.min(BINS - 1, (int) ((centre(item, axis) - low) * scale));
    }

    // Hoare's selection: order[k] gets the item that sorting by centre would put there, smaller ones before it.
    private void select(int from, int to, int k, int axis) {
        int low = from;
        int high = to;
        while (low < high) {
            double pivot = centre(order[(low + high) >>> 1], axis);
            int i = low;
            int j = high;
            while (i <= j) {
                while (centre(order[i], axis) < pivot) {
                    i++;
                }
                while (centre(order[j], axis) > pivot) {
                    j--;
                }
                if (i <= j) {
                    int swapped = order[i];
                    order[i++] = order[j];
                    order[j--] = swapped;
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

    private double centre(int item, int axis) {
        return 0.5 * boxes[6 * item + axis] + 0.5 * boxes[6 * item + axis + 3];
    }

    private static double area(double[] of) {
        double x = of[3] - of[0];
        double y = of[4] - of[1];
        double z = of[5] - of[2];
        return x * y + y * z + z * x;
    }

    private static void empty(double[] of, int at) {
        Arrays.fill(of, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(of, at + 3, at + 6, Double.NEGATIVE_INFINITY);
    }

    private static void grow(double[] of, int at, double[] by, int from) {
        for (int i = 0; i < 3; i++) {
            of[at + i] = Math.min(of[at + i], by[from + i]);
            of[at + 3 + i] = Math.max(of[at + 3 + i], by[from + 3 + i]);
        }
    }
}
