package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * The lists of objects of all {@link Tiles} of a layer, nested ones included, in one array. A tile has a slot of {@link
 * #STRIDE} numbers: the length of its list of ids, then the list itself if it fits, else where it begins. Most lists
 * fit, so a query needs one memory access per tile. Unused room of a slot is filled with {@link OrientedRectangle#NOWHERE}, so
 * that a query may read all of it instead of branching on a length that would be mispredicted. A second array has, at
 * the index of each id, the object's {@link QuantizedBounds} relative to the tile.
 */
final class TileLists {
    /** Number of ints in a tile's slot. */
    static final int STRIDE = 4;

    /** Longer lists are stored outside the slot. */
    static final int SHORT = STRIDE - 1;

    /** The room for the shortest of these lists; it doubles as they grow. */
    private static final int LEAST = 8;

    private static final int NONE = -1;

    int[] data = new int[16];

    /** The quantized bounds; empty if they are not kept, since they are useless for a single tile. */
    int[] quantizedBounds;

    private int used;

    /** Unused runs of the array, by the logarithm of their length; each holds the index of the next one. */
    private final int[] free = new int[Integer.SIZE];

    TileLists(boolean hasQuantizedBounds) {
        quantizedBounds = new int[hasQuantizedBounds ? data.length : 0];
        Arrays.fill(free, NONE);
    }

    boolean hasQuantizedBounds() {
        return quantizedBounds.length > 0;
    }

    /** Adds the empty lists of a number of tiles; returns where the slot of the first begins. */
    int append(int tiles) {
        int first = claim(STRIDE * tiles);
        Arrays.fill(data, first, first + STRIDE * tiles, OrientedRectangle.NOWHERE);
        if (hasQuantizedBounds()) {
            Arrays.fill(quantizedBounds, first, first + STRIDE * tiles, QuantizedBounds.NOWHERE);
        }
        for (int place = first; place < first + STRIDE * tiles; place += STRIDE) {
            data[place] = 0;
        }
        return first;
    }

    /** Where the list of a slot begins, given its length. */
    static int first(int[] data, int place, int length) {
        return length > SHORT ? data[place + 1] : place + 1;
    }

    /** Appends an object to a list. */
    void push(int place, int id, int quantized) {
        int length = data[place];
        if (length >= SHORT && (length == SHORT || length == room(length))) {
            relocate(place, length, room(length + 1));
        }
        int at = first(data, place, length + 1) + length;
        data[at] = id;
        if (hasQuantizedBounds()) {
            quantizedBounds[at] = quantized;
        }
        data[place] = length + 1;
    }

    /** Removes an object from the list that it is in. */
    void strike(int place, int id) {
        int last = data[place] - 1;
        int first = first(data, place, last + 1);
        copy(first + last, find(first, id), 1);
        data[first + last] = OrientedRectangle.NOWHERE;
        if (hasQuantizedBounds()) {
            quantizedBounds[first + last] = QuantizedBounds.NOWHERE;
        }
        data[place] = last;
        if (last == SHORT) {
            copy(first, place + 1, SHORT);
            giveUp(first, LEAST);
        } else if (last > SHORT && room(last) < room(last + 1)) {
            relocate(place, last, room(last));
        }
    }

    /** Changes the quantized bounds of an object in a list. */
    void requantize(int place, int id, int quantized) {
        if (hasQuantizedBounds()) {
            quantizedBounds[find(first(data, place, data[place]), id)] = quantized;
        }
    }

    private int find(int first, int id) {
        int at = first;
        while (data[at] != id) {
            at++;
        }
        return at;
    }

    private void copy(int from, int to, int count) {
        System.arraycopy(data, from, data, to, count);
        if (hasQuantizedBounds()) {
            System.arraycopy(quantizedBounds, from, quantizedBounds, to, count);
        }
    }

    /** The room of a list that is stored outside its slot. */
    private static int room(int length) {
        return Math.max(LEAST, Integer.highestOneBit(2 * length - 1));
    }

    /** Moves a list to a run with more or less room. */
    private void relocate(int place, int length, int room) {
        int to = take(room);
        int from = first(data, place, length);
        copy(from, to, length);
        if (length > SHORT) {
            giveUp(from, room(length) == room ? 2 * room : room / 2);
        }
        data[place + 1] = to;
    }

    private int take(int room) {
        int sort = Integer.numberOfTrailingZeros(room);
        int first = free[sort];
        if (first == NONE) {
            return claim(room);
        }
        free[sort] = data[first];
        return first;
    }

    private void giveUp(int first, int room) {
        int sort = Integer.numberOfTrailingZeros(room);
        data[first] = free[sort];
        free[sort] = first;
    }

    private int claim(int numbers) {
        if (data.length - used < numbers) {
            resize(Math.max(used + numbers, used + (used >> 3)));
        }
        int first = used;
        used += numbers;
        return first;
    }

    /** Gives up spare room. */
    void trim() {
        resize(used);
    }

    private void resize(int capacity) {
        data = Arrays.copyOf(data, capacity);
        quantizedBounds = Arrays.copyOf(quantizedBounds, hasQuantizedBounds() ? capacity : 0);
    }
}
