package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * The regions of one depth of a {@code QuadTree}, all of one size, stored row by row and found by arithmetic instead of
 * a descent. Each tile lists the objects whose boxes meet it.
 *
 * <p>Tiles cover a window. Objects that extend beyond it or lie on too many tiles do not fit. Boxes are listed as if
 * they were wider by {@link #MARGIN} of a tile on all sides, so a walk whose error is less than that finds all the same
 * objects.
 */
public final class Tiles {
    /**
     * The margin of boxes, in tiles. A walk of at most {@link #REACH} tiles is off by less than 2^-14: see {@link
     * TileWalk}.
     */
    static final double MARGIN = 0x1p-10;

    /** The largest distance from the window's corner, in tiles, at which a walk may start. */
    static final double REACH = 0x1p22;

    /** Maximum number of tiles that an object may lie on. */
    private static final int MOST_TILES = 32;

    /** Maximum number of tiles along an axis, and in all. */
    private static final int MOST_COUNT = 1 << 14;

    private static final long MOST_IN_ALL = 1 << 24;
    public static final int NONE = -1;

    /** Stands for a length where a walk has left the window. */
    static final int OUT = Integer.MIN_VALUE;

    /** A tile with more objects than this is divided, if its parts then have fewer. */
    private static final int CROWD = 12;

    /**
     * Maximum number of tiles along an axis within a crowded tile, and how deep parts may be divided again: see MARGIN.
     */
    private static final int MOST_INNER = 16;

    private static final int MOST_DEPTH = 3;

    /**
     * Where the slots of the tiles begin in the store. For a divided tile, the length of its list is replaced by the
     * index of its nested tiles, from {@link #NONE} downwards. The tiles are surrounded by a row or column of {@link
     * #OUT}. After them comes the list of objects that are on the outer tile divided by these tiles but are too large
     * for them.
     */
    private final int base;

    private final int rowStep;
    private final int rest;

    /** The nested tiles of divided tiles, by {@code NONE - length}. */
    private Tiles[] inner = {};

    private int innerCount;

    final TileLists store;

    final double originX;
    final double originZ;

    /** Tiles per world unit. */
    public final double scaleX;

    public final double scaleZ;

    /** Steps of {@link QuantizedBounds} per world unit. */
    final double stepsX;

    final double stepsZ;

    final int countX;
    final int countZ;

    private final double maxX;
    private final double maxZ;
    private int objects;

    /** What encloses all objects that were listed in lists without quantized bounds. */
    private double fromX = Double.POSITIVE_INFINITY;

    private double fromZ = Double.POSITIVE_INFINITY;
    private double toX = Double.NEGATIVE_INFINITY;
    private double toZ = Double.NEGATIVE_INFINITY;

    /** About a given number of tiles over a window, or a single one without limits if the window cannot be divided. */
    Tiles(double minX, double minZ, double maxX, double maxZ, long tiles, int mostAlong, TileLists store) {
        this.store = store;
        double width = maxX - minX;
        double length = maxZ - minZ;
        boolean isDivided = tiles > 1 && isOrdinary(width) && isOrdinary(length);
        double side = Math.sqrt(width / tiles * length);
        countX = isDivided ? count(width / side, mostAlong) : 1;
        countZ = isDivided ? count((double) tiles / countX, mostAlong) : 1;
        boolean isSingle = countX * countZ == 1;
        originX = isSingle ? 0 : minX;
        originZ = isSingle ? 0 : minZ;
        scaleX = isSingle ? 0 : countX / width;
        scaleZ = isSingle ? 0 : countZ / length;
        stepsX = QuantizedBounds.STEPS * scaleX;
        stepsZ = QuantizedBounds.STEPS * scaleZ;
        this.maxX = maxX;
        this.maxZ = maxZ;
        rowStep = TileLists.STRIDE * (countX + 2);
        base = store.append((countX + 2) * (countZ + 2) + 1);
        rest = base + TileLists.STRIDE * (countX + 2) * (countZ + 2);
        for (int row = -1; row <= countZ; row++) {
            store.data[at(-1, row)] = OUT;
            store.data[at(countX, row)] = OUT;
        }
        for (int column = 0; column < countX; column++) {
            store.data[at(column, -1)] = OUT;
            store.data[at(column, countZ)] = OUT;
        }
    }

    /** About a given number of tiles over a window of a world. */
    static Tiles over(double minX, double minZ, double maxX, double maxZ, long tiles, TileLists store) {
        return new Tiles(minX, minZ, maxX, maxZ, Math.min(tiles, MOST_IN_ALL), MOST_COUNT, store);
    }

    private static int count(double tiles, int most) {
        return (int) Math.max(1, Math.min(most, Math.rint(tiles)));
    }

    /** A single tile, which everything fits. */
    public static Tiles single() {
        return over(0, 0, 0, 0, 1, new TileLists(false));
    }

    private static boolean isOrdinary(double size) {
        return size > 0x1p-300 && size < 0x1p300;
    }

    /** Whether there is only one tile, which everything fits. */
    public boolean isSingle() {
        return countX * countZ == 1;
    }

    public boolean isEmpty() {
        return objects == 0;
    }

    int objects() {
        return objects;
    }

    /** The slot of the list of objects that are too large for the tiles. */
    int rest() {
        return rest;
    }

    boolean hasRest() {
        return store.data[rest()] > 0;
    }

    /** The slot of a tile. */
    int at(int column, int row) {
        return base + (row + 1) * rowStep + TileLists.STRIDE * (column + 1);
    }

    /** The distance between the slots of two rows. */
    int rowStep() {
        return rowStep;
    }

    /** The column of a coordinate; monotonic in it. */
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

    /** A coordinate in tiles from the window's corner. */
    double across(double x) {
        return (x - originX) * scaleX;
    }

    double along(double z) {
        return (z - originZ) * scaleZ;
    }

    /** Whether a rectangle around a point may meet any object of a list without quantized bounds. */
    boolean mayMeetAny(double x, double z, double halfX, double halfZ) {
        return x + halfX >= fromX && x - halfX <= toX && z + halfZ >= fromZ && z - halfZ <= toZ;
    }

    private void enclose(double[] boxes, int at) {
        fromX = Math.min(fromX, boxes[at]);
        fromZ = Math.min(fromZ, boxes[at + 2]);
        toX = Math.max(toX, boxes[at + 3]);
        toZ = Math.max(toZ, boxes[at + 5]);
    }

    /** Adds a box that fits. */
    void add(int id, double[] boxes, int at) {
        if (!store.hasQuantizedBounds()) {
            enclose(boxes, at);
        }
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 3], MARGIN);
        int z1 = row(boxes[at + 5], MARGIN);
        for (int row = row(boxes[at + 2], -MARGIN); row <= z1; row++) {
            for (int column = x0; column <= x1; column++) {
                push(column, row, id, boxes, at);
            }
        }
        objects++;
    }

    private void push(int column, int row, int id, double[] boxes, int at) {
        int tile = at(column, row);
        if (store.data[tile] < 0) {
            within(store.data[tile]).addPart(id, boxes, at);
        } else {
            store.push(
                    tile,
                    id,
                    store.hasQuantizedBounds() ? quantized(column, row, boxes, at) : QuantizedBounds.ANYWHERE);
        }
    }

    private int quantized(int column, int row, double[] boxes, int at) {
        return QuantizedBounds.of(
                QuantizedBounds.low(across(boxes[at])),
                QuantizedBounds.low(along(boxes[at + 2])),
                QuantizedBounds.high(across(boxes[at + 3])),
                QuantizedBounds.high(along(boxes[at + 5])),
                column,
                row);
    }

    /** Adds a box that lies partly on these tiles, which are nested in a tile. */
    private void addPart(int id, double[] boxes, int at) {
        if (isSmall(boxes, at)) {
            add(id, boxes, at);
        } else {
            store.push(rest(), id, QuantizedBounds.ANYWHERE);
        }
    }

    /** The tiles nested in a divided one. */
    Tiles within(int length) {
        return inner[NONE - length];
    }

    /** Removes a box, which must have the same numbers as when it was added. */
    void remove(int id, double[] boxes, int at) {
        int x0 = column(boxes[at], -MARGIN);
        int x1 = column(boxes[at + 3], MARGIN);
        int z1 = row(boxes[at + 5], MARGIN);
        for (int row = row(boxes[at + 2], -MARGIN); row <= z1; row++) {
            for (int tile = at(x0, row); tile <= at(x1, row); tile += TileLists.STRIDE) {
                strike(tile, id, boxes, at);
            }
        }
        objects--;
    }

    private void strike(int tile, int id, double[] boxes, int at) {
        if (store.data[tile] < 0) {
            within(store.data[tile]).removePart(id, boxes, at);
        } else {
            store.strike(tile, id);
        }
    }

    private void removePart(int id, double[] boxes, int at) {
        if (isSmall(boxes, at)) {
            remove(id, boxes, at);
        } else {
            store.strike(rest(), id);
        }
    }

    /** Changes the numbers of a listed box; both the old and the new box fit. */
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
        boolean isNothingNew = innerCount == 0 && !store.hasQuantizedBounds();
        if (!store.hasQuantizedBounds()) {
            enclose(boxes, at);
        }
        for (int row = isNothingNew ? z1 + 1 : z0; row <= z1; row++) {
            for (int column = x0; column <= x1; column++) {
                moveWithin(column, row, id, before, from, boxes, at);
            }
        }
    }

    private void moveWithin(int column, int row, int id, double[] before, int from, double[] boxes, int at) {
        int tile = at(column, row);
        if (store.data[tile] < 0) {
            within(store.data[tile]).removePart(id, before, from);
            within(store.data[tile]).addPart(id, boxes, at);
        } else {
            store.requantize(tile, id, quantized(column, row, boxes, at));
        }
    }

    /** Divides tiles with long lists, and their parts too. */
    void divideCrowded(double[] boxes) {
        if (!isSingle()) {
            divideCrowded(boxes, 1);
        }
    }

    private void divideCrowded(double[] boxes, int depth) {
        for (int row = 0; row < countZ; row++) {
            for (int column = 0; column < countX; column++) {
                if (store.data[at(column, row)] > CROWD) {
                    divide(column, row, boxes, depth);
                }
            }
        }
    }

    private void divide(int column, int row, double[] boxes, int depth) {
        int tile = at(column, row);
        int length = store.data[tile];
        double x = originX + column / scaleX;
        double z = originZ + row / scaleZ;
        if (isCoarse(x, 1 / scaleX) || isCoarse(z, 1 / scaleZ)) {
            return;
        }
        Tiles parts = new Tiles(x, z, x + 1 / scaleX, z + 1 / scaleZ, length, MOST_INNER, store);
        if (parts.isSingle() || parts.holdsFew(TileLists.first(store.data, tile, length), length, boxes)) {
            return;
        }
        while (store.data[tile] > 0) {
            int id = store.data[TileLists.first(store.data, tile, store.data[tile])];
            store.strike(tile, id);
            parts.addPart(id, boxes, 6 * id);
        }
        if (depth < MOST_DEPTH) {
            parts.divideCrowded(boxes, depth + 1);
        }
        if (innerCount == inner.length) {
            inner = Arrays.copyOf(inner, Math.max(4, 2 * innerCount));
        }
        inner[innerCount] = parts;
        store.data[tile] = NONE - innerCount++;
    }

    /**
     * Whether coordinates are rounded so coarsely there that parts of a tile might miss a strip as wide as their
     * margin.
     */
    private static boolean isCoarse(double place, double side) {
        return side < 0x1p20 * Math.ulp(Math.abs(place) + side);
    }

    /** Whether most objects of a list would be too large for these tiles. */
    private boolean holdsFew(int first, int length, double[] boxes) {
        int small = 0;
        for (int k = first; k < first + length; k++) {
            small += isSmall(boxes, 6 * store.data[k]) ? 1 : 0;
        }
        return 2 * small < length;
    }
}
