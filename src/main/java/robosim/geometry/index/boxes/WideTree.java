package robosim.geometry.index.boxes;

import java.util.Arrays;

/**
 * A {@link BoxTree} with up to four children per node. A descent must wait for memory and for the result of each node
 * before it can go on to the next; here there are half as many nodes to wait for. Immutable: any number of threads may
 * share it.
 *
 * <p>A node has {@link #STRIDE} floats, {@link #PART} for each child: centre and half sizes as in the {@link BoxTree},
 * and a link, as the bits of an int. The link is where the child's own node begins or, if negative, encodes its items.
 * A missing child has half sizes so far below 0 that no line meets it, even if it is widened by less than {@link
 * #MISSING}. The root begins at 0.
 */
public final class WideTree {
    /** Number of floats in a node. */
    public static final int STRIDE = 32;

    /** Number of floats for one child. */
    public static final int PART = 8;

    /** Offset of a child's half sizes; the centre is at 0. */
    public static final int HALF = 3;

    /** Offset of a child's link. */
    public static final int LINK = 6;

    /** How far below 0 the half sizes of a missing child are. */
    public static final float MISSING = 8;

    private static final int PARTS = STRIDE / PART;

    /** The number of items that a link has room for. */
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

    /** The numbers of the nodes. The internal array: read only. */
    public float[] numbers() {
        return numbers;
    }

    /** The position of the first item that a negative link encodes. */
    public static int first(int link) {
        return (link & Integer.MAX_VALUE) / LEAF;
    }

    /** The position of the last item that a negative link encodes. */
    public static int last(int link) {
        return first(link) + (link & Integer.MAX_VALUE) % LEAF;
    }

    /**
     * Made negative by setting the sign bit alone: the complement could be a NaN as a float, whose bits may be lost.
     */
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

    /** Collects the children of a node in order: splits the largest as long as there is room. */
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

    /** The child with the largest surface that is not a leaf; -1 if all are leaves. */
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
