package robosim.geometry.index.boxes;

import org.jspecify.annotations.Nullable;

/**
 * Boxes that are given once, such as those of a mesh's triangles, in a binary tree that is then only read: any number of
 * threads may share it.
 *
 * <p>A box is six numbers: min x, min y, min z, max x, max y, max z; closed. Nodes stand beside each other in one array of
 * floats, the two parts of a node next to each other: {@link #STRIDE} numbers each, the middle of the node's box, its half
 * sizes, and two counts. They are measured in the tree's own units from the middle of all boxes, so that all of them lie
 * within 1 of it, whatever the size and the place of the boxes; half sizes are rounded outward.
 */
public final class BoxTree {
    /** Floats of a node. */
    public static final int STRIDE = 8;

    /** Where in a node the half sizes begin; the middle is at 0. */
    public static final int HALF = 3;

    /** Where a node says where its parts begin, or a leaf where its items do, as the bits of an int. */
    public static final int LINK = 6;

    /** Where a node says how many items it has as a leaf, as the bits of an int; 0 where it is none. */
    public static final int COUNT = 7;

    /** Most items of a leaf. */
    public static final int LEAF = 4;

    /** Most nodes between the root and a leaf, both counted. */
    public static final int MAX_DEPTH = BoxTreeBuilder.MAX_DEPTH;

    private final float[] nodes;
    private final int[] order;
    private final double[] bounds;
    private final double[] origin;
    private final double unit;
    private final double reach;
    private final double scale;
    private volatile @Nullable WideTree wide;

    /**
     * Builds the tree.
     *
     * @param boxes six numbers for each of at least one item
     * @throws IllegalArgumentException where there is no box, or one is not finite or inside out
     */
    public BoxTree(double[] boxes) {
        BoxTreeBuilder builder = new BoxTreeBuilder(boxes);
        nodes = builder.nodes();
        order = builder.order();
        bounds = builder.bounds();
        origin = builder.origin();
        scale = builder.scale();
        unit = 1 / scale;
        double sum = 0;
        for (double bound : bounds) {
            sum += Math.abs(bound);
        }
        reach = sum;
    }

    /** How many items there are. */
    public int size() {
        return order.length;
    }

    /** How many nodes there are. */
    public int nodes() {
        return nodes.length / STRIDE;
    }

    public int root() {
        return 0;
    }

    public boolean isLeaf(int node) {
        return count(node) > 0;
    }

    /** The left part of a node that is no leaf. */
    public int left(int node) {
        return link(node);
    }

    /** The right part of a node that is no leaf. */
    public int right(int node) {
        return link(node) + 1;
    }

    /** Where the items of a leaf begin: they are {@code item(first)} to {@code item(first + count - 1)}. */
    public int first(int leaf) {
        return link(leaf);
    }

    private int link(int node) {
        return Float.floatToRawIntBits(nodes[STRIDE * node + LINK]);
    }

    /** How many items a leaf has; 0 for a node that is none. */
    public int count(int node) {
        return Float.floatToRawIntBits(nodes[STRIDE * node + COUNT]);
    }

    /** The item at a place of the leaves' order: its index among the boxes given. */
    public int item(int place) {
        return order[place];
    }

    /** The same with up to four parts a node, made when first asked. */
    public WideTree wide() {
        WideTree made = wide;
        if (made == null) {
            synchronized (this) {
                made = wide;
                if (made == null) {
                    made = new WideTree(this);
                    wide = made;
                }
            }
        }
        return made;
    }

    /** The nodes' numbers. The tree's own array: read only. */
    public float[] numbers() {
        return nodes;
    }

    /** The middle of a node's box on an axis (0 to 2), off by no more than one rounding. */
    public double middle(int node, int axis) {
        return origin[axis] + nodes[STRIDE * node + axis] * unit;
    }

    /** How far a node's box reaches from its middle on an axis (0 to 2), not counting the middle's rounding. */
    public double half(int node, int axis) {
        return nodes[STRIDE * node + HALF + axis] * unit;
    }

    /** The tight bounds of all items, six numbers. The tree's own array: read only. */
    public double[] bounds() {
        return bounds;
    }

    /** The sum of the magnitudes of {@link #bounds()}. */
    public double reach() {
        return reach;
    }

    /** Where on an axis (0 to 2) the tree measures from. */
    public double origin(int axis) {
        return origin[axis];
    }

    /** By what lengths are multiplied to become the tree's: a power of two. */
    public double scale() {
        return scale;
    }
}
