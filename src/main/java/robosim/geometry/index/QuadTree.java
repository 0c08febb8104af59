package robosim.geometry.index;

import java.util.Arrays;

/**
 * Objects that stand still, by a small id of the caller's and a box in the XZ plane.
 *
 * <p>A region is cut in four at its centre until it holds one object, or several that have their centres in one cell of
 * {@code 2^-52} of the world. An object lives in the one region that holds its box's centre, and every region knows the
 * tight bounds of all that lives in it: nothing is refused or lost where it lies across a border, or outside of the
 * world. Cuts that would leave all in one quarter are left out, so there are fewer regions with parts than objects,
 * wherever they stand.
 *
 * <p>Belongs to one thread at a time. Arrays have one place for every id up to the greatest.
 */
public final class QuadTree {
    /** Greatest id: four numbers for each must fit one array. */
    public static final int MAX_ID = (1 << 28) - 2;

    private static final int NONE = Regions.NONE;
    private static final int ABSENT = -2;
    private static final int EMPTY = Regions.EMPTY;
    // The link of a region that is not cut is ~id of its only object, or ~(id | MORE) of the first of several, or
    // EMPTY.
    private static final int MORE = 1 << 29;

    private final Cells cells;

    final Regions regions = new Regions();

    // By id: the box, and the next object of the same region.
    double[] boxes = new double[4 * 64];
    int[] next = new int[64];
    private int size;

    private final int[] path = new int[Cells.BITS + 2];

    /** An empty tree over a world of this extent. Objects may lie outside of it; the tree is merely coarser there. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ) {
        cells = new Cells(minX, minZ, maxX, maxZ);
        Arrays.fill(next, ABSENT);
    }

    public int size() {
        return size;
    }

    public boolean contains(int id) {
        return id >= 0 && id < next.length && next[id] != ABSENT;
    }

    /** How many regions there are, cut and uncut. */
    public int regions() {
        return regions.count();
    }

    /** A cursor over this tree; it sees the tree as it is when a query starts. */
    public Cursor cursor() {
        return new Cursor(this);
    }

    /**
     * Adds an object by its closed box.
     *
     * @param id small, from 0 to {@link #MAX_ID}, and not in the tree
     * @throws IllegalArgumentException where the id is taken or out of range, or the box is not finite or inside out
     */
    public void add(int id, double minX, double minZ, double maxX, double maxZ) {
        if (id < 0 || id > MAX_ID || contains(id)) {
            throw new IllegalArgumentException("id must be 0 to " + MAX_ID + " and not in the tree (got: " + id + ")");
        }
        if (!(minX <= maxX) || !(minZ <= maxZ) || !finite(minX, minZ) || !finite(maxX, maxZ)) {
            throw new IllegalArgumentException("box must be finite and min at most max (got: x %s to %s, z %s to %s)"
                    .formatted(minX, maxX, minZ, maxZ));
        }
        ensureId(id);
        int at = 4 * id;
        boxes[at] = minX;
        boxes[at + 1] = minZ;
        boxes[at + 2] = maxX;
        boxes[at + 3] = maxZ;
        regions.reserve();
        int region = regionFor(at);
        regions.grow(region, boxes, at);
        next[id] = first(regions.links[region]);
        regions.links[region] = next[id] == NONE ? ~id : ~(id | MORE);
        size++;
    }

    // The uncut region that is to hold a box, cut out for it where needed; all regions above it are grown by the box.
    private int regionFor(int box) {
        long x = cells.x(boxes, box);
        long z = cells.z(boxes, box);
        int region = 0;
        while (true) {
            int link = regions.links[region];
            if (link == EMPTY) {
                return region;
            }
            boolean isCut = link >= 0;
            long heldX = isCut ? regions.x(link) : cells.x(boxes, 4 * first(link));
            long heldZ = isCut ? regions.z(link) : cells.z(boxes, 4 * first(link));
            int bit = Long.SIZE - 1 - Long.numberOfLeadingZeros((x ^ heldX) | (z ^ heldZ));
            if (isCut && bit <= regions.bit(link)) {
                regions.grow(region, boxes, box);
                region = link + Cells.quarter(regions.bit(link), x, z);
            } else if (bit < 0) {
                return region; // the same cell: no cut tells them apart
            } else {
                regions.cut(region, bit, heldX, heldZ);
            }
        }
    }

    /** Takes an object out; false where it is not in the tree. */
    public boolean remove(int id) {
        if (!contains(id)) {
            return false;
        }
        long x = cells.x(boxes, 4 * id);
        long z = cells.z(boxes, 4 * id);
        int depth = 0;
        int region = 0;
        while (regions.links[region] >= 0) {
            path[depth++] = region;
            int link = regions.links[region];
            region = link + Cells.quarter(regions.bit(link), x, z);
        }
        unlink(region, id);
        while (depth > 0) {
            regions.tighten(path[--depth]);
        }
        size--;
        return true;
    }

    private void unlink(int region, int id) {
        int first = first(regions.links[region]);
        if (first == id) {
            first = next[id];
        } else {
            int before = first;
            while (next[before] != id) {
                before = next[before];
            }
            next[before] = next[id];
        }
        next[id] = ABSENT;
        regions.clear(region);
        for (int other = first; other != NONE; other = next[other]) {
            regions.grow(region, boxes, 4 * other);
        }
        regions.links[region] = first == NONE ? EMPTY : next[first] == NONE ? ~first : ~(first | MORE);
    }

    private void ensureId(int id) {
        if (id < next.length) {
            return;
        }
        int before = next.length;
        int length = Math.min(MAX_ID + 1, Math.max(id + 1, 2 * before));
        next = Arrays.copyOf(next, length);
        Arrays.fill(next, before, length, ABSENT);
        boxes = Arrays.copyOf(boxes, 4 * length);
    }

    // The first object of a region that is not cut.
    private static int first(int link) {
        return link == EMPTY ? NONE : ~link & ~MORE;
    }

    private static boolean finite(double a, double b) {
        return Double.isFinite(a) && Double.isFinite(b);
    }

    /**
     * One query at a time over the tree it came from; reusable, nothing is allocated once its queue has grown. A change of
     * the tree ends the query: start again.
     */
    public static final class Cursor {
        private final QuadTree tree;
        private final EntryQueue queue = new EntryQueue();
        private final PlaneKeys keys = new PlaneKeys();
        private final int[] stack = new int[3 * Cells.BITS + 8];
        private int top;
        private int pending = NONE;
        private long visited;
        private double entry;

        private double minX;
        private double minZ;
        private double maxX;
        private double maxZ;

        private Cursor(QuadTree tree) {
            this.tree = tree;
        }

        /** How many regions this cursor has looked into since it was made. */
        public long visited() {
            return visited;
        }

        /** Starts the query for all objects whose boxes meet this closed box; take them with {@link #next()}. */
        public void startBox(double minX, double minZ, double maxX, double maxZ) {
            this.minX = minX;
            this.minZ = minZ;
            this.maxX = maxX;
            this.maxZ = maxZ;
            clear();
            if (meets(tree.regions.bounds, 0)) {
                stack[top++] = 0;
            }
        }

        /** The next object that meets the box, in no promised order; -1 after the last. */
        public int next() {
            while (true) {
                while (pending != NONE) {
                    int id = pending;
                    pending = tree.next[id];
                    if (meets(tree.boxes, 4 * id)) {
                        return id;
                    }
                }
                if (top == 0) {
                    return -1;
                }
                visited++;
                int link = tree.regions.links[stack[--top]];
                if (link < 0) {
                    int id = first(link);
                    if (link == ~id) {
                        return id; // its box is the region's
                    }
                    pending = id;
                    continue;
                }
                for (int quarter = link + 3; quarter >= link; quarter--) {
                    if (meets(tree.regions.bounds, 4 * quarter)) {
                        stack[top++] = quarter;
                    }
                }
            }
        }

        /**
         * Starts the query for all objects whose boxes the ray meets at a parameter up to the limit, front to back; take
         * them with {@link #next(double)}. A point of the ray is its start plus the parameter times the direction.
         *
         * @param limit at least 0; may be infinite
         * @throws IllegalArgumentException where the start is not finite, or the direction zero or not finite
         */
        public void startRay(double ox, double oz, double dx, double dz, double limit) {
            keys.startRay(ox, oz, dx, dz);
            startOrdered(limit);
        }

        /**
         * Starts the query for all objects whose boxes are within a distance of a point, nearest first; take them with
         * {@link #next(double)}.
         *
         * @param limit at least 0; may be infinite
         * @throws IllegalArgumentException where the point is not finite
         */
        public void startPoint(double x, double z, double limit) {
            keys.startPoint(x, z);
            startOrdered(limit);
        }

        /**
         * The next object of a ray or point query by the least parameter or distance at which its box begins; -1 after the
         * last within the limit, which may shrink from call to call.
         */
        public int next(double limit) {
            double within = keys.inner(limit);
            while (!queue.isEmpty() && queue.leastKey() <= within) {
                double key = queue.leastKey();
                int id = descend(queue.pop(), key, within);
                if (id != NONE) {
                    return id;
                }
            }
            return -1;
        }

        /** A lower bound, rounded down, of the parameter or distance at which the last object's box begins. */
        public double entry() {
            return entry;
        }

        // Down from the item of the least key, as long as a part of it comes before all else: no place in the queue for
        // it.
        private int descend(int item, double itsKey, double within) {
            int region = item;
            double key = itsKey;
            while (region >= 0) {
                visited++;
                int link = tree.regions.links[region];
                if (link < 0) {
                    int id = first(link);
                    if (link != ~id) {
                        pushAll(id, within);
                        return NONE;
                    }
                    entry = keys.outer(key); // its box is the region's
                    return id;
                }
                double least = Double.POSITIVE_INFINITY;
                int nearest = NONE;
                for (int quarter = link; quarter < link + 4; quarter++) {
                    double its = keys.key(tree.regions.bounds, 4 * quarter);
                    if (its < least) {
                        push(least, nearest, within);
                        least = its;
                        nearest = quarter;
                    } else {
                        push(its, quarter, within);
                    }
                }
                if (nearest == NONE || least > within || least > queue.leastKey()) {
                    push(least, nearest, within);
                    return NONE;
                }
                region = nearest;
                key = least;
            }
            entry = keys.outer(key);
            return ~region;
        }

        private void startOrdered(double limit) {
            clear();
            entry = 0;
            push(keys.key(tree.regions.bounds, 0), 0, keys.inner(limit));
        }

        private void clear() {
            queue.clear();
            top = 0;
            pending = NONE;
        }

        private void pushAll(int first, double within) {
            for (int id = first; id != NONE; id = tree.next[id]) {
                push(keys.key(tree.boxes, 4 * id), ~id, within);
            }
        }

        private void push(double key, int item, double within) {
            if (key <= within && key < Double.POSITIVE_INFINITY) {
                queue.push(key, item);
            }
        }

        private boolean meets(double[] of, int at) {
            return of[at] <= maxX && minX <= of[at + 2] && of[at + 1] <= maxZ && minZ <= of[at + 3];
        }
    }
}
