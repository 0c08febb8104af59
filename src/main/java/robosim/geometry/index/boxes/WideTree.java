package robosim.geometry.index.boxes;

import java.util.Arrays;

/**
 * A {@link BoxTree} with up to four parts a node, for what descends it part by part and waits for memory and for the
 * outcome of each node before it can turn to the next: there are half as many to wait for. Only read: any number of
 * threads may share it.
 *
 * <p>A node is {@link #STRIDE} floats, {@link #PART} for each of its parts: middle and half sizes as in the nodes of the
 * {@link BoxTree} they are taken from, and a link, as the bits of an int. That is where the part's own node begins or,
 * where it is negative, stands for its items. A part that is missing has half sizes so far below 0 that no line meets it
 * even where it is widened by less than {@link #MISSING}. The root begins at 0.
 */
public final class WideTree {
    /** Floats of a node. */
    public static final int STRIDE = 32;

    /** Floats of a part. */
    public static final int PART = 8;

    /** Where a part's half sizes begin; the middle is at 0. */
    public static final int HALF = 3;

    /** Where a part's link is. */
    public static final int LINK = 6;

    /** How far below 0 the half sizes of a missing part are. */
    public static final float MISSING = 8;

    private static final int PARTS = STRIDE / PART;

    /** How many items a link has room for. */
    private static final int LEAF = BoxTree.LEAF;

    private final BoxTree tree;
    private final int[] parts = new int[PARTS];
    private float[] numbers;
    private int count = 1;

    WideTree(BoxTree tree) {
        this.tree = tree;
        numbers = new float[STRIDE * Math.max(1, tree.nodes() / 4)];
        fill(0, tree.root());
        numbers = Arrays.copyOf(numbers, STRIDE * count);
    }

    /** The nodes' numbers. The tree's own array: read only. */
    public float[] numbers() {
        return numbers;
    }

    /** The place of the first item that a negative link stands for. */
    public static int first(int link) {
        return (link & Integer.MAX_VALUE) / LEAF;
    }

    /** The place of the last item that a negative link stands for. */
    public static int last(int link) {
        return first(link) + (link & Integer.MAX_VALUE) % LEAF;
    }

    /** Below 0 by the sign alone: as a float the complement could be no number, the bits of which may be lost. */
    private static int link(int first, int items) {
        return Integer.MIN_VALUE | (LEAF * first + items - 1);
    }

    private void fill(int wide, int node) {
        int size = gather(node);
        int first = count;
        for (int k = 0; k < PARTS; k++) {
            int at = STRIDE * wide + PART * k;
            if (k >= size) {
                Arrays.fill(numbers, at + HALF, at + LINK, -MISSING);
                continue;
            }
            int part = parts[k];
            System.arraycopy(tree.numbers(), BoxTree.STRIDE * part, numbers, at, LINK);
            int link = tree.isLeaf(part) ? link(tree.first(part), tree.count(part)) : STRIDE * count++;
            numbers[at + LINK] = Float.intBitsToFloat(link);
        }
        if (STRIDE * count > numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * STRIDE * count);
        }
        int inner = 0;
        int[] own = parts.clone();
        for (int k = 0; k < size; k++) {
            if (!tree.isLeaf(own[k])) {
                fill(first + inner++, own[k]);
            }
        }
    }

    /** Puts what is to be the parts of a node in their order: divides the largest as long as there is room. */
    private int gather(int node) {
        parts[0] = node;
        int size = 1;
        int largest = tree.isLeaf(node) ? -1 : 0;
        while (largest >= 0 && size < PARTS) {
            int divided = parts[largest];
            System.arraycopy(parts, largest + 1, parts, largest + 2, size - largest - 1);
            parts[largest] = tree.left(divided);
            parts[largest + 1] = tree.right(divided);
            size++;
            largest = largest(size);
        }
        return size;
    }

    /** The part with the largest surface among those that are no leaves; -1 where all are. */
    private int largest(int size) {
        int best = -1;
        for (int k = 0; k < size; k++) {
            if (!tree.isLeaf(parts[k]) && (best < 0 || area(parts[k]) > area(parts[best]))) {
                best = k;
            }
        }
        return best;
    }

    private float area(int node) {
        float[] of = tree.numbers();
        int at = BoxTree.STRIDE * node + BoxTree.HALF;
        return of[at] * of[at + 1] + of[at + 1] * of[at + 2] + of[at + 2] * of[at];
    }
}
