package robosim.geometry.narrow.leaf;

import java.util.Arrays;

/**
 * The bounds of the leaves of a column, asked which of them meet a box or come near it: one by one if there are few, else by a
 * tree that is laid out at the first question. Nothing is allocated once the arrays have grown.
 */
public final class LeafBoxes {
    /** So many are looked at one by one. */
    private static final int FEW = 12;

    /** A node of the tree that has more is divided. */
    private static final int IN_NODE = 4;

    private double[] boxes = {};
    private int size;
    private boolean isFlat;
    private boolean isBuilt;

    /** The leaves, so that each node of the tree has those of a range. */
    private int[] order = {};

    /** The bounds of the nodes; those below node k are 2 k + 1 and 2 k + 2. */
    private double[] nodes = {};

    private int[] found = {};
    private int count;

    /** The box of the query: minimum x, y and z, then maximum. A query may change it. */
    public final double[] box = new double[6];

    private double square;

    /**
     * Begins with so many leaves, whose boxes are to be {@link #set}.
     *
     * @param ignoresHeights whether boxes are compared as seen from above
     */
    public void clear(int leaves, boolean ignoresHeights) {
        size = leaves;
        isFlat = ignoresHeights;
        isBuilt = false;
        if (6 * leaves > boxes.length) {
            boxes = new double[6 * Math.max(FEW, leaves + (leaves >> 1))];
        }
    }

    /** How many leaves there are. */
    public int size() {
        return size;
    }

    /** Sets the bounds of a leaf: minimum x, y and z, then maximum. */
    public void set(int leaf, double[] bounds) {
        int at = 6 * leaf;
        System.arraycopy(bounds, 0, boxes, at, 6);
        if (isFlat) {
            boxes[at + 1] = 0;
            boxes[at + 4] = 0;
        }
    }

    /** Sets the bounds of all leaves of a part of a column, as they stand. */
    public void setAll(LeafColumn column, int first, int leaves, boolean ignoresHeights) {
        clear(leaves, ignoresHeights);
        for (int k = 0; k < leaves; k++) {
            column.bounds(first + k, box);
            set(k, box);
        }
    }

    /**
     * Finds the leaves whose bounds meet the {@link #box} widened by a slack; see {@link #found}.
     *
     * @return how many there are
     */
    public int meeting(double slack) {
        for (int k = 0; k < 3; k++) {
            box[k] -= slack;
            box[3 + k] += slack;
        }
        square = 0;
        return find();
    }

    /** Finds the leaves whose bounds may be at most so far from the {@link #box}, rounding allowed for. */
    public int within(double distance) {
        square = distance * distance * (1 + 0x1p-40) + Double.MIN_NORMAL;
        return find();
    }

    /** The k-th leaf that was found, in ascending order. */
    public int found(int k) {
        return found[k];
    }

    private int find() {
        if (isFlat) {
            box[1] = 0;
            box[4] = 0;
        }
        count = 0;
        if (size <= FEW) {
            for (int k = 0; k < size; k++) {
                if (isNear(boxes, k)) {
                    add(k);
                }
            }
            return count;
        }
        if (!isBuilt) {
            build();
        }
        descend(0, 0, size);
        Arrays.sort(found, 0, count);
        return count;
    }

    private void add(int leaf) {
        if (count == found.length) {
            found = Arrays.copyOf(found, Math.max(FEW, 2 * count));
        }
        found[count++] = leaf;
    }

    private boolean isNear(double[] of, int which) {
        int at = 6 * which;
        double x = Math.max(of[at] - box[3], box[0] - of[at + 3]);
        double y = Math.max(of[at + 1] - box[4], box[1] - of[at + 4]);
        double z = Math.max(of[at + 2] - box[5], box[2] - of[at + 5]);
        if (x <= 0 && y <= 0 && z <= 0) {
            return true;
        }
        if (square == 0) {
            return false;
        }
        double gapX = Math.max(0, x);
        double gapY = Math.max(0, y);
        double gapZ = Math.max(0, z);
        return gapX * gapX + gapY * gapY + gapZ * gapZ <= square;
    }

    private void descend(int node, int from, int to) {
        if (!isNear(nodes, node)) {
            return;
        }
        if (to - from <= IN_NODE) {
            for (int k = from; k < to; k++) {
                if (isNear(boxes, order[k])) {
                    add(order[k]);
                }
            }
            return;
        }
        int middle = (from + to) >>> 1;
        descend(2 * node + 1, from, middle);
        descend(2 * node + 2, middle, to);
    }

    private void build() {
        if (order.length < size) {
            order = new int[size + (size >> 1)];
            nodes = new double[12 * Integer.highestOneBit(order.length)];
        }
        for (int k = 0; k < size; k++) {
            order[k] = k;
        }
        build(0, 0, size);
        isBuilt = true;
    }

    private void build(int node, int from, int to) {
        int at = 6 * node;
        Arrays.fill(nodes, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(nodes, at + 3, at + 6, Double.NEGATIVE_INFINITY);
        for (int k = from; k < to; k++) {
            int leaf = 6 * order[k];
            for (int axis = 0; axis < 3; axis++) {
                nodes[at + axis] = Math.min(nodes[at + axis], boxes[leaf + axis]);
                nodes[at + 3 + axis] = Math.max(nodes[at + 3 + axis], boxes[leaf + 3 + axis]);
            }
        }
        if (to - from <= IN_NODE) {
            return;
        }
        int axis = longest(at);
        int middle = (from + to) >>> 1;
        select(from, to - 1, middle, axis);
        build(2 * node + 1, from, middle);
        build(2 * node + 2, middle, to);
    }

    private int longest(int at) {
        double x = nodes[at + 3] - nodes[at];
        double y = nodes[at + 4] - nodes[at + 1];
        double z = nodes[at + 5] - nodes[at + 2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Twice the middle of a leaf's bounds. */
    private double key(int place, int axis) {
        int at = 6 * order[place] + axis;
        return boxes[at] + boxes[at + 3];
    }

    /** Puts the leaves before a place that come before it along an axis (Hoare's selection). */
    private void select(int first, int last, int place, int axis) {
        int from = first;
        int to = last;
        while (from < to) {
            double pivot = key((from + to) >>> 1, axis);
            int low = from;
            int high = to;
            while (low <= high) {
                while (key(low, axis) < pivot) {
                    low++;
                }
                while (key(high, axis) > pivot) {
                    high--;
                }
                if (low <= high) {
                    int swapped = order[low];
                    order[low++] = order[high];
                    order[high--] = swapped;
                }
            }
            if (place <= high) {
                to = high;
            } else if (place >= low) {
                from = low;
            } else {
                return;
            }
        }
    }
}
