package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * A uniform grid that finds the objects near a small box while objects are being added and moved. Each object is listed
 * once, in the cell of its box's centre. A query looks as far around its box as the largest object extends. An object
 * that moves within its cell need not be relisted.
 *
 * <p>Meant for objects of similar size that are not crowded anywhere. The few that are much larger are kept in a list;
 * {@link #isUnfit} reports that there are too many of these, or that queries have to examine too many objects.
 */
public final class NearGrid {
    static final int NONE = -1;

    /** The maximum number of large objects, which every query examines. */
    private static final int MOST_LARGE = 8;

    /** Stands for a cell in the case of an object in the list of large ones. */
    private static final int LARGE = -2;

    /** Number of objects that a query may examine on average. */
    private static final int USUAL = 16;

    /** Cells per object when the grid is built; the number of objects may then grow to three times. */
    private static final double ROOM = 3;

    private static final int MOST_CELLS = 1 << 24;

    private final double originX;
    private final double originZ;

    /** Cells per world unit. */
    private final double scaleX;

    private final double scaleZ;
    private final int countX;
    private final int countZ;

    /** Objects that extend farther are large. */
    private final double mostX;

    private final double mostZ;

    /** By cell, the first object. */
    final int[] heads;

    /** By object, the next one in its cell. */
    int[] next;

    /** By object, its cell. */
    private int[] cells;

    private final int[] large = new int[MOST_LARGE];
    private int largeCount;

    /** No object except the large ones extends farther from its centre, as {@link #reach} defines it. */
    private double reachX;

    private double reachZ;

    /** How many objects there may be before the grid is rebuilt, and how many outside its window. */
    private final int mostObjects;

    private int leftBeside;

    /** How many more objects queries may examine. */
    private long credit;

    private boolean isUnfit;

    /** A grid of all listed objects of an array of boxes. */
    public NearGrid(double[] boxes, boolean[] listed, int size) {
        double minX = Double.POSITIVE_INFINITY;
        double minZ = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxZ = Double.NEGATIVE_INFINITY;
        double wide = 0;
        double deep = 0;
        int end = 0;
        for (int found = 0; found < size; end++) {
            int at = 6 * end;
            if (listed[end]) {
                found++;
                double x = middle(boxes, at);
                double z = middle(boxes, at + 2);
                minX = x < minX ? x : minX;
                minZ = z < minZ ? z : minZ;
                maxX = x > maxX ? x : maxX;
                maxZ = z > maxZ ? z : maxZ;
                wide += boxes[at + 3] - boxes[at];
                deep += boxes[at + 5] - boxes[at + 2];
            }
        }
        double width = 1.25 * (maxX - minX);
        double length = 1.25 * (maxZ - minZ);
        // Cells smaller than the objects would mostly be empty and still be examined.
        double even = Math.max(Math.sqrt(width * length / (ROOM * size)), Math.max(width, length) / (ROOM * size));
        double side = Math.max(even, Math.max(wide, deep) / size);
        originX = minX - width / 10;
        originZ = minZ - length / 10;
        countX = cellsAlong(width, side);
        countZ = cellsAlong(length, side);
        scaleX = width == 0 ? 0 : countX / width;
        scaleZ = length == 0 ? 0 : countZ / length;
        mostX = 2 * side;
        mostZ = 2 * side;
        mostObjects = 3 * size + MOST_LARGE;
        leftBeside = size / 16 + MOST_LARGE;
        credit = (long) USUAL * (size + USUAL);
        boolean isOrdinary = isOrdinary(width, scaleX) && isOrdinary(length, scaleZ);
        isUnfit = !isOrdinary || (long) countX * countZ > MOST_CELLS;
        heads = new int[isUnfit ? 1 : countX * countZ];
        next = new int[isUnfit ? 0 : boxes.length / 6];
        cells = new int[next.length];
        Arrays.fill(heads, NONE);
        for (int id = 0; id < end && !isUnfit; id++) {
            if (listed[id]) {
                add(id, boxes);
            }
        }
    }

    private static int cellsAlong(double length, double side) {
        return Math.max(1, (int) Math.min(MOST_CELLS, length / side));
    }

    private static boolean isOrdinary(double length, double scale) {
        return length >= 0 && length < 0x1p300 && scale < Double.POSITIVE_INFINITY;
    }

    private static double middle(double[] boxes, int at) {
        return 0.5 * boxes[at] + 0.5 * boxes[at + 3];
    }

    /** Whether a grid is unsuitable for the objects. */
    public boolean isUnfit() {
        return isUnfit;
    }

    /** Whether a given number of objects needs a grid with other cells. */
    public boolean isOutgrown(int size) {
        return size > mostObjects || leftBeside < 0;
    }

    int column(double x) {
        return clamp((x - originX) * scaleX, countX);
    }

    int row(double z) {
        return clamp((z - originZ) * scaleZ, countZ);
    }

    private static int clamp(double place, int count) {
        return Math.max(0, Math.min((int) place, count - 1));
    }

    /** How far the first and the last column to examine may be from a box. */
    double reachX() {
        return reachX;
    }

    double reachZ() {
        return reachZ;
    }

    int columns() {
        return countX;
    }

    int largeCount() {
        return largeCount;
    }

    int large(int k) {
        return large[k];
    }

    /** Records how many objects a query has examined. */
    void passed(int objects) {
        credit = Math.min(credit + USUAL - objects, (long) USUAL * mostObjects);
        isUnfit |= credit < 0;
    }

    /** Adds an object of the array. */
    public void add(int id, double[] boxes) {
        if (id >= next.length) {
            next = Arrays.copyOf(next, boxes.length / 6);
            cells = Arrays.copyOf(cells, next.length);
        }
        int cell = cellOf(boxes, 6 * id);
        cells[id] = cell;
        link(id, cell);
    }

    private void link(int id, int cell) {
        if (cell == LARGE) {
            if (largeCount == MOST_LARGE) {
                isUnfit = true;
            } else {
                large[largeCount++] = id;
            }
        } else {
            next[id] = heads[cell];
            heads[cell] = id;
        }
    }

    /** Removes an object. */
    public void remove(int id) {
        unlink(id, cells[id]);
    }

    private void unlink(int id, int cell) {
        if (cell == LARGE) {
            for (int k = 0; k < largeCount; k++) {
                if (large[k] == id) {
                    large[k] = large[--largeCount];
                }
            }
        } else if (heads[cell] == id) {
            heads[cell] = next[id];
        } else {
            int before = heads[cell];
            while (next[before] != id) {
                before = next[before];
            }
            next[before] = next[id];
        }
    }

    /** Updates an object to the present position of its box. */
    public void move(int id, double[] boxes) {
        int cell = cellOf(boxes, 6 * id);
        int old = cells[id];
        if (cell != old) {
            unlink(id, old);
            cells[id] = cell;
            link(id, cell);
        }
    }

    /** The cell of a box; also extends the reach of queries so that they find it. */
    private int cellOf(double[] boxes, int at) {
        double x = middle(boxes, at);
        double z = middle(boxes, at + 2);
        double lowX = boxes[at];
        double lowZ = boxes[at + 2];
        double highX = boxes[at + 3];
        double highZ = boxes[at + 5];
        if (!(lowX + reachX >= x && highX - reachX <= x && lowZ + reachZ >= z && highZ - reachZ <= z)) {
            if (highX - lowX > 2 * mostX || highZ - lowZ > 2 * mostZ) {
                return LARGE;
            }
            reachX = reach(reachX, lowX, x, highX);
            reachZ = reach(reachZ, lowZ, z, highZ);
        }
        double placeX = (x - originX) * scaleX;
        double placeZ = (z - originZ) * scaleZ;
        if (!(placeX >= 0 && placeX < countX && placeZ >= 0 && placeZ < countZ)) {
            leftBeside--;
        }
        return clamp(placeZ, countZ) * countX + clamp(placeX, countX);
    }

    /**
     * A reach, at least the given one, such that the middle is not above the rounded sum of the low end and the reach,
     * nor below the rounded difference of the high end and the reach. Rounding is monotonic, so a box that begins at or
     * before the end of a query has its middle at most at the rounded sum of that end and the reach.
     */
    private static double reach(double before, double low, double middle, double high) {
        double reach = Math.max(before, Math.max(middle - low, high - middle));
        while (low + reach < middle || high - reach > middle) {
            reach = 2 * reach + Double.MIN_VALUE;
        }
        return reach;
    }
}
