package robosim.geometry.index.meshes;

/**
 * An immutable binary tree over boxes, such as those of a mesh's triangles; any number of threads may share it.
 *
 * <p>A box is six numbers: min x, min y, min z, max x, max y, max z; closed. The nodes are in one array of floats, the
 * two children of a node adjacent, {@link #STRIDE} numbers each: the centre of the node's box, its half sizes, and two
 * counts. They are in the tree's own units, relative to the centre of all boxes, so that all lie within 1 of it,
 * whatever the size and the position of the boxes; half sizes are rounded outward.
 */
public final class BoxTree {
    /** Number of floats in a node. */
    public static final int STRIDE = 8;

    /** Offset of the half sizes in a node; the centre is at 0. */
    public static final int HALF = 3;

    /** Offset of a node's link: where its children begin, or for a leaf its items, as the bits of an int. */
    public static final int LINK = 6;

    /** Offset of a leaf's number of items, as the bits of an int; 0 for an inner node. */
    public static final int COUNT = 7;

    /** Maximum number of items in a leaf. */
    public static final int LEAF = 4;

    /** Maximum number of nodes from the root to a leaf, both included. */
    public static final int MAX_DEPTH = BoxTreeBuilder.MAX_DEPTH;

    private final float[] nodes;
    private final int[] order;
    private final double[] bounds;
    private final double[] origin;
    private final double unit;
    private final double reach;
    private final double scale;

    /**
     * Builds the tree.
     *
     * @param boxes six numbers for each of at least one item
     * @throws IllegalArgumentException if there is no box, or one is not finite or inverted
     */
    public BoxTree(double[] boxes) {
        BoxTreeBuilder builder = new BoxTreeBuilder(boxes);
        nodes = builder.nodes;
        order = builder.order;
        bounds = builder.bounds;
        origin = builder.origin;
        scale = builder.scale;
        unit = 1 / scale;
        double sum = 0;
        for (double bound : bounds) {
            sum += Math.abs(bound);
        }
        reach = sum;
    }

    /** The number of items. */
    public int size() {
        return order.length;
    }

    /** The number of nodes. */
    public int nodes() {
        return nodes.length / STRIDE;
    }

    public int root() {
        return 0;
    }

    public boolean isLeaf(int node) {
        return count(node) > 0;
    }

    /** The left child of an inner node. */
    public int left(int node) {
        return link(node);
    }

    /** The right child of an inner node. */
    public int right(int node) {
        return link(node) + 1;
    }

    /** The index of a leaf's first item: its items are {@code item(first)} to {@code item(first + count - 1)}. */
    public int first(int leaf) {
        return link(leaf);
    }

    private int link(int node) {
        return Float.floatToRawIntBits(nodes[STRIDE * node + LINK]);
    }

    /** The number of items of a leaf; 0 for an inner node. */
    public int count(int node) {
        return Float.floatToRawIntBits(nodes[STRIDE * node + COUNT]);
    }

    /** The item at a position in the order of the leaves, as its index among the boxes given. */
    public int item(int place) {
        return order[place];
    }

    /** The numbers of the nodes. The internal array: read only. */
    public float[] numbers() {
        return nodes;
    }

    /** The centre of a node's box on an axis (0 to 2), with at most one rounding. */
    public double middle(int node, int axis) {
        return origin[axis] + nodes[STRIDE * node + axis] * unit;
    }

    /** The half size of a node's box on an axis (0 to 2), which does not cover the rounding of the centre. */
    public double half(int node, int axis) {
        return nodes[STRIDE * node + HALF + axis] * unit;
    }

    /** The tight bounds of all items, six numbers. The internal array: read only. */
    public double[] bounds() {
        return bounds;
    }

    /** The sum of the magnitudes of {@link #bounds()}. */
    public double reach() {
        return reach;
    }

    /** The origin of the tree's units on an axis (0 to 2). */
    public double origin(int axis) {
        return origin[axis];
    }

    /** The factor from world units to the tree's units: a power of two. */
    public double scale() {
        return scale;
    }
}
