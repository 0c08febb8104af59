package robosim.geometry.index;

import java.util.Arrays;

/**
 * Regions of one depth of a {@link QuadTree}, all of one size, found by arithmetic instead of a descent: the number of a
 * tile is its path, bit by bit, through the cuts above it, so tiles that are near in the world are near in memory. Each
 * tile lists the objects whose boxes meet it.
 *
 * <p>Tiles cover a window. What reaches out of it or lies on too many tiles does not fit. Boxes are listed as if they were
 * wider by {@link #MARGIN} of a tile on all sides: a walk that misjudges its way by less than that meets all the same
 * objects.
 */
final class Tiles {
    /** In tiles. A walk of at most {@link #REACH} tiles errs by less than 2^-26: see {@link TileWalk}. */
    static final double MARGIN = 0x1p-10;

    /** The farthest place, in tiles from the window's corner, from which a walk may start. */
    static final double REACH = 0x1p22;

    /** Most tiles that an object may lie on. */
    private static final int MOST_TILES = 32;

    private static final int MOST_BITS = 24;
    static final int NONE = -1;

    /** A tile with more entries than these is divided, if that leaves fewer of them to each part. */
    private static final int CROWD = 12;

    /** Cuts along both axes together at once in a crowded tile, and how often parts may be divided again: see MARGIN. */
    private static final int MOST_INNER_BITS = 8;

    private static final int MOST_DEPTH = 3;

    /** By tile, its first entry, {@link #NONE}, or for a divided one the number of what it holds, below NONE. */
    final int[] heads;

    /** Of divided tiles, by {@code NONE - 1 - head}. */
    private Tiles[] inner = {};

    private int innerCount;

    /** The first entry of what is too large for the tiles within the outer tile that these divide. */
    int rest = NONE;

    final Entries store;

    /** The lists of all tiles, also of those within others. */
    static final class Entries {
        /** By entry, two numbers: the object's id and the next entry of the same list. */
        int[] data;

        private int used;
        private int free = NONE;

        Entries(int capacity) {
            data = new int[2 * Math.max(8, capacity)];
        }

        /** A list with one more object in front; answers its first entry. */
        private int push(int head, int id) {
            int entry = free;
            if (entry == NONE) {
                entry = used++;
                if (2 * entry == data.length) {
                    data = Arrays.copyOf(data, 2 * (entry + (entry >> 1) + 4));
                }
            } else {
                free = data[2 * entry + 1];
            }
            data[2 * entry] = id;
            data[2 * entry + 1] = head;
            return entry;
        }

        /** A list without an object that is in it; answers its first entry. */
        private int strike(int head, int id) {
            int before = NONE;
            int entry = head;
            while (data[2 * entry] != id) {
                before = entry;
                entry = data[2 * entry + 1];
            }
            int after = data[2 * entry + 1];
            data[2 * entry + 1] = free;
            free = entry;
            if (before == NONE) {
                return after;
            }
            data[2 * before + 1] = after;
            return head;
        }

        private int length(int head) {
            int length = 0;
            for (int entry = head; entry != NONE; entry = data[2 * entry + 1]) {
                length++;
            }
            return length;
        }

        /** Copies a list to the end of another store, oldest first; answers its first entry there. */
        private int copy(int head, Entries to) {
            int first = to.used;
            for (int entry = head; entry != NONE; entry = data[2 * entry + 1]) {
                to.push(NONE, data[2 * entry]);
            }
            int[] of = to.data;
            // Lists grow at their heads: turned round, they are in the order in which they came.
            for (int low = first, high = to.used - 1; low < high; low++, high--) {
                int id = of[2 * low];
                of[2 * low] = of[2 * high];
                of[2 * high] = id;
            }
            for (int entry = first; entry < to.used; entry++) {
                of[2 * entry + 1] = entry + 1 == to.used ? NONE : entry + 1;
            }
            return to.used == first ? NONE : first;
        }
    }

    final double originX;
    final double originZ;

    /** Tiles a unit. */
    final double scaleX;

    final double scaleZ;

    final int countX;
    final int countZ;

    /** The bits of a tile's number that count along each axis. */
    final int maskX;

    final int maskZ;

    private final double maxX;
    private final double maxZ;
    private int objects;

    /** Some {@code 2^bits} tiles over a window, or a single one, without limits, where it cannot be divided. */
    Tiles(double minX, double minZ, double maxX, double maxZ, int bits, Entries store) {
        this.store = store;
        double width = maxX - minX;
        double length = maxZ - minZ;
        int most = isOrdinary(width) && isOrdinary(length) ? Math.min(bits, MOST_BITS) : 0;
        int longer = most == 0 ? 0 : Math.getExponent(width / length);
        int bitsX = Math.max(0, Math.min(most, (most + longer + 1) >> 1));
        int bitsZ = most - bitsX;
        countX = 1 << bitsX;
        countZ = 1 << bitsZ;
        originX = most == 0 ? 0 : minX;
        originZ = most == 0 ? 0 : minZ;
        scaleX = most == 0 ? 0 : countX / width;
        scaleZ = most == 0 ? 0 : countZ / length;
        this.maxX = maxX;
        this.maxZ = maxZ;
        int[] masks = masks(bitsX, bitsZ);
        maskX = masks[0];
        maskZ = masks[1];
        heads = new int[1 << most];
        Arrays.fill(heads, NONE);
    }

    private static boolean isOrdinary(double size) {
        return size > 0x1p-300 && size < 0x1p300;
    }

    /** Cuts along X and Z in turn as long as both axes have cuts left, the last ones in the lowest bits. */
    private static int[] masks(int bitsX, int bitsZ) {
        int x = 0;
        int z = 0;
        int bit = 0;
        for (int level = 0; level < Math.max(bitsX, bitsZ); level++) {
            if (level < bitsX) {
                x |= 1 << bit++;
            }
            if (level < bitsZ) {
                z |= 1 << bit++;
            }
        }
        return new int[] {x, z};
    }

    /** Whether there is one tile only, which everything fits. */
    boolean isSingle() {
        return heads.length == 1;
    }

    boolean isEmpty() {
        return objects == 0;
    }

    int objects() {
        return objects;
    }

    /** Spreads the bits of a column or row over those of a mask. */
    static int spread(int number, int mask) {
        int spread = 0;
        int left = number;
        for (int rest = mask; left != 0; rest &= rest - 1) {
            if ((left & 1) != 0) {
                spread |= rest & -rest;
            }
            left >>>= 1;
        }
        return spread;
    }

    /** The next column or row up, of spread bits. */
    static int up(int spread, int mask) {
        return ((spread | ~mask) + 1) & mask;
    }

    /** The column of a place; never decreases with it. */
    int column(double x, double margin) {
        return clamp((x - originX) * scaleX + margin, countX);
    }

    int row(double z, double margin) {
        return clamp((z - originZ) * scaleZ + margin, countZ);
    }

    private static int clamp(double place, int count) {
        return (int) Math.max(0, Math.min(count - 1, place));
    }

    boolean fits(double[] boxes, int at) {
        if (isSingle()) {
            return true;
        }
        if (!(boxes[at] >= originX && boxes[at + 1] >= originZ && boxes[at + 2] <= maxX && boxes[at + 3] <= maxZ)) {
            return false;
        }
        return isSmall(boxes, at);
    }

    private boolean isSmall(double[] boxes, int at) {
        double wide = (boxes[at + 2] - boxes[at]) * scaleX + 2;
        double deep = (boxes[at + 3] - boxes[at + 1]) * scaleZ + 2;
        return wide * deep <= MOST_TILES;
    }

    /** Lists a box that fits. */
    void add(int id, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 2], MARGIN);
        int z0 = row(boxes[at + 1], -MARGIN);
        int z1 = row(boxes[at + 3], MARGIN);
        int startX = spread(x0, maskX);
        int z = spread(z0, maskZ);
        for (int row = z0; row <= z1; row++) {
            int x = startX;
            for (int column = x0; column <= x1; column++) {
                push(x | z, id, boxes, at);
                x = up(x, maskX);
            }
            z = up(z, maskZ);
        }
        objects++;
    }

    private void push(int tile, int id, double[] boxes, int at) {
        int head = heads[tile];
        if (head < NONE) {
            within(head).addPart(id, boxes, at);
        } else {
            heads[tile] = store.push(head, id);
        }
    }

    /** Lists a box of which a part is here, within a tile. */
    private void addPart(int id, double[] boxes, int at) {
        if (isSmall(boxes, at)) {
            add(id, boxes, at);
        } else {
            rest = store.push(rest, id);
        }
    }

    /** The tiles within a divided one. */
    Tiles within(int head) {
        return inner[NONE - 1 - head];
    }

    /** Strikes a box that is listed, by the same numbers. */
    void remove(int id, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 2], MARGIN);
        int z0 = row(boxes[at + 1], -MARGIN);
        int z1 = row(boxes[at + 3], MARGIN);
        int startX = spread(x0, maskX);
        int z = spread(z0, maskZ);
        for (int row = z0; row <= z1; row++) {
            int x = startX;
            for (int column = x0; column <= x1; column++) {
                strike(x | z, id, boxes, at);
                x = up(x, maskX);
            }
            z = up(z, maskZ);
        }
        objects--;
    }

    private void strike(int tile, int id, double[] boxes, int at) {
        int head = heads[tile];
        if (head < NONE) {
            within(head).removePart(id, boxes, at);
        } else {
            heads[tile] = store.strike(head, id);
        }
    }

    private void removePart(int id, double[] boxes, int at) {
        if (isSmall(boxes, at)) {
            remove(id, boxes, at);
        } else {
            rest = store.strike(rest, id);
        }
    }

    /** Whether two boxes that fit, the second at the start of an array, are surely listed alike. */
    boolean sameTiles(double[] boxes, int at, double[] other) {
        return innerCount == 0
                && column(boxes[at], -MARGIN) == column(other[0], -MARGIN)
                && column(boxes[at + 2], MARGIN) == column(other[2], MARGIN)
                && row(boxes[at + 1], -MARGIN) == row(other[1], -MARGIN)
                && row(boxes[at + 3], MARGIN) == row(other[3], MARGIN);
    }

    /** Divides tiles with long lists, their parts too. */
    void divideCrowded(double[] boxes) {
        if (!isSingle()) {
            divideCrowded(boxes, 1);
        }
    }

    private void divideCrowded(double[] boxes, int depth) {
        for (int tile = 0; tile < heads.length; tile++) {
            int length = heads[tile] == NONE ? 0 : store.length(heads[tile]);
            if (length > CROWD) {
                divide(tile, length, boxes, depth);
            }
        }
    }

    private void divide(int tile, int length, double[] boxes, int depth) {
        int bits = Math.min(MOST_INNER_BITS, Integer.SIZE - Integer.numberOfLeadingZeros(length)) & ~1;
        double x = originX + gather(tile, maskX) / scaleX;
        double z = originZ + gather(tile, maskZ) / scaleZ;
        Tiles parts = new Tiles(x, z, x + 1 / scaleX, z + 1 / scaleZ, bits, store);
        if (parts.isSingle() || parts.holdsFew(store, heads[tile], length, boxes)) {
            return;
        }
        for (int entry = heads[tile]; entry != NONE; entry = heads[tile]) {
            int id = store.data[2 * entry];
            heads[tile] = store.strike(entry, id);
            parts.addPart(id, boxes, 4 * id);
        }
        if (depth < MOST_DEPTH) {
            parts.divideCrowded(boxes, depth + 1);
        }
        if (innerCount == inner.length) {
            inner = Arrays.copyOf(inner, Math.max(4, 2 * innerCount));
        }
        inner[innerCount] = parts;
        heads[tile] = NONE - 1 - innerCount++;
    }

    /** Whether most of a list would be too large for these tiles. */
    private boolean holdsFew(Entries of, int head, int length, double[] boxes) {
        int small = 0;
        for (int entry = head; entry != NONE; entry = of.data[2 * entry + 1]) {
            small += isSmall(boxes, 4 * of.data[2 * entry]) ? 1 : 0;
        }
        return 2 * small < length;
    }

    /** The column or row of a tile's number: the bits of a mask, beside each other. */
    private static int gather(int tile, int mask) {
        int gathered = 0;
        int to = 0;
        for (int rest = mask; rest != 0; rest &= rest - 1) {
            gathered |= (tile & rest & -rest) != 0 ? 1 << to : 0;
            to++;
        }
        return gathered;
    }

    /** Puts the entries of each tile beside each other, tile after tile, each tile's in the order in which they came. */
    void arrange() {
        Entries arranged = new Entries(store.used);
        arrange(arranged);
        store.data = arranged.data;
        store.used = arranged.used;
        store.free = NONE;
    }

    private void arrange(Entries to) {
        rest = store.copy(rest, to);
        for (int tile = 0; tile < heads.length; tile++) {
            if (heads[tile] < NONE) {
                within(heads[tile]).arrange(to);
            } else {
                heads[tile] = store.copy(heads[tile], to);
            }
        }
    }

    /** All entries in the order of tiles, as {@link #arrange()} leaves them: three or so for an object. */
    int entries() {
        return store.used;
    }
}
