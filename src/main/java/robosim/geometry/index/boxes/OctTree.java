package robosim.geometry.index.boxes;

import java.util.Arrays;

/**
 * An index of objects, each given by a small id that the caller chooses and a box in space, for scenes that are stacked
 * in height. A region that holds more than a few objects is cut in eight at its centre. Each object belongs to the one
 * region that contains its box's centre, and every region has tight bounds of all its objects. If a centre lies
 * outside, the outermost region becomes an eighth of a larger one.
 *
 * <p>The boxes stay with the caller: the six numbers of an object, its minimum corner and its maximum, begin at 6 times
 * its id, and must not change from its addition to its removal. May be used by one thread at a time.
 */
public final class OctTree {
    private static final int NONE = -1;

    /**
     * The link of a region without objects. A link of at least 0 is the first of eight parts, any other is ~id of an
     * object.
     */
    private static final int EMPTY = Integer.MIN_VALUE;

    /** A region with more objects than this is cut. */
    private static final int FEW = 6;

    private static final int MOST_DEPTH = 40;

    private final double[] middle = new double[3];
    private double half;

    private int[] links = new int[9];
    private double[] bounds = new double[6 * 9];
    private int regions = 1;

    /** By id, the next object of the same region. */
    private int[] next = new int[64];

    private int[] path = new int[MOST_DEPTH + 1];
    private final double[] cell = new double[4];

    /** An empty tree, at first over a cube around a box of six numbers. */
    public OctTree(double[] extent) {
        double most = 0;
        for (int axis = 0; axis < 3; axis++) {
            middle[axis] = extent[axis] / 2 + extent[axis + 3] / 2;
            most = Math.max(most, extent[axis + 3] / 2 - extent[axis] / 2);
        }
        half = most > 0 ? most : 1;
        links[0] = EMPTY;
        clear(0);
    }

    /** A new cursor over this tree; a query sees the tree as it is when the query starts. */
    public Cursor cursor() {
        return new Cursor(this);
    }

    /** Adds an object that is not in the tree. */
    public void add(int id, double[] boxes) {
        if (id >= next.length) {
            next = Arrays.copyOf(next, Math.max(id + 1, next.length + (next.length >> 1)));
        }
        while (!isWithin(6 * id, boxes)) {
            widen(6 * id, boxes);
        }
        int depth = find(id, boxes);
        int region = path[depth];
        for (int k = 0; k <= depth; k++) {
            grow(path[k], boxes, 6 * id);
        }
        next[id] = first(region);
        links[region] = ~id;
        while (depth < MOST_DEPTH && isCrowded(region)) {
            cut(region, boxes);
            int crowded = partOf(6 * id, boxes);
            region = links[region] + crowded;
            enter(crowded);
            depth++;
        }
    }

    /** Removes an object that is in the tree. */
    public void remove(int id, double[] boxes) {
        int depth = find(id, boxes);
        if (!holds(path[depth], id)) {
            // The centre is on a boundary of regions that moved by rounding when the tree was widened.
            depth = search(0, 0, id, boxes);
        }
        if (depth < 0) {
            throw new IllegalStateException("id must be in the tree (got: " + id + ")");
        }
        int region = path[depth];
        int first = ~links[region];
        if (first == id) {
            first = next[id];
        } else {
            int before = first;
            while (next[before] != id) {
                before = next[before];
            }
            next[before] = next[id];
        }
        links[region] = first == NONE ? EMPTY : ~first;
        clear(region);
        for (int other = first; other != NONE; other = next[other]) {
            grow(region, boxes, 6 * other);
        }
        while (--depth >= 0) {
            clear(path[depth]);
            for (int part = links[path[depth]]; part < links[path[depth]] + 8; part++) {
                if (links[part] != EMPTY) {
                    grow(path[depth], bounds, 6 * part);
                }
            }
        }
    }

    private boolean isWithin(int at, double[] boxes) {
        for (int axis = 0; axis < 3; axis++) {
            if (!(Math.abs(boxes[at + axis] / 2 + boxes[at + axis + 3] / 2 - middle[axis]) <= half)) {
                return false;
            }
        }
        return true;
    }

    /** Makes the outermost region an eighth of a larger one that extends towards a box. */
    private void widen(int at, double[] boxes) {
        int part = 0;
        for (int axis = 0; axis < 3; axis++) {
            boolean isBelow = boxes[at + axis] / 2 + boxes[at + axis + 3] / 2 < middle[axis];
            part |= isBelow ? 1 << axis : 0;
            middle[axis] += isBelow ? -half : half;
        }
        half *= 2;
        if (links[0] != EMPTY) {
            int parts = claimParts();
            links[parts + part] = links[0];
            System.arraycopy(bounds, 0, bounds, 6 * (parts + part), 6);
            links[0] = parts;
        }
    }

    /**
     * Writes the path of regions down to the uncut one that contains an object's centre; returns how many are above
     * that.
     */
    private int find(int id, double[] boxes) {
        System.arraycopy(middle, 0, cell, 0, 3);
        cell[3] = half;
        int depth = 0;
        path[0] = 0;
        while (links[path[depth]] >= 0) {
            int part = partOf(6 * id, boxes);
            if (depth + 1 == path.length) {
                path = Arrays.copyOf(path, 2 * path.length);
            }
            path[depth + 1] = links[path[depth]] + part;
            enter(part);
            depth++;
        }
        return depth;
    }

    /** The first object of an uncut region. */
    private int first(int region) {
        return links[region] == EMPTY ? NONE : ~links[region];
    }

    private boolean holds(int region, int id) {
        for (int other = first(region); other != NONE; other = next[other]) {
            if (other == id) {
                return true;
            }
        }
        return false;
    }

    /**
     * Writes the path of regions down to the one that an object belongs to, searching by bounds; -1 if it is not found.
     */
    private int search(int region, int depth, int id, double[] boxes) {
        if (depth == path.length) {
            path = Arrays.copyOf(path, 2 * path.length);
        }
        path[depth] = region;
        if (links[region] < 0) {
            return holds(region, id) ? depth : -1;
        }
        for (int part = links[region]; part < links[region] + 8; part++) {
            int found = encloses(part, boxes, 6 * id) ? search(part, depth + 1, id, boxes) : -1;
            if (found >= 0) {
                return found;
            }
        }
        return -1;
    }

    private boolean encloses(int region, double[] boxes, int at) {
        for (int axis = 0; axis < 3; axis++) {
            int k = 6 * region + axis;
            if (!(bounds[k] <= boxes[at + axis] && boxes[at + axis + 3] <= bounds[k + 3])) {
                return false;
            }
        }
        return true;
    }

    /** Which of the eight parts of the current cell contains a box's centre. */
    private int partOf(int at, double[] boxes) {
        int part = 0;
        for (int axis = 0; axis < 3; axis++) {
            part |= boxes[at + axis] / 2 + boxes[at + axis + 3] / 2 >= cell[axis] ? 1 << axis : 0;
        }
        return part;
    }

    private void enter(int part) {
        cell[3] /= 2;
        for (int axis = 0; axis < 3; axis++) {
            cell[axis] += (part >> axis & 1) == 0 ? -cell[3] : cell[3];
        }
    }

    private boolean isCrowded(int region) {
        int count = 0;
        for (int id = ~links[region]; id != NONE && count <= FEW; id = next[id]) {
            count++;
        }
        return count > FEW;
    }

    private int claimParts() {
        if (regions + 8 > links.length) {
            links = Arrays.copyOf(links, 2 * links.length + 8);
            bounds = Arrays.copyOf(bounds, 6 * links.length);
        }
        int parts = regions;
        regions += 8;
        for (int part = parts; part < regions; part++) {
            links[part] = EMPTY;
            clear(part);
        }
        return parts;
    }

    /** Cuts the region that is the current cell. */
    private void cut(int region, double[] boxes) {
        int parts = claimParts();
        int id = ~links[region];
        links[region] = parts;
        while (id != NONE) {
            int after = next[id];
            int part = parts + partOf(6 * id, boxes);
            next[id] = first(part);
            links[part] = ~id;
            grow(part, boxes, 6 * id);
            id = after;
        }
    }

    private void clear(int region) {
        Arrays.fill(bounds, 6 * region, 6 * region + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 6 * region + 3, 6 * region + 6, Double.NEGATIVE_INFINITY);
    }

    private void grow(int region, double[] by, int at) {
        for (int axis = 0; axis < 3; axis++) {
            int k = 6 * region + axis;
            bounds[k] = Math.min(bounds[k], by[at + axis]);
            bounds[k + 3] = Math.max(bounds[k + 3], by[at + axis + 3]);
        }
    }

    /**
     * Runs one query at a time over its tree. It is reusable and allocates nothing once its stack has grown. A change
     * of the tree invalidates the query, which must be started again.
     */
    public static final class Cursor {
        private final OctTree tree;
        private SpaceKeys keys = new SpaceKeys();
        private double[] boxes = new double[0];
        private int[] items = new int[64];
        private double[] begins = new double[64];
        private int depth;
        private long visited;

        private Cursor(OctTree tree) {
            this.tree = tree;
        }

        /** Number of regions that this cursor has examined since it was made. */
        public long visited() {
            return visited;
        }

        /**
         * Starts a query for all objects, nearer parts of space first.
         *
         * @param objects the boxes
         * @param by      gives the key at which a box begins; in use until the query ends
         */
        public void start(double[] objects, SpaceKeys by) {
            boxes = objects;
            keys = by;
            depth = 0;
            push(0, 0, 0, Double.POSITIVE_INFINITY);
        }

        /**
         * The next object that begins within the limit, each once, in an unspecified order; -1 after the last. The
         * limit may shrink from call to call.
         */
        public int next(double limit) {
            while (depth > 0) {
                depth--;
                int item = items[depth];
                if (!(begins[depth] <= limit)) {
                    continue;
                }
                if (item < 0) {
                    return ~item;
                }
                open(tree.links[item], limit);
            }
            return -1;
        }

        /** Puts the parts of a region, or its objects, on the stack, the nearest on top. */
        private void open(int link, double limit) {
            visited++;
            int base = depth;
            if (link >= 0) {
                for (int part = link; part < link + 8; part++) {
                    if (tree.links[part] != EMPTY) {
                        push(base, keys.key(tree.bounds, 6 * part), part, limit);
                    }
                }
            } else if (link != EMPTY) {
                for (int id = ~link; id != NONE; id = tree.next[id]) {
                    push(base, keys.key(boxes, 6 * id), ~id, limit);
                }
            }
        }

        private void push(int base, double begin, int item, double limit) {
            if (!(begin <= limit && begin < Double.POSITIVE_INFINITY)) {
                return;
            }
            if (depth == items.length) {
                items = Arrays.copyOf(items, 2 * depth);
                begins = Arrays.copyOf(begins, 2 * depth);
            }
            int place = depth++;
            while (place > base && begins[place - 1] < begin) {
                begins[place] = begins[place - 1];
                items[place] = items[place - 1];
                place--;
            }
            begins[place] = begin;
            items[place] = item;
        }
    }
}
