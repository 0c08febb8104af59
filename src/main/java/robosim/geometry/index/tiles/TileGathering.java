package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * Collects the objects of {@link Tiles} or of a {@link NearGrid} that are near a box, all at once, each as often as
 * tiles of the box list it. A small box lies on one, two or four tiles, each with zero to two objects. Branches in
 * nested loops over them would mostly be mispredicted, so the usual case has a single loop, in which objects that do
 * not count are written too and then overwritten.
 */
public final class TileGathering {
    private static final int SIGN = Integer.SIZE - 1;

    private int[] ids = new int[16];
    private int count;

    /** The heads of the lists to read, and one spare element. */
    private int[] heads = new int[5];

    // The closed query box, for a grid.
    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private int ignored;

    // The query rectangle, for tiles: its centre, and half its size plus the rounding error of the gap to an outline.
    private double x;
    private double z;
    private double wide;
    private double deep;

    /** Starts a collection for a closed box, ignoring one object. */
    public void start(double x0, double z0, double x1, double z1, int ignored) {
        minX = x0;
        minZ = z0;
        maxX = x1;
        maxZ = z1;
        this.ignored = ignored;
        count = 0;
    }

    /**
     * The largest rounding error of the gap between a rectangle and outlines whose coordinates are at most {@code most}
     * in magnitude.
     */
    static double slack(double x, double z, double halfX, double halfZ, double most) {
        // Twenty roundings of 2^-53 in sums of numbers no greater than these, and underflow.
        return 0x1p-47 * (most + Math.abs(x) + Math.abs(z) + halfX + halfZ) + 0x1p-1000;
    }

    /**
     * Starts a collection for all objects near a point, ignoring one, where no coordinate exceeds {@code most} in
     * magnitude.
     */
    public void startAbout(double placeX, double placeZ, double halfX, double halfZ, double most, int ignored) {
        double slack = slack(placeX, placeZ, halfX, halfZ, most);
        x = placeX;
        z = placeZ;
        wide = halfX + slack;
        deep = halfZ + slack;
        this.ignored = ignored;
        count = 0;
    }

    public int count() {
        return count;
    }

    public int id(int k) {
        return ids[k];
    }

    /** Adds the objects whose outlines may meet. */
    public void gather(Tiles over, double[] outlines) {
        int column = over.column(x - wide, 0);
        int row = over.row(z - deep, 0);
        int more = over.column(x + wide, 0) - column;
        int deeper = over.row(z + deep, 0) - row;
        if (over.hasRest()) {
            read(over, over.rest(), outlines);
        }
        int first = over.at(column, row);
        int last = first + TileLists.STRIDE * more;
        for (int left = deeper; left >= 0; left--) {
            for (int tile = first; tile <= last; tile += TileLists.STRIDE) {
                read(over, tile, outlines);
            }
            first += over.rowStep();
            last += over.rowStep();
        }
    }

    /** Adds the objects of a list that count. */
    private void read(Tiles over, int tile, double[] outlines) {
        int[] data = over.store.data;
        int length = data[tile];
        if ((length & ~TileLists.SHORT) != 0) {
            readLong(over, tile, outlines);
            return;
        }
        if (count + TileLists.SHORT > ids.length) {
            grow();
        }
        int to = count;
        ids[to] = data[tile + 1];
        to += mayTouch(outlines, data[tile + 1]);
        ids[to] = data[tile + 2];
        to += mayTouch(outlines, data[tile + 2]);
        ids[to] = data[tile + 3];
        to += mayTouch(outlines, data[tile + 3]);
        count = to;
    }

    private void readLong(Tiles over, int tile, double[] outlines) {
        int[] data = over.store.data;
        int length = data[tile];
        if (length < 0) {
            gather(over.within(length), outlines);
            return;
        }
        while (count + length > ids.length) {
            grow();
        }
        int first = TileLists.first(data, tile, length);
        int to = count;
        for (int k = first; k < first + length; k++) {
            ids[to] = data[k];
            to += mayTouch(outlines, data[k]);
        }
        count = to;
    }

    /** 1 for an object that counts, else 0. */
    private int mayTouch(double[] outlines, int id) {
        int isOther = (id - ignored | ignored - id) >>> SIGN;
        return isOther & (OrientedRectangle.mayTouch(outlines, id, x, z, wide, deep) ? 1 : 0);
    }

    private void grow() {
        ids = Arrays.copyOf(ids, 2 * ids.length);
    }

    /** Adds the objects of a grid whose boxes meet the query box. */
    public void gather(NearGrid grid, double[] boxes) {
        for (int k = 0; k < grid.largeCount(); k++) {
            int id = grid.large(k);
            if (id != ignored && overlaps(boxes, 6 * id)) {
                if (count == ids.length) {
                    grow();
                }
                ids[count++] = id;
            }
        }
        int column = grid.column(minX - grid.reachX());
        int row = grid.row(minZ - grid.reachZ());
        int more = grid.column(maxX + grid.reachX()) - column;
        int deeper = grid.row(maxZ + grid.reachZ()) - row;
        int lists = (more | deeper) <= 1
                ? listFour(grid, row * grid.columns() + column, more, deeper)
                : listAll(grid, row * grid.columns() + column, more, deeper);
        grid.passed((((more + 1) * (deeper + 1)) >> 2) + read(grid.next, boxes, lists));
    }

    private boolean overlaps(double[] boxes, int at) {
        return boxes[at] <= maxX && minX <= boxes[at + 3] && boxes[at + 2] <= maxZ && minZ <= boxes[at + 5];
    }

    /**
     * Writes the list heads of a cell, of the next cell if there is one more column, and of the same in the next row if
     * there is one more.
     */
    private int listFour(NearGrid grid, int cell, int more, int deeper) {
        int below = cell + (grid.columns() & -deeper);
        int a = grid.heads[cell];
        int b = grid.heads[cell + more] | -(1 - more);
        int c = grid.heads[below] | -(1 - deeper);
        int d = grid.heads[below + more] | -(1 - (more & deeper));
        return list(a, b, c, d);
    }

    /**
     * Writes those of four heads that are not NONE, and returns how many; one that is NONE is overwritten by the next.
     */
    private int list(int a, int b, int c, int d) {
        heads[0] = a;
        int lists = 1 + (a >> SIGN);
        heads[lists] = b;
        lists += 1 + (b >> SIGN);
        heads[lists] = c;
        lists += 1 + (c >> SIGN);
        heads[lists] = d;
        lists += 1 + (d >> SIGN);
        return lists;
    }

    private int listAll(NearGrid grid, int cell, int more, int deeper) {
        int most = (more + 1) * (deeper + 1);
        if (most >= heads.length) {
            heads = new int[2 * most];
        }
        int lists = 0;
        int at = cell;
        for (int row = 0; row <= deeper; row++) {
            for (int column = 0; column <= more; column++) {
                int head = grid.heads[at + column];
                heads[lists] = head;
                lists += 1 + (head >> SIGN);
            }
            at += grid.columns();
        }
        return lists;
    }

    /** Adds the objects that count of a number of non-empty lists, and returns how many objects these lists hold. */
    private int read(int[] next, double[] boxes, int lists) {
        double lowX = minX;
        double lowZ = minZ;
        double highX = maxX;
        double highZ = maxZ;
        int to = count;
        int passed = 0;
        for (int list = 0; list < lists; list++) {
            int id = heads[list];
            do {
                if (to == ids.length) {
                    grow();
                }
                int at = 6 * id;
                ids[to] = id;
                long apart = Double.doubleToRawLongBits(highX - boxes[at])
                        | Double.doubleToRawLongBits(highZ - boxes[at + 2])
                        | Double.doubleToRawLongBits(boxes[at + 3] - lowX)
                        | Double.doubleToRawLongBits(boxes[at + 5] - lowZ);
                int isOther = (id - ignored | ignored - id) >>> SIGN;
                to += isOther & (int) (~apart >>> (Long.SIZE - 1));
                passed++;
                id = next[id];
            } while (id >= 0);
        }
        count = to;
        return passed;
    }
}
