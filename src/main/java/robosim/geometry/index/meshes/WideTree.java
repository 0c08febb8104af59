package robosim.geometry.index.meshes;

/**
 * A {@link BoxTree} made for rays, with up to four children per node. A descent must wait for memory and for the result of
 * each node before it can go on to the next; here there are less than half as many nodes to wait for. Immutable: any number
 * of threads may share it.
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

    /** The most items below a link, more than in a leaf of the {@link BoxTree}: a node is much slower than an item. */
    static final int LEAF = 8;

    private final float[] numbers;

    /** Builds the tree. */
    public WideTree(BoxTree tree) {
        numbers = new WideTreeBuilder(tree).build();
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
    static int link(int first, int items) {
        return Integer.MIN_VALUE | (LEAF * first + items - 1);
    }
}
