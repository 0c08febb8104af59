package robosim.geometry.index.hierarchy;

import java.util.Arrays;
import robosim.geometry.index.ArrayGrowth;

/**
 * A bounding-volume hierarchy over objects in space, each given by a small id that the caller chooses and a box. Objects
 * come, go and move at any time.
 *
 * <p>A node has up to {@link #WIDTH} children, each of which is a node or an object. The bounds of children are floats,
 * rounded outward. An object that is added waits for the next query, and is then hung by {@link HierarchyInsertion}; where at
 * least as many wait as there were before, the hierarchy is built with them instead. One that moves stays in its node as long
 * as it is near that. The {@link RebuildPolicy} tells when to build it anew, see {@link HierarchyBuilder}. So a change costs
 * a descent, and a rebuild is charged to a quarter as many changes as there are objects.
 *
 * <p>The boxes stay with the caller: the six numbers of an object, its minimum corner and its maximum, begin at 6 times its
 * id. May be used by one thread at a time, unless it is frozen.
 */
public final class Hierarchy {
    /** The most children of a node. */
    static final int WIDTH = 4;

    /** What a cursor has before its first query. */
    static final Hierarchy EMPTY = new Hierarchy(() -> {});

    /** Number of floats in a child's bounds: minimum corner, maximum corner. */
    static final int PART = 6;

    /** Offset of a node's links, one for each child, as the bits of ints. */
    static final int LINKS = WIDTH * PART;

    /** Number of floats in a node: with an array's header, a node fills two lines of the cache. */
    static final int STRIDE = 32;

    /** The link of a child that is missing. The link of an object is its id with the sign bit set, that of a node its number. */
    static final int NONE = 0x7f000000;

    /** The first capacity of a cursor's stack: enough for millions of objects that are not crowded. */
    static final int STACK = 64;

    /** Once an object is this deep the hierarchy is built anew, and then none is. */
    private static final int DEEP = 120;

    /** An object that is farther outside its node than this many sizes of that is hung elsewhere. */
    private static final float FAR = 1;

    /** What stands in place of a slot for an object that is to be hung when the next query begins. */
    private static final int WAITING = -2;

    float[] nodes = new float[STRIDE];

    /** By node, the slot that it hangs from: 4 times the parent's number plus the child's. -1 for the root. */
    private int[] parents = new int[1];

    /** By id, the slot that the object hangs from; {@link #WAITING}, or -1 if it is not in the tree. */
    private int[] slots = new int[0];

    /** The objects that are to be hung: where they are many, the hierarchy is built with them instead. */
    private final PendingObjects waiting = new PendingObjects();

    private int count = 1;

    /** The first of the nodes that were given up, which are chained by their parents; -1 for none. */
    private int free = -1;

    private int size;

    /** The greatest magnitude of any coordinate of a box so far. */
    private double most;

    private final RebuildPolicy rebuilds = new RebuildPolicy();
    private final float[] box = new float[PART];
    private boolean isFrozen;
    private final Runnable whenBuilt;

    /** An empty hierarchy, with an action to run whenever it has been built anew. */
    public Hierarchy(Runnable whenBuilt) {
        this.whenBuilt = whenBuilt;
        clear(0);
        parents[0] = -1;
    }

    /** The greatest float that is at most a number; never -0. */
    static float lower(double value) {
        float nearest = (float) value;
        return nearest > value ? Math.nextDown(nearest) : nearest + 0f;
    }

    /** The least float that is at least a number; never -0. */
    static float upper(double value) {
        float nearest = (float) value;
        return nearest < value ? Math.nextUp(nearest) + 0f : nearest + 0f;
    }

    /** The number of objects. */
    public int size() {
        return size;
    }

    /** The only object of a tree that has one: it hangs from the root, as every other node has two children at least. */
    public int only() {
        takeIn();
        for (int slot = 0; slot < WIDTH; slot++) {
            if (link(slot) < 0) {
                return link(slot) & Integer.MAX_VALUE;
            }
        }
        throw new IllegalStateException("tree must have one object (got: " + size + ")");
    }

    /** Whether an object is in the tree. */
    public boolean contains(int id) {
        return id < slots.length && slots[id] != -1;
    }

    /** The greatest magnitude of any coordinate of a box so far. */
    public double most() {
        return most;
    }

    /** Adds an object that is not in the tree. */
    public void add(int id, double[] boxes) {
        if (contains(id)) {
            throw new IllegalArgumentException("id must not be in the tree (got: " + id + ")");
        }
        if (id >= slots.length) {
            int before = slots.length;
            slots = Arrays.copyOf(slots, ArrayGrowth.of(id));
            Arrays.fill(slots, before, slots.length, -1);
        }
        size++;
        rebuilds.cameOrWent();
        take(id, boxes);
        slots[id] = WAITING;
        waiting.add(id, box);
    }

    /** Hangs the objects that wait. */
    private void hang() {
        if (waiting.size() > RebuildPolicy.FEW && 2 * waiting.size() >= size) {
            build();
            return;
        }
        while (waiting.size() > 0) {
            insert(waiting.takeLast(box));
        }
    }

    /** Hangs an object with the box at hand. */
    private void insert(int id) {
        if (HierarchyInsertion.insert(this, id, box) > DEEP) {
            build();
        }
    }

    /** Removes an object that is in the tree. */
    public void remove(int id) {
        requireHung(id);
        size--;
        rebuilds.cameOrWent();
        unlink(id);
    }

    /** Makes sure that an object hangs in the tree. */
    private void requireHung(int id) {
        if (!contains(id)) {
            throw new IllegalArgumentException("id must be in the tree (got: " + id + ")");
        }
        if (slots[id] == WAITING) {
            hang();
        }
    }

    /** Gives an object of the tree the box that the caller has for it now. */
    public void move(int id, double[] boxes) {
        requireHung(id);
        take(id, boxes);
        int slot = slots[id];
        int at = at(slot);
        int above = parents[slot / WIDTH];
        if (above < 0) {
            System.arraycopy(box, 0, nodes, at, PART);
            return;
        }
        int around = at(above);
        boolean isOuter = isOuter(at, around);
        boolean isWithin = isWithin(around, 0);
        if (!isWithin && !isWithin(around, FAR)) {
            rebuilds.hungElsewhere();
            unlink(id);
            insert(id);
            return;
        }
        System.arraycopy(box, 0, nodes, at, PART);
        if (!isWithin) {
            rebuilds.leftItsNode();
        }
        if (isOuter || !isWithin) {
            refit(slot / WIDTH);
        }
    }

    /** Whether bounds that begin at an index touch the bounds around them from within. */
    private boolean isOuter(int at, int around) {
        return nodes[at] <= nodes[around]
                || nodes[at + 1] <= nodes[around + 1]
                || nodes[at + 2] <= nodes[around + 2]
                || nodes[at + 3] >= nodes[around + 3]
                || nodes[at + 4] >= nodes[around + 4]
                || nodes[at + 5] >= nodes[around + 5];
    }

    /** Whether the box at hand is within the bounds that begin at an index, made larger on each side by a share of them. */
    private boolean isWithin(int at, float share) {
        for (int axis = 0; axis < 3; axis++) {
            float low = nodes[at + axis];
            float high = nodes[at + 3 + axis];
            float more = share == 0 ? 0 : share * (high - low);
            if (!(low - more <= box[axis] && box[3 + axis] <= high + more)) {
                return false;
            }
        }
        return true;
    }

    private void take(int id, double[] boxes) {
        for (int axis = 0; axis < 3; axis++) {
            double low = boxes[6 * id + axis];
            double high = boxes[6 * id + 3 + axis];
            box[axis] = lower(low);
            box[3 + axis] = upper(high);
            most = Math.max(most, Math.max(-low, high));
        }
    }

    /** Where the bounds of a slot begin. */
    static int at(int slot) {
        return STRIDE * (slot / WIDTH) + PART * (slot % WIDTH);
    }

    int link(int slot) {
        return Float.floatToRawIntBits(nodes[STRIDE * (slot / WIDTH) + LINKS + slot % WIDTH]);
    }

    /** Hangs a child from a slot. */
    void link(int slot, int to) {
        nodes[STRIDE * (slot / WIDTH) + LINKS + slot % WIDTH] = Float.intBitsToFloat(to);
        if (to < 0) {
            slots[to & Integer.MAX_VALUE] = slot;
        } else if (to != NONE) {
            parents[to] = slot;
        }
    }

    private void clear(int node) {
        for (int slot = WIDTH * node; slot < WIDTH * node + WIDTH; slot++) {
            clearSlot(slot);
        }
    }

    private void clearSlot(int slot) {
        int at = at(slot);
        Arrays.fill(nodes, at, at + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(nodes, at + 3, at + 6, Float.NEGATIVE_INFINITY);
        link(slot, NONE);
    }

    /** A new node, without children. */
    int claim() {
        int node = free;
        if (node >= 0) {
            free = parents[node];
        } else {
            node = count++;
            if (node >= parents.length) {
                parents = Arrays.copyOf(parents, ArrayGrowth.of(node));
                nodes = Arrays.copyOf(nodes, STRIDE * parents.length);
            }
        }
        clear(node);
        return node;
    }

    private void giveUp(int node) {
        parents[node] = free;
        free = node;
    }

    private void unlink(int id) {
        int slot = slots[id];
        slots[id] = -1;
        clearSlot(slot);
        int node = slot / WIDTH;
        int above = parents[node];
        int left = onlyChild(node);
        if (above >= 0 && left != NONE) { // a node keeps at least two children, but for the root
            System.arraycopy(nodes, at(left), nodes, at(above), PART);
            link(above, link(left));
            giveUp(node);
            node = above / WIDTH;
        }
        refit(node);
    }

    /** The slot of a node's only child; -1 where it has none, {@link #NONE} where it has more. */
    private int onlyChild(int node) {
        int only = -1;
        for (int slot = WIDTH * node; slot < WIDTH * node + WIDTH; slot++) {
            if (link(slot) != NONE) {
                if (only >= 0) {
                    return NONE;
                }
                only = slot;
            }
        }
        return only;
    }

    /** Gives the slots above a node the bounds of their nodes, as far as these change. */
    private void refit(int from) {
        for (int slot = parents[from]; slot >= 0; slot = parents[slot / WIDTH]) {
            if (!measure(link(slot), at(slot))) {
                return;
            }
        }
    }

    /** Writes the bounds of a node's children from an index on; false where they are there already. */
    private boolean measure(int node, int to) {
        boolean changes = false;
        for (int axis = 0; axis < 3; axis++) {
            int a = STRIDE * node + axis;
            float low =
                    Math.min(Math.min(nodes[a], nodes[a + PART]), Math.min(nodes[a + 2 * PART], nodes[a + 3 * PART]));
            a += 3;
            float high =
                    Math.max(Math.max(nodes[a], nodes[a + PART]), Math.max(nodes[a + 2 * PART], nodes[a + 3 * PART]));
            changes |= nodes[to + axis] != low || nodes[to + 3 + axis] != high;
            nodes[to + axis] = low;
            nodes[to + 3 + axis] = high;
        }
        return changes;
    }

    /** To be called before a query: takes in what was added since the last one. */
    void takeIn() {
        if (waiting.size() > 0) {
            hang();
        }
    }

    /** To be called before a query instead: builds the hierarchy anew, too, where this is worth while. */
    public void settle() {
        takeIn();
        if (!isFrozen && rebuilds.isDueAtQuery(size)) {
            build();
        }
    }

    /** Builds the hierarchy as well as it can be. From now on it must not be changed, and many threads may query it. */
    public void freeze() {
        if (rebuilds.hasChanges()) {
            build();
        }
        isFrozen = true;
    }

    private void build() {
        float[] boxes = new float[PART * size];
        int[] ids = new int[size];
        int found = 0;
        for (int id = 0; found < size; id++) {
            if (slots[id] >= 0) {
                System.arraycopy(nodes, at(slots[id]), boxes, PART * found, PART);
                ids[found++] = id;
            } else if (slots[id] == WAITING) {
                slots[id] = found;
                ids[found++] = id;
            }
        }
        for (int k = 0; k < waiting.size(); k++) {
            waiting.copyBox(k, boxes, PART * slots[waiting.id(k)]);
        }
        waiting.forget();
        count = 1;
        free = -1;
        clear(0);
        if (size > 0) {
            new HierarchyBuilder(this, boxes, ids).fill(0, size);
        }
        if (ArrayGrowth.isWasteful(count, parents.length)) {
            parents = Arrays.copyOf(parents, count);
            nodes = Arrays.copyOf(nodes, STRIDE * count);
        }
        rebuilds.reset();
        whenBuilt.run();
    }
}
