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

    final TileEntries store;

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

    /** How many bits both axes have, which take turns; those that only one has are above them. */
    private final int commonBits;

    private final int common;
    private final double maxX;
    private final double maxZ;
    private int objects;

    /** Some {@code 2^bits} tiles over a window, or a single one, without limits, where it cannot be divided. */
    Tiles(double minX, double minZ, double maxX, double maxZ, int bits, TileEntries store) {
        this.store = store;
        double width = maxX - minX;
        double length = maxZ - minZ;
        int most = isOrdinary(width) && isOrdinary(length) ? Math.min(bits, MOST_BITS) : 0;
        int longer = most == 0 ? 0 : longer(width, length);
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
        commonBits = Math.min(bitsX, bitsZ);
        common = (1 << commonBits) - 1;
        maskX = spreadX(countX - 1);
        maskZ = spreadZ(countZ - 1);
        heads = new int[1 << most];
        Arrays.fill(heads, NONE);
    }

    /** How many cuts more there are along X than along Z where tiles are about square. */
    static int longer(double width, double length) {
        return Math.getExponent(Math.sqrt(2) * (width / length));
    }

    /** One tile, which everything fits, with room for so many objects. */
    static Tiles single(int capacity) {
        return new Tiles(0, 0, 0, 0, 0, new TileEntries(capacity));
    }

    private static boolean isOrdinary(double size) {
        return size > 0x1p-300 && size < 0x1p300;
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

    /** The bits of a column's number in their places in a tile's. */
    int spreadX(int column) {
        return dilated(column & common) | (column & ~common) << commonBits;
    }

    /** The bits of a row's number in their places in a tile's. */
    int spreadZ(int row) {
        return dilated(row & common) << 1 | (row & ~common) << commonBits;
    }

    /** Puts a zero above each of the lower 16 bits. */
    private static int dilated(int number) {
        int n = (number | number << 8) & 0x00ff00ff;
        n = (n | n << 4) & 0x0f0f0f0f;
        n = (n | n << 2) & 0x33333333;
        return (n | n << 1) & 0x55555555;
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
        return Math.max(0, Math.min((int) place, count - 1));
    }

    boolean fits(double[] boxes, int at) {
        if (isSingle()) {
            return true;
        }
        if (!(boxes[at] >= originX && boxes[at + 2] >= originZ && boxes[at + 3] <= maxX && boxes[at + 5] <= maxZ)) {
            return false;
        }
        return isSmall(boxes, at);
    }

    private boolean isSmall(double[] boxes, int at) {
        double wide = (boxes[at + 3] - boxes[at]) * scaleX + 2;
        double deep = (boxes[at + 5] - boxes[at + 2]) * scaleZ + 2;
        return wide * deep <= MOST_TILES;
    }

    /** Lists a box that fits. */
    void add(int id, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 3], MARGIN);
        int z0 = row(boxes[at + 2], -MARGIN);
        int z1 = row(boxes[at + 5], MARGIN);
        int startX = spreadX(x0);
        int z = spreadZ(z0);
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
            heads[tile] = store.push(head, id, boxes, at);
        }
    }

    /** Lists a box of which a part is here, within a tile. */
    private void addPart(int id, double[] boxes, int at) {
        if (isSmall(boxes, at)) {
            add(id, boxes, at);
        } else {
            rest = store.push(rest, id, boxes, at);
        }
    }

    /** The tiles within a divided one. */
    Tiles within(int head) {
        return inner[NONE - 1 - head];
    }

    /** Strikes a box that is listed, by the same numbers. */
    void remove(int id, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 3], MARGIN);
        int z0 = row(boxes[at + 2], -MARGIN);
        int z1 = row(boxes[at + 5], MARGIN);
        int startX = spreadX(x0);
        int z = spreadZ(z0);
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

    /** Lists a box anew that was listed by other numbers; both fit. */
    void move(int id, double[] before, int from, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 3], MARGIN);
        int z0 = row(boxes[at + 2], -MARGIN);
        int z1 = row(boxes[at + 5], MARGIN);
        boolean isSame = x0 == column(before[from], -MARGIN)
                && x1 == column(before[from + 3], MARGIN)
                && z0 == row(before[from + 2], -MARGIN)
                && z1 == row(before[from + 5], MARGIN);
        if (!isSame) {
            remove(id, before, from);
            add(id, boxes, at);
            return;
        }
        int startX = spreadX(x0);
        int z = spreadZ(z0);
        for (int row = z0; row <= z1; row++) {
            int x = startX;
            for (int column = x0; column <= x1; column++) {
                moveWithin(x | z, id, before, from, boxes, at);
                x = up(x, maskX);
            }
            z = up(z, maskZ);
        }
    }

    private void moveWithin(int tile, int id, double[] before, int from, double[] boxes, int at) {
        int head = heads[tile];
        if (head < NONE) {
            within(head).removePart(id, before, from);
            within(head).addPart(id, boxes, at);
        } else {
            store.write(store.find(head, id), boxes, at);
        }
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
        if (parts.isSingle() || parts.holdsFew(heads[tile], length, boxes)) {
            return;
        }
        for (int entry = heads[tile]; entry != NONE; entry = heads[tile]) {
            int id = store.id(entry);
            heads[tile] = store.strike(entry, id);
            parts.addPart(id, boxes, 6 * id);
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
    private boolean holdsFew(int head, int length, double[] boxes) {
        int small = 0;
        for (int entry = head; entry != NONE; entry = store.next(entry)) {
            small += isSmall(boxes, 6 * store.id(entry)) ? 1 : 0;
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

    /** Puts the entries of each tile beside each other, tile after tile, each tile's in its own order. */
    void arrange() {
        TileEntries arranged = new TileEntries(store.used());
        arrange(arranged);
        store.take(arranged);
    }

    private void arrange(TileEntries to) {
        rest = store.copy(rest, to);
        for (int tile = 0; tile < heads.length; tile++) {
            if (heads[tile] < NONE) {
                within(heads[tile]).arrange(to);
            } else {
                heads[tile] = store.copy(heads[tile], to);
            }
        }
    }
}
