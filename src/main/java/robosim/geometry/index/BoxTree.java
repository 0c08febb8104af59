package robosim.geometry.index;

/**
 * Boxes that are given once, such as those of a mesh's triangles, in a binary tree that is then only read: it may be
 * shared by any number of threads, each with cursors of its own.
 *
 * <p>A box is six numbers: min x, min y, min z, max x, max y, max z; closed, and already rounded outward. Nodes and items
 * stand in flat arrays in the order of a descent that goes left first.
 */
public final class BoxTree {
    /** Most items of a leaf that is worth cutting. */
    static final int LEAF = 4;

    final double[] bounds;
    final double[] itemBounds;
    private final int[] counts;
    private final int[] links;
    private final int[] order;

    /**
     * Builds the tree.
     *
     * @param boxes six numbers for each of at least one item
     * @throws IllegalArgumentException where there is no box, or one is not finite or inside out
     */
    public BoxTree(double[] boxes) {
        BoxTreeBuilder builder = new BoxTreeBuilder(boxes);
        bounds = builder.bounds();
        counts = builder.counts();
        links = builder.links();
        order = builder.order();
        itemBounds = new double[6 * order.length];
        for (int k = 0; k < order.length; k++) {
            System.arraycopy(boxes, 6 * order[k], itemBounds, 6 * k, 6);
        }
    }

    /** How many items there are. */
    public int size() {
        return order.length;
    }

    /** How many nodes there are. */
    public int nodes() {
        return counts.length;
    }

    public int root() {
        return 0;
    }

    public boolean isLeaf(int node) {
        return counts[node] > 0;
    }

    /** The left part of a node that is no leaf. */
    public int left(int node) {
        return node + 1;
    }

    /** The right part of a node that is no leaf. */
    public int right(int node) {
        return links[node];
    }

    /** Where the items of a leaf begin: they are {@code item(first)} to {@code item(first + count - 1)}. */
    public int first(int leaf) {
        return links[leaf];
    }

    /** How many items a leaf has; 0 for a node that is none. */
    public int count(int node) {
        return counts[node];
    }

    /** The item at a place of the leaves' order: its index among the boxes given. */
    public int item(int place) {
        return order[place];
    }

    /** The tight bounds of all nodes, six numbers each at {@code 6 * node}. The tree's own array: read only. */
    public double[] bounds() {
        return bounds;
    }

    /** The boxes of all items, six numbers each at {@code 6 * place}. The tree's own array: read only. */
    public double[] itemBounds() {
        return itemBounds;
    }

    public Cursor cursor() {
        return new Cursor(this);
    }

    /** One query at a time over a tree; reusable, nothing is allocated once its queue has grown. */
    public static final class Cursor {
        private final EntryQueue queue = new EntryQueue();
        private final int[] stack = new int[BoxTreeBuilder.MAX_DEPTH + 2];
        private final Slab slabX = new Slab();
        private final Slab slabY = new Slab();
        private final Slab slabZ = new Slab();
        private BoxTree tree;
        private int top;
        private int pending;
        private int pendingEnd;
        private long visited;
        private double unit = 1;
        private double entry;
        private double minX;
        private double minY;
        private double minZ;
        private double maxX;
        private double maxY;
        private double maxZ;

        private Cursor(BoxTree tree) {
            this.tree = tree;
        }

        /** Turns to another tree and ends the query. */
        public void over(BoxTree other) {
            tree = other;
            queue.clear();
            top = 0;
            pendingEnd = pending;
        }

        /** How many nodes this cursor has looked into since it was made. */
        public long visited() {
            return visited;
        }

        /** Starts the query for all items whose boxes meet this closed box; take them with {@link #next()}. */
        public void startBox(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
            this.minX = minX;
            this.minY = minY;
            this.minZ = minZ;
            this.maxX = maxX;
            this.maxY = maxY;
            this.maxZ = maxZ;
            over(tree);
            if (meets(tree.bounds, 0)) {
                stack[top++] = 0;
            }
        }

        /** The next item that meets the box, in no promised order; -1 after the last. */
        public int next() {
            while (true) {
                while (pending < pendingEnd) {
                    int place = pending++;
                    if (meets(tree.itemBounds, 6 * place)) {
                        return tree.order[place];
                    }
                }
                if (top == 0) {
                    return -1;
                }
                visited++;
                int node = stack[--top];
                if (tree.counts[node] > 0) {
                    pending = tree.links[node];
                    pendingEnd = pending + tree.counts[node];
                    continue;
                }
                if (meets(tree.bounds, 6 * tree.links[node])) {
                    stack[top++] = tree.links[node];
                }
                if (meets(tree.bounds, 6 * (node + 1))) {
                    stack[top++] = node + 1;
                }
            }
        }

        /**
         * Starts the query for all items whose boxes the ray meets at a parameter up to the limit, front to back; take them
         * with {@link #next(double)}. A point of the ray is its start plus the parameter times the direction.
         *
         * @param limit at least 0; may be infinite
         * @throws IllegalArgumentException where the direction is zero or not finite
         */
        public void startRay(double ox, double oy, double oz, double dx, double dy, double dz, double limit) {
            double scale = Slab.scale(Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz))));
            slabX.start(ox, dx * scale, dx);
            slabY.start(oy, dy * scale, dy);
            slabZ.start(oz, dz * scale, dz);
            over(tree);
            unit = scale;
            entry = 0;
            push(tree.bounds, 0, 0, Slab.inner(limit, unit));
        }

        /**
         * The next item of a ray query by the least parameter at which its box begins; -1 after the last within the limit,
         * which may shrink from call to call.
         */
        public int next(double limit) {
            double within = Slab.inner(limit, unit);
            while (queue.leastKey() <= within && !queue.isEmpty()) {
                double key = queue.leastKey();
                int item = queue.pop();
                if (item < 0) {
                    entry = Slab.outer(key, unit);
                    return tree.order[~item];
                }
                visited++;
                open(item, within);
            }
            return -1;
        }

        /** A lower bound, rounded down, of the parameter at which the last item's box begins. */
        public double entry() {
            return entry;
        }

        private void open(int node, double within) {
            int link = tree.links[node];
            if (tree.counts[node] == 0) {
                push(tree.bounds, 6 * (node + 1), node + 1, within);
                push(tree.bounds, 6 * link, link, within);
                return;
            }
            for (int place = link; place < link + tree.counts[node]; place++) {
                push(tree.itemBounds, 6 * place, ~place, within);
            }
        }

        private void push(double[] of, int at, int item, double within) {
            double x0 = of[at];
            double y0 = of[at + 1];
            double z0 = of[at + 2];
            double x1 = of[at + 3];
            double y1 = of[at + 4];
            double z1 = of[at + 5];
            if (slabX.misses(x0, x1) || slabY.misses(y0, y1) || slabZ.misses(z0, z1)) {
                return;
            }
            double enter =
                    Math.max(Math.max(0, slabX.entry(x0, x1)), Math.max(slabY.entry(y0, y1), slabZ.entry(z0, z1)));
            double leave = Math.min(slabX.exit(x0, x1), Math.min(slabY.exit(y0, y1), slabZ.exit(z0, z1)));
            if (enter <= leave && enter <= within) {
                queue.push(enter, item);
            }
        }

        private boolean meets(double[] of, int at) {
            return of[at] <= maxX
                    && minX <= of[at + 3]
                    && of[at + 1] <= maxY
                    && minY <= of[at + 4]
                    && of[at + 2] <= maxZ
                    && minZ <= of[at + 5];
        }
    }
}
