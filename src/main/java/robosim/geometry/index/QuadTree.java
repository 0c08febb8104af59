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
    private static final int CELL_BITS = 52;
    private static final long CELLS = 1L << CELL_BITS;

    private final double originX;
    private final double originZ;
    private final double scaleX;
    private final double scaleZ;

    // By region, four numbers each: min x, min z, max x, max z of what lives in it.
    double[] bounds = new double[4 * 64];
    // By region: its first quarter, or ~id of its first object, or EMPTY.
    int[] links = new int[64];

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

    private final int[] path = new int[CELL_BITS + 2];

    /** An empty tree over a world of this extent. Objects may lie outside of it; the tree is merely coarser there. */
    public QuadTree(double minX, double minZ, double maxX, double maxZ) {
        if (!(minX <= maxX) || !(minZ <= maxZ) || !Double.isFinite(maxX - minX) || !Double.isFinite(maxZ - minZ)) {
            throw new IllegalArgumentException("world must be finite and min at most max (got: x %s to %s, z %s to %s)"
                    .formatted(minX, maxX, minZ, maxZ));
        }
        originX = minX;
        originZ = minZ;
        scaleX = scale(maxX - minX);
        scaleZ = scale(maxZ - minZ);
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
        long x = cellX(id);
        long z = cellZ(id);
        int region = 0;
        while (true) {
            int link = links[region];
            if (link == EMPTY) {
                break;
            }
            int cut = link >= 0 ? cutOf(link) : NONE;
            long apart = link >= 0 ? (x ^ cutX[cut]) | (z ^ cutZ[cut]) : (x ^ cellX(~link)) | (z ^ cellZ(~link));
            if (link < 0 && apart == 0) {
                break;
            }
            int bit = Long.SIZE - 1 - Long.numberOfLeadingZeros(apart);
            if (link < 0 || bit > cutBit[cut]) {
                cut(region, bit);
                continue;
            }
            grow(region, at);
            region = link + quarter(cutBit[cut], x, z);
        }
        grow(region, at);
        next[id] = links[region] == EMPTY ? NONE : ~links[region];
        links[region] = ~id;
        size++;
    }

    /** Takes an object out; false where it is not in the tree. */
    public boolean remove(int id) {
        if (!contains(id)) {
            return false;
        }
        long x = cellX(id);
        long z = cellZ(id);
        int depth = 0;
        int region = 0;
        while (links[region] >= 0) {
            path[depth++] = region;
            region = links[region] + quarter(cutBit[cutOf(links[region])], x, z);
        }
        unlink(region, id);
        while (depth > 0) {
            tighten(path[--depth]);
        }
        size--;
        return true;
    }

    private void unlink(int region, int id) {
        int first = ~links[region];
        if (first == id) {
            links[region] = next[id] == NONE ? EMPTY : ~next[id];
        } else {
            int before = first;
            while (next[before] != id) {
                before = next[before];
            }
            next[before] = next[id];
        }
        next[id] = ABSENT;
        int left = links[region];
        clear(region);
        links[region] = left;
        for (int other = left == EMPTY ? NONE : ~left; other != NONE; other = next[other]) {
            grow(region, 4 * other);
        }
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
        long x = link >= 0 ? cutX[cutOf(link)] : cellX(~link);
        long z = link >= 0 ? cutZ[cutOf(link)] : cellZ(~link);
        int cut = newCut();
        cutX[cut] = x;
        cutZ[cut] = z;
        cutBit[cut] = (byte) bit;
        int first = 4 * cut + 1;
        for (int quarter = first; quarter < first + 4; quarter++) {
            clear(quarter);
        }
        int held = first + quarter(bit, x, z);
        links[held] = link;
        System.arraycopy(bounds, 4 * region, bounds, 4 * held, 4);
        links[region] = first;
    }

    private int newCut() {
        if (freeCut != NONE) {
            int cut = freeCut;
            freeCut = (int) cutX[cut];
            return cut;
        }
        if (cuts == cutX.length) {
            cutX = Arrays.copyOf(cutX, 2 * cuts);
            cutZ = Arrays.copyOf(cutZ, 2 * cuts);
            cutBit = Arrays.copyOf(cutBit, 2 * cuts);
        }
        if (4 * cuts + 5 > links.length) {
            links = Arrays.copyOf(links, 2 * links.length);
            bounds = Arrays.copyOf(bounds, 2 * bounds.length);
        }
        return cuts++;
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

    private static int quarter(int bit, long x, long z) {
        return (int) ((x >>> bit) & 1) | (int) ((z >>> bit) & 1) << 1;
    }

    private long cellX(int id) {
        return cell(0.5 * boxes[4 * id] + 0.5 * boxes[4 * id + 2], originX, scaleX);
    }

    private long cellZ(int id) {
        return cell(0.5 * boxes[4 * id + 1] + 0.5 * boxes[4 * id + 3], originZ, scaleZ);
    }

    // Never decreases with the place, so cells are stripes in order; what is outside goes to the outermost.
    private static long cell(double place, double origin, double scale) {
        double steps = (place - origin) * scale;
        return steps <= 0 ? 0 : steps >= CELLS ? CELLS - 1 : (long) steps;
    }

    private static double scale(double extent) {
        double scale = CELLS / extent;
        return Double.isFinite(scale) ? scale : 0;
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
        private final int[] stack = new int[3 * CELL_BITS + 8];
        private int top;
        private int pending = NONE;
        private long visited;

        private final Slab slabX = new Slab();
        private final Slab slabZ = new Slab();
        private boolean isRay;
        private double fromX;
        private double fromZ;
        private double unit = 1;
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
            queue.clear();
            pending = NONE;
            top = 0;
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
                    pending = link == EMPTY ? NONE : ~link;
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
         * @throws IllegalArgumentException where the direction is zero or not finite
         */
        public void startRay(double ox, double oz, double dx, double dz, double limit) {
            double scale = Slab.scale(Math.max(Math.abs(dx), Math.abs(dz)));
            slabX.start(ox, dx * scale, dx);
            slabZ.start(oz, dz * scale, dz);
            isRay = true;
            startOrdered(scale, limit);
        }

        /**
         * Starts the query for all objects whose boxes are within a distance of a point, nearest first; take them with
         * {@link #next(double)}.
         */
        public void startPoint(double x, double z, double limit) {
            fromX = x;
            fromZ = z;
            isRay = false;
            startOrdered(1, limit);
        }

        private void startOrdered(double scale, double limit) {
            top = 0;
            pending = NONE;
            unit = scale;
            entry = 0;
            queue.clear();
            push(tree.bounds, 0, 0, Slab.inner(limit, unit));
        }

        /**
         * The next object of a ray or point query by the least parameter or distance at which its box begins; -1 after the
         * last within the limit, which may shrink from call to call.
         */
        public int next(double limit) {
            double within = Slab.inner(limit, unit);
            while (queue.leastKey() <= within && !queue.isEmpty()) {
                double key = queue.leastKey();
                int item = queue.pop();
                if (item < 0) {
                    entry = Slab.outer(key, unit);
                    return ~item;
                }
                visited++;
                open(tree.links[item], key, within);
            }
            return -1;
        }

        /** A lower bound, rounded down, of the parameter or distance at which the last object's box begins. */
        public double entry() {
            return entry;
        }

        private void open(int link, double key, double within) {
            if (link >= 0) {
                for (int quarter = link; quarter < link + 4; quarter++) {
                    push(tree.bounds, 4 * quarter, quarter, within);
                }
            } else if (link != EMPTY && tree.next[~link] == NONE) {
                queue.push(key, link); // its box is the region's
            } else if (link != EMPTY) {
                for (int id = ~link; id != NONE; id = tree.next[id]) {
                    push(tree.boxes, 4 * id, ~id, within);
                }
            }
        }

        private void push(double[] of, int at, int item, double within) {
            double key = isRay ? rayKey(of, at) : pointKey(of, at);
            if (key <= within && key < Double.POSITIVE_INFINITY) {
                queue.push(key, item);
            }
        }

        private double rayKey(double[] of, int at) {
            double x0 = of[at];
            double z0 = of[at + 1];
            double x1 = of[at + 2];
            double z1 = of[at + 3];
            if (slabX.misses(x0, x1) || slabZ.misses(z0, z1)) {
                return Double.POSITIVE_INFINITY;
            }
            double enter = Math.max(0, Math.max(slabX.entry(x0, x1), slabZ.entry(z0, z1)));
            double leave = Math.min(slabX.exit(x0, x1), slabZ.exit(z0, z1));
            return enter <= leave ? enter : Double.POSITIVE_INFINITY;
        }

        private double pointKey(double[] of, int at) {
            double dx = Math.max(0, Math.max(of[at] - fromX, fromX - of[at + 2]));
            double dz = Math.max(0, Math.max(of[at + 1] - fromZ, fromZ - of[at + 3]));
            double square = dx * dx + dz * dz;
            // Where squares lose bits or overflow, the longer leg is bound enough.
            double distance = square > 0x1p-960 && square < 0x1p1000 ? Math.sqrt(square) : Math.max(dx, dz);
            return Math.max(0, distance * Slab.DOWN - Double.MIN_VALUE);
        }

        private boolean meets(double[] of, int at) {
            return of[at] <= maxX && minX <= of[at + 2] && of[at + 1] <= maxZ && minZ <= of[at + 3];
        }
    }
}
