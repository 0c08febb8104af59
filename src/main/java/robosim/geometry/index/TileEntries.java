package robosim.geometry.index;

import java.util.Arrays;

/** The lists of objects of all {@link Tiles} of a layer, also of those within others. */
final class TileEntries {
    /** By entry, two numbers: the object's id and the next entry of the same list. */
    int[] data;

    /** By entry, four numbers: the object's box, rounded outward. A query reads them one after the other. */
    float[] bounds;

    private int used;
    private int free = Tiles.NONE;

    TileEntries(int capacity) {
        data = new int[2 * Math.max(8, capacity)];
        bounds = new float[2 * data.length];
    }

    /** How many entries there are, also free ones. */
    int used() {
        return used;
    }

    /** A list with one more object in front; answers its first entry. */
    int push(int head, int id, double[] boxes, int at) {
        int entry = free;
        if (entry == Tiles.NONE) {
            entry = append();
        } else {
            free = data[2 * entry + 1];
        }
        data[2 * entry] = id;
        data[2 * entry + 1] = head;
        write(entry, boxes, at);
        return entry;
    }

    void write(int entry, double[] boxes, int at) {
        bounds[4 * entry] = down(boxes[at]);
        bounds[4 * entry + 1] = down(boxes[at + 1]);
        bounds[4 * entry + 2] = up(boxes[at + 2]);
        bounds[4 * entry + 3] = up(boxes[at + 3]);
    }

    /** The entry of an object that is in a list. */
    int find(int head, int id) {
        int entry = head;
        while (data[2 * entry] != id) {
            entry = data[2 * entry + 1];
        }
        return entry;
    }

    private int append() {
        if (2 * used == data.length) {
            data = Arrays.copyOf(data, 2 * (used + (used >> 1) + 4));
            bounds = Arrays.copyOf(bounds, 2 * data.length);
        }
        return used++;
    }

    // A float is within 2^-24 of a double, or within 2^-150: this is below it by more, and by at most 2^-22 of it.
    private static float down(double number) {
        float below = (float) (number - (Math.abs(number) * 0x1p-23 + Float.MIN_VALUE));
        return below == Float.POSITIVE_INFINITY ? Float.MAX_VALUE : below;
    }

    private static float up(double number) {
        return -down(-number);
    }

    /** A list without an object that is in it; answers its first entry. */
    int strike(int head, int id) {
        int before = Tiles.NONE;
        int entry = head;
        while (data[2 * entry] != id) {
            before = entry;
            entry = data[2 * entry + 1];
        }
        int after = data[2 * entry + 1];
        data[2 * entry + 1] = free;
        free = entry;
        if (before == Tiles.NONE) {
            return after;
        }
        data[2 * before + 1] = after;
        return head;
    }

    int length(int head) {
        int length = 0;
        for (int entry = head; entry != Tiles.NONE; entry = data[2 * entry + 1]) {
            length++;
        }
        return length;
    }

    /** Copies a list to the end of another store; answers its first entry there. */
    int copy(int head, TileEntries to) {
        int first = to.used;
        for (int entry = head; entry != Tiles.NONE; entry = data[2 * entry + 1]) {
            int copy = to.append();
            to.data[2 * copy] = data[2 * entry];
            to.data[2 * copy + 1] = copy + 1;
            System.arraycopy(bounds, 4 * entry, to.bounds, 4 * copy, 4);
        }
        if (to.used == first) {
            return Tiles.NONE;
        }
        to.data[2 * to.used - 1] = Tiles.NONE;
        return first;
    }

    /** Becomes what another store is, of which no entry is free. */
    void take(TileEntries other) {
        data = other.data;
        bounds = other.bounds;
        used = other.used;
        free = Tiles.NONE;
    }
}
