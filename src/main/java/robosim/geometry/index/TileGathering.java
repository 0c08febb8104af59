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

    /** Adds the objects whose outlines the box, wider by some slack on all sides, may meet. */
    void gather(Tiles over, double slack, double[] outlines) {
        if (over.hasRest()) {
            read(over, over.rest(), over.rest(), slack, outlines);
        }
        int column0 = over.column(minX, 0);
        int column1 = over.column(maxX, 0);
        int last = over.row(maxZ, 0);
        for (int row = over.row(minZ, 0); row <= last; row++) {
            read(over, over.at(column0, row), over.at(column1, row), slack, outlines);
        }
    }

    /** Adds what counts of the lists of some tiles beside each other. */
    private void read(Tiles over, int first, int last, double slack, double[] outlines) {
        int[] data = over.store.data;
        double x = minX / 2 + maxX / 2;
        double z = minZ / 2 + maxZ / 2;
        double wide = maxX / 2 - minX / 2 + slack;
        double deep = maxZ / 2 - minZ / 2 + slack;
        int to = count;
        for (int tile = first; tile <= last; tile += TileLists.STRIDE) {
            int length = data[tile];
            int begin = TileLists.first(data, tile, length);
            while (to + length > ids.length) {
                grow();
            }
            for (int k = begin; k < begin + length; k++) {
                int id = data[k];
                int at = Outline.at(id);
                ids[to] = id;
                double halfX = outlines[at + Outline.HALF_X];
                double halfZ = outlines[at + Outline.HALF_Z];
                double cos = Math.abs(outlines[at + Outline.COS]);
                double sin = Math.abs(outlines[at + Outline.SIN]);
                double gapX = halfX * cos + halfZ * sin + wide - Math.abs(outlines[at + Outline.X] - x);
                double gapZ = halfX * sin + halfZ * cos + deep - Math.abs(outlines[at + Outline.Z] - z);
                // A negative difference is a gap.
                long apart = Double.doubleToRawLongBits(gapX) | Double.doubleToRawLongBits(gapZ);
                int isOther = (id - but | but - id) >>> SIGN;
                to += isOther & (int) (~apart >>> (Long.SIZE - 1));
            }
            if (length < 0) {
                count = to;
                gather(over.within(length), slack, outlines);
                to = count;
            }
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
