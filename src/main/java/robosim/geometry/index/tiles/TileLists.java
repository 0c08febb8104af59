package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * The lists of objects of all {@link Tiles} of a layer, also of those within others, in one array. A tile has a place of
 * {@link #STRIDE} numbers: how long its list of ids is, and as long as it has room the list itself, else where it begins. Most
 * lists are that short, and one look at memory is all that a query needs of a tile. Where a list is shorter still, {@link
 * Outline#NOWHERE} fills its room: so who would guess wrong how long it is can read all of it. Another array has, where an
 * id stands in the first, the object's {@link QuantizedBounds} about the tile.
 */
final class TileLists {
    /** Numbers of a tile's place. */
    static final int STRIDE = 4;

    /** Longer lists stand elsewhere. */
    static final int SHORT = STRIDE - 1;

    /** Room for the shortest of these; it doubles as they grow. */
    private static final int LEAST = 8;

    private static final int NONE = -1;

    int[] data = new int[16];

    /** Empty where these are not kept: of a single tile they tell nothing. */
    int[] sketches;

    private int used;

    /** By the logarithm of their length, runs that nobody uses; each holds where the next one begins. */
    private final int[] free = new int[Integer.SIZE];

    TileLists(boolean hasSketches) {
        sketches = new int[hasSketches ? data.length : 0];
        Arrays.fill(free, NONE);
    }

    boolean hasSketches() {
        return sketches.length > 0;
    }

    /** Makes room for the empty lists of so many tiles; answers where the first one's place is. */
    int append(int tiles) {
        int first = claim(STRIDE * tiles);
        Arrays.fill(data, first, first + STRIDE * tiles, Outline.NOWHERE);
        if (hasSketches()) {
            Arrays.fill(sketches, first, first + STRIDE * tiles, QuantizedBounds.NOWHERE);
        }
        for (int place = first; place < first + STRIDE * tiles; place += STRIDE) {
            data[place] = 0;
        }
        return first;
    }

    /** Where the list of a place begins, given how long it is. */
    static int first(int[] data, int place, int length) {
        return length > SHORT ? data[place + 1] : place + 1;
    }

    /** Puts an object at the end of a list. */
    void push(int place, int id, int sketch) {
        int length = data[place];
        if (length >= SHORT && (length == SHORT || length == room(length))) {
            relocate(place, length, room(length + 1));
        }
        int at = first(data, place, length + 1) + length;
        data[at] = id;
        if (hasSketches()) {
            sketches[at] = sketch;
        }
        data[place] = length + 1;
    }

    /** Takes an object out of the list that it is in. */
    void strike(int place, int id) {
        int last = data[place] - 1;
        int first = first(data, place, last + 1);
        copy(first + last, find(first, id), 1);
        data[first + last] = Outline.NOWHERE;
        if (hasSketches()) {
            sketches[first + last] = QuantizedBounds.NOWHERE;
        }
        data[place] = last;
        if (last == SHORT) {
            copy(first, place + 1, SHORT);
            giveUp(first, LEAST);
        } else if (last > SHORT && room(last) < room(last + 1)) {
            relocate(place, last, room(last));
        }
    }

    /** Gives an object of a list another sketch. */
    void redraw(int place, int id, int sketch) {
        if (hasSketches()) {
            sketches[find(first(data, place, data[place]), id)] = sketch;
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
        if (hasSketches()) {
            System.arraycopy(sketches, from, sketches, to, count);
        }
    }

    /** The room of a list that stands elsewhere. */
    private static int room(int length) {
        return Math.max(LEAST, Integer.highestOneBit(2 * length - 1));
    }

    /** Moves a list elsewhere, to a run with more room or less. */
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

    /** Gives up room that there is for more. */
    void trim() {
        resize(used);
    }

    private void resize(int capacity) {
        data = Arrays.copyOf(data, capacity);
        sketches = Arrays.copyOf(sketches, hasSketches() ? capacity : 0);
    }
}
