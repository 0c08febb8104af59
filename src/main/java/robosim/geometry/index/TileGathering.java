package robosim.geometry.index;

import java.util.Arrays;

/**
 * Objects of {@link Tiles} or of a {@link NearGrid} that are near a box, all at once: each as often as tiles of the box list
 * it. A small box lies on one tile, two or four, each with one object or two or none: loops over them would be guessed wrong
 * most of the time, so the usual case has one loop, and what does not count is written down and written over.
 */
final class TileGathering {
    private static final int SIGN = Integer.SIZE - 1;

    private int[] ids = new int[16];
    private int count;

    /** The heads of the lists to read, and one place more. */
    private int[] heads = new int[5];

    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private int but;

    /** Starts with nothing, for a closed box and all objects but one. */
    void start(double x0, double z0, double x1, double z1, int without) {
        minX = x0;
        minZ = z0;
        maxX = x1;
        maxZ = z1;
        but = without;
        count = 0;
    }

    int count() {
        return count;
    }

    int id(int k) {
        return ids[k];
    }

    /** Adds the objects whose listed bounds meet the box. */
    void gather(Tiles over) {
        if (over.rest != Tiles.NONE) {
            readOne(over.store, over.rest);
        }
        int column0 = over.column(minX, 0);
        int column1 = over.column(maxX, 0);
        int row0 = over.row(minZ, 0);
        int row1 = over.row(maxZ, 0);
        int x0 = over.spreadX(column0);
        int z0 = over.spreadZ(row0);
        int more = column1 - column0;
        int deeper = row1 - row0;
        if ((more | deeper) > 1 || !gatherFour(over, x0, z0, more, deeper)) {
            gatherAll(over, x0, z0, more, deeper);
        }
    }

    /** From a tile, the next one if there is one more column, and the same of one more row; false where any is divided. */
    private boolean gatherFour(Tiles over, int x, int z, int more, int deeper) {
        int nextX = Tiles.up(x, over.maskX);
        int nextZ = Tiles.up(z, over.maskZ);
        int a = over.heads[x | z];
        int b = over.heads[nextX | z] | -(1 - more);
        int c = over.heads[x | nextZ] | -(1 - deeper);
        int d = over.heads[nextX | nextZ] | -(1 - (more & deeper));
        if (Math.min(Math.min(a, b), Math.min(c, d)) < Tiles.NONE) {
            return false;
        }
        read(over.store, list(a, b, c, d));
        return true;
    }

    private void gatherAll(Tiles over, int startX, int startZ, int more, int deeper) {
        int z = startZ;
        for (int row = 0; row <= deeper; row++) {
            int x = startX;
            for (int column = 0; column <= more; column++) {
                int head = over.heads[x | z];
                if (head < Tiles.NONE) {
                    gather(over.within(head));
                } else if (head > Tiles.NONE) {
                    readOne(over.store, head);
                }
                x = Tiles.up(x, over.maskX);
            }
            z = Tiles.up(z, over.maskZ);
        }
    }

    private void readOne(TileEntries store, int head) {
        heads[0] = head;
        read(store, 1);
    }

    /** Adds what counts of so many lists that are not empty. */
    private void read(TileEntries store, int lists) {
        float[] entries = store.data;
        double lowX = minX;
        double lowZ = minZ;
        double highX = maxX;
        double highZ = maxZ;
        int to = count;
        int list = 0;
        int listed = heads[0];
        while (list < lists) {
            if (to == ids.length) {
                grow();
            }
            int at = listed;
            int id = Float.floatToRawIntBits(entries[at + TileEntries.ID]);
            float x0 = entries[at];
            float z0 = entries[at + 1];
            float x1 = entries[at + 2];
            float z1 = entries[at + 3];
            ids[to] = id;
            // A difference has the sign of an order, and +0 where the two are equal.
            long apart = Double.doubleToRawLongBits(highX - x0)
                    | Double.doubleToRawLongBits(x1 - lowX)
                    | Double.doubleToRawLongBits(highZ - z0)
                    | Double.doubleToRawLongBits(z1 - lowZ);
            int isOther = (id - but | but - id) >>> SIGN;
            to += isOther & (int) (~apart >>> (Long.SIZE - 1));
            // The next of this list, or the first of the next one.
            int next = Float.floatToRawIntBits(entries[at + TileEntries.NEXT]);
            int isLast = next >> SIGN;
            list -= isLast;
            listed = (next & ~isLast) | (heads[list] & isLast);
        }
        count = to;
    }

    private void grow() {
        ids = Arrays.copyOf(ids, 2 * ids.length);
    }

    /** Adds the objects of a grid whose boxes meet the box. */
    void gather(NearGrid grid, double[] boxes) {
        for (int k = 0; k < grid.largeCount(); k++) {
            int id = grid.large(k);
            if (id != but && meets(boxes, 6 * id)) {
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

    private boolean meets(double[] boxes, int at) {
        return boxes[at] <= maxX && minX <= boxes[at + 3] && boxes[at + 2] <= maxZ && minZ <= boxes[at + 5];
    }

    /** Writes down the first objects of a cell, the next one if there is one more column, and the same of one more row. */
    private int listFour(NearGrid grid, int cell, int more, int deeper) {
        int below = cell + (grid.columns() & -deeper);
        int a = grid.heads[cell];
        int b = grid.heads[cell + more] | -(1 - more);
        int c = grid.heads[below] | -(1 - deeper);
        int d = grid.heads[below + more] | -(1 - (more & deeper));
        return list(a, b, c, d);
    }

    /** Writes down those of four heads that are not NONE, and answers how many: one that is is written over by the next. */
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

    /** Adds what counts of so many lists that are not empty, and answers how many objects these hold. */
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
                int isOther = (id - but | but - id) >>> SIGN;
                to += isOther & (int) (~apart >>> (Long.SIZE - 1));
                passed++;
                id = next[id];
            } while (id >= 0);
        }
        count = to;
        return passed;
    }
}
