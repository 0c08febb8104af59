package robosim.geometry.index;

import java.util.Arrays;

/**
 * The lists of objects of all {@link Tiles} of a layer, also of those within others. An entry is known by where it begins,
 * so that a query needs one place in memory for all it wants of it.
 */
final class TileEntries {
    /** Numbers of an entry: the object's box, rounded outward, as least x and z and greatest x and z; its id; its next. */
    static final int STRIDE = 6;

    /** Where the object's id stands, as the bits of an int. */
    static final int ID = 4;

    /** Where the beginning of the next entry of the same list stands, as the bits of an int. */
    static final int NEXT = 5;

    float[] data;

    private int used;
    private int free = Tiles.NONE;

    TileEntries(int capacity) {
        data = new float[STRIDE * Math.max(8, capacity)];
    }

    /** How many entries there are, also free ones. */
    int used() {
        return used / STRIDE;
    }

    int id(int entry) {
        return Float.floatToRawIntBits(data[entry + ID]);
    }

    int next(int entry) {
        return Float.floatToRawIntBits(data[entry + NEXT]);
    }

    private void link(int entry, int next) {
        data[entry + NEXT] = Float.intBitsToFloat(next);
    }

    /** A list with one more object in front; answers its first entry. */
    int push(int head, int id, double[] boxes, int at) {
        int entry = free;
        if (entry == Tiles.NONE) {
            entry = append();
        } else {
            free = next(entry);
        }
        data[entry + ID] = Float.intBitsToFloat(id);
        link(entry, head);
        write(entry, boxes, at);
        return entry;
    }

    void write(int entry, double[] boxes, int at) {
        data[entry] = down(boxes[at]);
        data[entry + 1] = down(boxes[at + 2]);
        data[entry + 2] = up(boxes[at + 3]);
        data[entry + 3] = up(boxes[at + 5]);
    }

    /** The entry of an object that is in a list. */
    int find(int head, int id) {
        int entry = head;
        while (id(entry) != id) {
            entry = next(entry);
        }
        return entry;
    }

    private int append() {
        if (used == data.length) {
            int entries = used / STRIDE;
            data = Arrays.copyOf(data, STRIDE * (entries + (entries >> 1) + 4));
        }
        int entry = used;
        used += STRIDE;
        return entry;
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
        while (id(entry) != id) {
            before = entry;
            entry = next(entry);
        }
        int after = next(entry);
        link(entry, free);
        free = entry;
        if (before == Tiles.NONE) {
            return after;
        }
        link(before, after);
        return head;
    }

    int length(int head) {
        int length = 0;
        for (int entry = head; entry != Tiles.NONE; entry = next(entry)) {
            length++;
        }
        return length;
    }

    /** Copies a list to the end of another store; answers its first entry there. */
    int copy(int head, TileEntries to) {
        int first = to.used;
        for (int entry = head; entry != Tiles.NONE; entry = next(entry)) {
            int copy = to.append();
            System.arraycopy(data, entry, to.data, copy, STRIDE);
            to.link(copy, copy + STRIDE);
        }
        if (to.used == first) {
            return Tiles.NONE;
        }
        to.link(to.used - STRIDE, Tiles.NONE);
        return first;
    }

    /** Becomes what another store is, of which no entry is free. */
    void take(TileEntries other) {
        data = other.data;
        used = other.used;
        free = Tiles.NONE;
    }
}
