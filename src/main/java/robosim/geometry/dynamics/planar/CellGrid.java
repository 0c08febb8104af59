package robosim.geometry.dynamics.planar;

import java.util.Arrays;

/**
 * Boxes in square cells of a plane without end, hashed into a table. Those that cover more cells than there are boxes are kept
 * apart, and all boxes are looked at for one that does: that is never more work than to look at all.
 */
final class CellGrid {
    /** Most cells that a box is put into. */
    private static final int MOST_CELLS = 1024;

    /** Entries for each slot of the table, on average, before it is made anew. */
    private static final int MOST_ENTRIES = 2;

    private static final int FIRST = 16;

    private double cell = 1;
    private int[] heads = new int[64];
    private int slots = 64;
    private int mostCells;
    private int[] next = new int[FIRST];
    private int[] items = new int[FIRST];
    private int entries;
    private int[] large = new int[FIRST];
    private int largeCount;
    private boolean[] isLarge = new boolean[FIRST];

    /** The least X and Z and the greatest of each item; NaN, which meets nothing, until it is given. */
    private double[] boxes = new double[4 * FIRST];

    private int[] seen = new int[FIRST];
    private int stamp;
    private int count;

    /** No item from this one on has a box. */
    private int boxed;

    int[] found = new int[FIRST];
    int foundCount;

    /** Empties it for a number of items, whose boxes follow. */
    void clear(int items, double cellSize) {
        cell = cellSize;
        count = items;
        boxed = 0;
        mostCells = Math.min(MOST_CELLS, items);
        empty(Math.max(64, Integer.highestOneBit(Math.max(1, items)) * 8));
        if (seen.length < items) {
            int room = Math.max(items, 2 * seen.length);
            seen = new int[room];
            boxes = new double[4 * room];
            large = new int[room];
            isLarge = new boolean[room];
            found = new int[room];
            stamp = 0;
        }
        Arrays.fill(isLarge, 0, items, false);
        Arrays.fill(boxes, 0, 4 * items, Double.NaN);
    }

    private void empty(int size) {
        slots = size;
        entries = 0;
        largeCount = 0;
        if (heads.length < size) {
            heads = new int[size];
        }
        Arrays.fill(heads, 0, size, -1);
    }

    /** How many entries the cells have in all, those of replaced boxes among them. */
    int entries() {
        return entries;
    }

    /** Whether a box is within the one that an item has. */
    boolean holds(int item, double minX, double minZ, double maxX, double maxZ) {
        int at = 4 * item;
        return boxes[at] <= minX && boxes[at + 1] <= minZ && boxes[at + 2] >= maxX && boxes[at + 3] >= maxZ;
    }

    /** Gives an item its box, or another one that replaces it. */
    void put(int item, double minX, double minZ, double maxX, double maxZ) {
        int at = 4 * item;
        boxes[at] = minX;
        boxes[at + 1] = minZ;
        boxes[at + 2] = maxX;
        boxes[at + 3] = maxZ;
        boxed = Math.max(boxed, item + 1);
        enter(item);
        if (entries > MOST_ENTRIES * slots) {
            renew();
        }
    }

    /** Makes the table anew, without what replaced boxes have left there, and so large that this pays for the next time. */
    private void renew() {
        int size = slots;
        do {
            empty(size);
            Arrays.fill(isLarge, 0, boxed, false);
            for (int item = 0; item < boxed; item++) {
                if (hasBox(item)) {
                    enter(item);
                }
            }
            size *= 2;
        } while (entries > slots);
    }

    private boolean hasBox(int item) {
        return !Double.isNaN(boxes[4 * item]);
    }

    private void enter(int item) {
        int at = 4 * item;
        double fromX = Math.floor(boxes[at] / cell);
        double fromZ = Math.floor(boxes[at + 1] / cell);
        double toX = Math.floor(boxes[at + 2] / cell);
        double toZ = Math.floor(boxes[at + 3] / cell);
        if (!isSmall(fromX, fromZ, toX, toZ)) {
            if (!isLarge[item]) {
                isLarge[item] = true;
                large[largeCount++] = item;
            }
            return;
        }
        for (long j = (long) fromZ; j <= (long) toZ; j++) {
            for (long i = (long) fromX; i <= (long) toX; i++) {
                int head = slot(i, j);
                if (entries == next.length) {
                    next = Arrays.copyOf(next, 2 * entries);
                    items = Arrays.copyOf(items, 2 * entries);
                }
                next[entries] = heads[head];
                items[entries] = item;
                heads[head] = entries++;
            }
        }
    }

    private boolean isSmall(double fromX, double fromZ, double toX, double toZ) {
        // Written so that what is not a number fails it.
        return Math.abs(fromX) < 0x1p40
                && Math.abs(fromZ) < 0x1p40
                && (toX - fromX + 1) * (toZ - fromZ + 1) <= mostCells;
    }

    private int slot(long i, long j) {
        long mixed = i * 0x9E3779B97F4A7C15L + j * 0xC2B2AE3D27D4EB4FL;
        return (int) (mixed >>> 40) & (slots - 1);
    }

    /** Writes the items whose boxes meet a box to {@link #found}, in ascending order. */
    void find(double minX, double minZ, double maxX, double maxZ) {
        findAbove(-1, minX, minZ, maxX, maxZ);
    }

    /**
     * Writes those above an item. For any item but -1 the boxes must have been given in the order of their indices, each once:
     * then the entries of a cell, of which the last is the first, come in descending order.
     */
    void findAbove(int above, double minX, double minZ, double maxX, double maxZ) {
        foundCount = 0;
        double fromX = Math.floor(minX / cell);
        double fromZ = Math.floor(minZ / cell);
        double toX = Math.floor(maxX / cell);
        double toZ = Math.floor(maxZ / cell);
        if (!isSmall(fromX, fromZ, toX, toZ)) {
            for (int item = above + 1; item < count; item++) {
                if (overlaps(item, minX, minZ, maxX, maxZ)) {
                    found[foundCount++] = item;
                }
            }
            return;
        }
        if (++stamp == Integer.MAX_VALUE) {
            Arrays.fill(seen, 0);
            stamp = 1;
        }
        for (int k = largeCount - 1; k >= 0 && large[k] > above; k--) {
            see(large[k], minX, minZ, maxX, maxZ);
        }
        for (long j = (long) fromZ; j <= (long) toZ; j++) {
            for (long i = (long) fromX; i <= (long) toX; i++) {
                for (int entry = heads[slot(i, j)]; entry >= 0 && items[entry] > above; entry = next[entry]) {
                    see(items[entry], minX, minZ, maxX, maxZ);
                }
            }
        }
        sort();
    }

    private void see(int item, double minX, double minZ, double maxX, double maxZ) {
        if (seen[item] != stamp) {
            seen[item] = stamp;
            if (overlaps(item, minX, minZ, maxX, maxZ)) {
                found[foundCount++] = item;
            }
        }
    }

    private boolean overlaps(int item, double minX, double minZ, double maxX, double maxZ) {
        int at = 4 * item;
        return boxes[at] <= maxX && boxes[at + 2] >= minX && boxes[at + 1] <= maxZ && boxes[at + 3] >= minZ;
    }

    /** Few at a time, so that the simplest way is quick. */
    private void sort() {
        for (int k = 1; k < foundCount; k++) {
            int item = found[k];
            int at = k;
            while (at > 0 && found[at - 1] > item) {
                found[at] = found[at - 1];
                at--;
            }
            found[at] = item;
        }
    }
}
