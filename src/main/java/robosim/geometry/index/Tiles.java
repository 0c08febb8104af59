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
    /** In tiles. A walk of at most {@link #REACH} tiles errs by less than 2^-27: see {@link TileWalk}. */
    static final double MARGIN = 0x1p-20;

    /** The farthest place, in tiles from the window's corner, from which a walk may start. */
    static final double REACH = 0x1p22;

    /** Most tiles that an object may lie on. */
    private static final int MOST_TILES = 32;

    private static final int MOST_BITS = 24;
    static final int NONE = -1;

    /** By tile, its first entry or {@link #NONE}. */
    int[] heads;

    /** By entry, two numbers: the object's id and the next entry of the same tile. */
    int[] entries;

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
    private int used;
    private int freeEntry = NONE;
    private int objects;

    /** Some {@code 2^bits} tiles over a window, or a single one, without limits, where it cannot be divided. */
    Tiles(double minX, double minZ, double maxX, double maxZ, int bits, int capacity) {
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
        entries = new int[2 * Math.max(8, capacity)];
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
                push(x | z, id);
                x = up(x, maskX);
            }
            z = up(z, maskZ);
        }
        objects++;
    }

    private void push(int tile, int id) {
        int entry = freeEntry;
        if (entry == NONE) {
            entry = used++;
            if (2 * entry == entries.length) {
                entries = Arrays.copyOf(entries, 2 * (entry + (entry >> 1) + 4));
            }
        } else {
            freeEntry = entries[2 * entry + 1];
        }
        entries[2 * entry] = id;
        entries[2 * entry + 1] = heads[tile];
        heads[tile] = entry;
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
                strike(x | z, id);
                x = up(x, maskX);
            }
            z = up(z, maskZ);
        }
        objects--;
    }

    private void strike(int tile, int id) {
        int before = NONE;
        int entry = heads[tile];
        while (entries[2 * entry] != id) {
            before = entry;
            entry = entries[2 * entry + 1];
        }
        if (before == NONE) {
            heads[tile] = entries[2 * entry + 1];
        } else {
            entries[2 * before + 1] = entries[2 * entry + 1];
        }
        entries[2 * entry + 1] = freeEntry;
        freeEntry = entry;
    }

    /** Whether two boxes that fit lie on the same tiles. */
    boolean sameTiles(double[] boxes, int one, int two) {
        return column(boxes[one], -MARGIN) == column(boxes[two], -MARGIN)
                && column(boxes[one + 2], MARGIN) == column(boxes[two + 2], MARGIN)
                && row(boxes[one + 1], -MARGIN) == row(boxes[two + 1], -MARGIN)
                && row(boxes[one + 3], MARGIN) == row(boxes[two + 3], MARGIN);
    }

    /** Puts the entries of each tile beside each other, tile after tile, each tile's in the order of ids. */
    void arrange() {
        int[] arranged = new int[Math.max(16, 2 * used)];
        int to = 0;
        for (int tile = 0; tile < heads.length; tile++) {
            int first = to;
            for (int entry = heads[tile]; entry != NONE; entry = entries[2 * entry + 1]) {
                arranged[2 * to++] = entries[2 * entry];
            }
            heads[tile] = to == first ? NONE : first;
            link(arranged, first, to);
        }
        entries = arranged;
        used = to;
        freeEntry = NONE;
    }

    // Lists grow at their heads: turned round, they are in the order in which they came.
    private static void link(int[] of, int first, int to) {
        for (int low = first, high = to - 1; low < high; low++, high--) {
            int id = of[2 * low];
            of[2 * low] = of[2 * high];
            of[2 * high] = id;
        }
        for (int entry = first; entry < to; entry++) {
            of[2 * entry + 1] = entry + 1 == to ? NONE : entry + 1;
        }
    }

    /** Appends the objects not met before, in the order of tiles, and answers where the list then ends. */
    int order(boolean[] met, int[] order, int from) {
        int to = from;
        for (int head : heads) {
            for (int entry = head; entry != NONE; entry = entries[2 * entry + 1]) {
                int id = entries[2 * entry];
                if (!met[id]) {
                    met[id] = true;
                    order[to++] = id;
                }
            }
        }
        return to;
    }

    /** Gives all objects new ids. */
    void renumber(int[] newIds) {
        for (int entry = 0; entry < used; entry++) {
            entries[2 * entry] = newIds[entries[2 * entry]];
        }
    }
}
