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

    private static final int NONE = -1;
    private static final int ABSENT = -2;
    private static final int EMPTY = Integer.MIN_VALUE;
    /** In a link: the region has more objects than its first. */
    private static final int MORE = 1 << 29;

    private final Cells cells;

    // By region, four numbers each: min x, min z, max x, max z of what lives in it.
    double[] bounds = new double[4 * 65];
    // By region: its first quarter, or ~id of its only object, or ~(id | MORE) of its first, or EMPTY.
    int[] links = new int[65];

    // By cut, the quarters of cut c being regions 4c + 1 to 4c + 4: a cell within, and which bit of a cell tells the
    // quarters.
    private long[] cutX = new long[16];
    private long[] cutZ = new long[16];
    private byte[] cutBit = new byte[16];
    private int cuts;
    private int freeCut = NONE;

    // By id: the box, and the next object of the same region.
    double[] boxes = new double[4 * 64];
    int[] next = new int[64];
    private int size;

    private final int[] path = new int[Cells.BITS + 2];

    /** An empty tree over a world of this extent. Objects may lie outside of it; the tree is merely coarser there. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ) {
        cells = new Cells(minX, minZ, maxX, maxZ);
        Arrays.fill(next, ABSENT);
        clear(0);
    }

    public int size() {
        return size;
    }

    public boolean contains(int id) {
        return id >= 0 && id < next.length && next[id] != ABSENT;
    }

    /** How many regions there are, cut and uncut. */
    public int regions() {
        int free = 0;
        for (int cut = freeCut; cut != NONE; cut = (int) cutX[cut]) {
            free++;
        }
        return 4 * (cuts - free) + 1;
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
        ensureCut();
        long x = cells.x(boxes, at);
        long z = cells.z(boxes, at);
        int region = 0;
        while (true) {
            int link = links[region];
            if (link == EMPTY) {
                break;
            }
            int cut = link >= 0 ? cutOf(link) : NONE;
            long apart = (x ^ heldX(link)) | (z ^ heldZ(link));
            if (link < 0 && apart == 0) {
                break;
            }
            int bit = Long.SIZE - 1 - Long.numberOfLeadingZeros(apart);
            if (link < 0 || bit > cutBit[cut]) {
                cut(region, bit);
                continue;
            }
            grow(region, at);
            region = link + Cells.quarter(cutBit[cut], x, z);
        }
        grow(region, at);
        next[id] = first(links[region]);
        links[region] = next[id] == NONE ? ~id : ~(id | MORE);
        size++;
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
        while (links[region] >= 0) {
            path[depth++] = region;
            region = links[region] + Cells.quarter(cutBit[cutOf(links[region])], x, z);
        }
        unlink(region, id);
        while (depth > 0) {
            tighten(path[--depth]);
        }
        size--;
        return true;
    }

    private void unlink(int region, int id) {
        int first = first(links[region]);
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
        clear(region);
        for (int other = first; other != NONE; other = next[other]) {
            grow(region, 4 * other);
        }
        links[region] = first == NONE ? EMPTY : next[first] == NONE ? ~first : ~(first | MORE);
    }

    // Bounds anew from the quarters; a cut with one quarter left in use is undone.
    private void tighten(int region) {
        int link = links[region];
        int used = 0;
        int last = link;
        for (int quarter = link; quarter < link + 4; quarter++) {
            if (links[quarter] != EMPTY) {
                used++;
                last = quarter;
            }
        }
        clear(region);
        for (int quarter = link; quarter < link + 4; quarter++) {
            growBy(region, bounds, 4 * quarter);
        }
        links[region] = used > 1 ? link : links[last];
        if (used <= 1) {
            int cut = cutOf(link);
            cutX[cut] = freeCut;
            freeCut = cut;
        }
    }

    // Puts a cut above what the region holds; everything in it agrees with its first object's cell above the bit.
    private void cut(int region, int bit) {
        int link = links[region];
        long x = heldX(link);
        long z = heldZ(link);
        int cut = newCut();
        cutX[cut] = x;
        cutZ[cut] = z;
        cutBit[cut] = (byte) bit;
        int first = 4 * cut + 1;
        for (int quarter = first; quarter < first + 4; quarter++) {
            clear(quarter);
        }
        int held = first + Cells.quarter(bit, x, z);
        links[held] = link;
        System.arraycopy(bounds, 4 * region, bounds, 4 * held, 4);
        links[region] = first;
    }

    private int newCut() {
        if (freeCut == NONE) {
            return cuts++;
        }
        int cut = freeCut;
        freeCut = (int) cutX[cut];
        return cut;
    }

    // Room for one cut more. Growing puts the cuts in the order of a descent: what is near in the world is near in
    // memory.
    private void ensureCut() {
        if (freeCut != NONE || cuts < cutX.length) {
            return;
        }
        int[] order = new int[cuts];
        int[] places = new int[cuts];
        listCuts(links[0], order, 0);
        for (int place = 0; place < cuts; place++) {
            places[order[place]] = place;
        }
        long[] oldX = cutX;
        long[] oldZ = cutZ;
        byte[] oldBit = cutBit;
        int[] oldLinks = links;
        double[] oldBounds = bounds;
        cutX = new long[2 * cuts];
        cutZ = new long[2 * cuts];
        cutBit = new byte[2 * cuts];
        links = new int[8 * cuts + 1];
        bounds = new double[4 * links.length];
        System.arraycopy(oldBounds, 0, bounds, 0, 4);
        links[0] = moved(oldLinks[0], places);
        for (int cut = 0; cut < cuts; cut++) {
            int old = order[cut];
            cutX[cut] = oldX[old];
            cutZ[cut] = oldZ[old];
            cutBit[cut] = oldBit[old];
            System.arraycopy(oldBounds, 16 * old + 4, bounds, 16 * cut + 4, 16);
            for (int quarter = 1; quarter <= 4; quarter++) {
                links[4 * cut + quarter] = moved(oldLinks[4 * old + quarter], places);
            }
        }
    }

    private int listCuts(int link, int[] order, int from) {
        if (link < 0) {
            return from;
        }
        order[from] = cutOf(link);
        int to = from + 1;
        for (int quarter = link; quarter < link + 4; quarter++) {
            to = listCuts(links[quarter], order, to);
        }
        return to;
    }

    private static int moved(int link, int[] places) {
        return link < 0 ? link : 4 * places[cutOf(link)] + 1;
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

    private void clear(int region) {
        links[region] = EMPTY;
        int at = 4 * region;
        bounds[at] = Double.POSITIVE_INFINITY;
        bounds[at + 1] = Double.POSITIVE_INFINITY;
        bounds[at + 2] = Double.NEGATIVE_INFINITY;
        bounds[at + 3] = Double.NEGATIVE_INFINITY;
    }

    private void grow(int region, int box) {
        growBy(region, boxes, box);
    }

    private void growBy(int region, double[] by, int box) {
        int at = 4 * region;
        bounds[at] = Math.min(bounds[at], by[box]);
        bounds[at + 1] = Math.min(bounds[at + 1], by[box + 1]);
        bounds[at + 2] = Math.max(bounds[at + 2], by[box + 2]);
        bounds[at + 3] = Math.max(bounds[at + 3], by[box + 3]);
    }

    private static int cutOf(int firstQuarter) {
        return (firstQuarter - 1) >> 2;
    }

    // The first object of a region that is not cut.
    private static int first(int link) {
        return link == EMPTY ? NONE : ~link & ~MORE;
    }

    // A cell within what a region holds.
    private long heldX(int link) {
        return link >= 0 ? cutX[cutOf(link)] : cells.x(boxes, 4 * first(link));
    }

    private long heldZ(int link) {
        return link >= 0 ? cutZ[cutOf(link)] : cells.z(boxes, 4 * first(link));
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
            if (meets(tree.bounds, 0)) {
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
                int link = tree.links[stack[--top]];
                if (link < 0) {
                    int id = first(link);
                    if (link == ~id) {
                        return id; // its box is the region's
                    }
                    pending = id;
                    continue;
                }
                for (int quarter = link + 3; quarter >= link; quarter--) {
                    if (meets(tree.bounds, 4 * quarter)) {
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
                int link = tree.links[region];
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
                    double its = keys.key(tree.bounds, 4 * quarter);
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
            push(keys.key(tree.bounds, 0), 0, keys.inner(limit));
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
