package robosim.geometry.index.meshes;

import java.util.Arrays;

/**
 * Splits ranges of boxes in two by the surface area heuristic over sixteen bins of each axis (Wald 2007), or in half where
 * that does not apply; a few boxes, between any two of them in their order along an axis. The items are reordered as they
 * are split.
 */
public final class SurfaceAreaSplits {
    private static final int BINS = 16;

    /** From this depth on every split is in half. */
    static final int HEURISTIC_DEPTH = 48;

    private static final int BOX = 6;

    private final float[] boxes;
    private final int[] items;

    // The bounds of the range measured last, and of twice the centres of its boxes.
    private final float[] range = new float[BOX];
    private final float[] middles = new float[BOX];

    private final float[] binBounds = new float[BOX * BINS];
    private final int[] binCounts = new int[BINS];
    private final double[] costRight = new double[BINS];
    private final float[] grown = new float[BOX];

    /** So few items are sorted along each axis: fewer than bins. */
    private static final int SORTED = 8;

    // The few items in their order along an axis, in the best order so far, and as they were.
    private final int[] order = new int[SORTED];
    private final int[] bestOrder = new int[SORTED];
    private final int[] fewItems = new int[SORTED];
    private final float[] fewBoxes = new float[BOX * SORTED];

    private final int few;

    // The best split of the range measured last.
    private double leastCost;
    private int bestAxis;
    private int bestBin;

    /**
     * Takes the boxes, six floats for each item, and reorders them.
     *
     * @param items what the boxes belong to
     * @param few ranges of at most so many items are binned along all axes, larger ones along that of the greatest extent only,
     *     which is nearly as good
     */
    public SurfaceAreaSplits(float[] boxes, int[] items, int few) {
        this.boxes = boxes;
        this.items = items;
        this.few = few;
    }

    /** The item at a place. */
    public int item(int place) {
        return items[place];
    }

    /** Takes the bounds of a range. */
    public void measure(int from, int to) {
        for (int axis = 0; axis < 3; axis++) {
            measure(from, to, axis);
        }
    }

    private void measure(int from, int to, int axis) {
        float least = Float.POSITIVE_INFINITY;
        float most = Float.NEGATIVE_INFINITY;
        float leastMiddle = Float.POSITIVE_INFINITY;
        float mostMiddle = Float.NEGATIVE_INFINITY;
        for (int k = BOX * from + axis; k < BOX * to; k += BOX) {
            float low = boxes[k];
            float high = boxes[k + 3];
            float middle = low + high;
            least = low < least ? low : least;
            most = high > most ? high : most;
            leastMiddle = middle < leastMiddle ? middle : leastMiddle;
            mostMiddle = middle > mostMiddle ? middle : mostMiddle;
        }
        range[axis] = least;
        range[axis + 3] = most;
        middles[axis] = leastMiddle;
        middles[axis + 3] = mostMiddle;
    }

    /** Writes the bounds of the range measured last, six floats. */
    public void copyBounds(float[] to, int at) {
        System.arraycopy(range, 0, to, at, BOX);
    }

    /** Writes the bounds of twice the centres of the boxes of the range measured last, six floats. */
    public void copyMiddles(float[] to, int at) {
        System.arraycopy(middles, 0, to, at, BOX);
    }

    /** Half the surface area of the bounds of the range measured last. */
    public double area() {
        return area(range, 0);
    }

    /**
     * Splits a range of at least two items that has been measured; returns where the second part begins, and neither is empty.
     *
     * @param bounds what {@link #copyBounds} wrote
     * @param centres what {@link #copyMiddles} wrote
     * @param at where both begin
     */
    public int split(int from, int to, int depth, float[] bounds, float[] centres, int at) {
        if (to - from == 2) {
            return from + 1;
        }
        System.arraycopy(bounds, at, range, 0, BOX);
        System.arraycopy(centres, at, middles, 0, BOX);
        if (to - from <= SORTED && depth < HEURISTIC_DEPTH) {
            return splitFew(from, to);
        }
        cost(from, to, depth);
        return divide(from, to);
    }

    /** Splits a range of a few items, sorted along the axis where that is best. */
    private int splitFew(int from, int to) {
        int size = to - from;
        leastCost = Double.POSITIVE_INFINITY;
        int left = size / 2;
        for (int k = 0; k < size; k++) {
            bestOrder[k] = k;
        }
        for (int axis = 0; axis < 3; axis++) {
            if (middles[axis] < middles[axis + 3]) {
                sort(from, size, axis);
                int best = cheapest(from, size);
                left = best > 0 ? best : left;
            }
        }
        System.arraycopy(items, from, fewItems, 0, size);
        System.arraycopy(boxes, BOX * from, fewBoxes, 0, BOX * size);
        for (int k = 0; k < size; k++) {
            items[from + k] = fewItems[bestOrder[k]];
            System.arraycopy(fewBoxes, BOX * bestOrder[k], boxes, BOX * (from + k), BOX);
        }
        return from + left;
    }

    private void sort(int from, int size, int axis) {
        for (int k = 0; k < size; k++) {
            float middle = middle(from + k, axis);
            int place = k;
            while (place > 0 && middle(from + order[place - 1], axis) > middle) {
                order[place] = order[place - 1];
                place--;
            }
            order[place] = k;
        }
    }

    /** How many of the sorted items should be in the first part; 0 where no split is better than those found so far. */
    private int cheapest(int from, int size) {
        empty(grown, 0);
        for (int k = size - 1; k > 0; k--) {
            grow(grown, 0, boxes, BOX * (from + order[k]));
            costRight[k] = (size - k) * area(grown, 0);
        }
        empty(grown, 0);
        int best = 0;
        for (int k = 1; k < size; k++) {
            grow(grown, 0, boxes, BOX * (from + order[k - 1]));
            double cost = k * area(grown, 0) + costRight[k];
            if (cost < leastCost) {
                leastCost = cost;
                best = k;
            }
        }
        if (best > 0) {
            System.arraycopy(order, 0, bestOrder, 0, size);
        }
        return best;
    }

    /**
     * Finds the best split of the range measured last.
     *
     * @return the sum over its parts of area times number of items; infinite where the heuristic does not apply
     */
    double cost(int from, int to, int depth) {
        leastCost = Double.POSITIVE_INFINITY;
        int longest = longestAxis();
        bestAxis = longest;
        if (depth < HEURISTIC_DEPTH) {
            for (int axis = 0; axis < 3; axis++) {
                if ((to - from <= few || axis == longest) && isWide(axis)) {
                    tryAxis(from, to, axis);
                }
            }
        }
        return leastCost;
    }

    /** Splits the range measured last as {@link #cost} found best; returns where the second part begins. */
    int divide(int from, int to) {
        if (leastCost < Double.POSITIVE_INFINITY) {
            int middle = partition(from, to, bestAxis, bestBin);
            if (middle > from && middle < to) {
                return middle;
            }
        }
        int half = (from + to) >>> 1;
        select(from, to - 1, half, bestAxis);
        return half;
    }

    private int longestAxis() {
        float x = middles[3] - middles[0];
        float y = middles[4] - middles[1];
        float z = middles[5] - middles[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Whether centres differ along an axis, and by so much that bins can be told apart. */
    private boolean isWide(int axis) {
        float scaling = scaling(axis);
        return scaling > 0 && scaling < Float.POSITIVE_INFINITY;
    }

    private float scaling(int axis) {
        return BINS / (middles[axis + 3] - middles[axis]);
    }

    /** Finds the bin along an axis at which the second part should begin, if it is better than those found so far. */
    private void tryAxis(int from, int to, int axis) {
        float low = middles[axis];
        float scaling = scaling(axis);
        Arrays.fill(binCounts, 0);
        for (int bin = 0; bin < BINS; bin++) {
            empty(binBounds, BOX * bin);
        }
        for (int k = from; k < to; k++) {
            int bin = bin(k, axis, low, scaling);
            binCounts[bin]++;
            grow(binBounds, BOX * bin, boxes, BOX * k);
        }
        empty(grown, 0);
        int right = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            right += binCounts[bin];
            grow(grown, 0, binBounds, BOX * bin);
            costRight[bin] = right == 0 ? Double.POSITIVE_INFINITY : right * area(grown, 0);
        }
        empty(grown, 0);
        int left = 0;
        for (int bin = 1; bin < BINS; bin++) {
            left += binCounts[bin - 1];
            grow(grown, 0, binBounds, BOX * (bin - 1));
            double cost = left == 0 ? Double.POSITIVE_INFINITY : left * area(grown, 0) + costRight[bin];
            if (cost < leastCost) {
                leastCost = cost;
                bestAxis = axis;
                bestBin = bin;
            }
        }
    }

    private int partition(int from, int to, int axis, int cut) {
        float low = middles[axis];
        float scaling = scaling(axis);
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
        int item = items[p];
        items[p] = items[q];
        items[q] = item;
        for (int k = 0; k < BOX; k++) {
            float number = boxes[BOX * p + k];
            boxes[BOX * p + k] = boxes[BOX * q + k];
            boxes[BOX * q + k] = number;
        }
    }

    private int bin(int place, int axis, float low, float scaling) {
        return Math.min(BINS - 1, (int) ((middle(place, axis) - low) * scaling));
    }

    // Hoare's selection: place k gets the item that sorting by centre would put there, with smaller ones before it.
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
        return boxes[BOX * place + axis] + boxes[BOX * place + 3 + axis];
    }

    private static double area(float[] of, int at) {
        double x = (double) of[at + 3] - of[at];
        double y = (double) of[at + 4] - of[at + 1];
        double z = (double) of[at + 5] - of[at + 2];
        return x * y + y * z + z * x;
    }

    private static void empty(float[] of, int at) {
        Arrays.fill(of, at, at + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(of, at + 3, at + 6, Float.NEGATIVE_INFINITY);
    }

    private static void grow(float[] of, int at, float[] by, int from) {
        for (int i = 0; i < 3; i++) {
            if (by[from + i] < of[at + i]) {
                of[at + i] = by[from + i];
            }
            if (by[from + 3 + i] > of[at + 3 + i]) {
                of[at + 3 + i] = by[from + 3 + i];
            }
        }
    }
}
