package robosim.geometry.index.tiles;

import java.util.Arrays;

/**
 * Who is near a small box, in the midst of additions and moves: a flat grid of equal cells in which each object stands once,
 * where its box has its centre. Whoever asks looks as far around as the largest of them reaches. An object that moves
 * within its cell has nothing to be listed anew.
 *
 * <p>Made for objects of about one size, nowhere crowded: a few that are much larger stand on a list, and {@link #isUnfit}
 * tells where there are many of these, or where questions have to pass by too many objects.
 */
public final class NearGrid {
    static final int NONE = -1;

    /** Largest objects, which everybody is shown. */
    private static final int MOST_LARGE = 8;

    /** In place of a cell, for an object on the list of large ones. */
    private static final int LARGE = -2;

    /** So many objects a question may pass by, on average of many. */
    private static final int USUAL = 16;

    /** Cells an object when the grid is made; there may come to be three times as many objects. */
    private static final double ROOM = 3;

    private static final int MOST_CELLS = 1 << 24;

    private final double originX;
    private final double originZ;

    /** Cells a unit. */
    private final double scaleX;

    private final double scaleZ;
    private final int countX;
    private final int countZ;

    /** Objects that reach farther are large. */
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

    /** No object that is not large reaches farther from its centre, as {@link #reach} understands it. */
    private double reachX;

    private double reachZ;

    /** How many objects there may be before the grid is made anew, and how many beside its window. */
    private final int mostObjects;

    private int leftBeside;

    /** How many more objects questions may pass by. */
    private long credit;

    private boolean isUnfit;

    /** A grid of all objects of an array of boxes that are listed, so many. */
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
        // Smaller cells than objects are mostly empty ones to look into.
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

    /** Whether the objects are none for a grid. */
    public boolean isUnfit() {
        return isUnfit;
    }

    /** Whether so many objects need a grid of other cells. */
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

    /** How far the first column to look into may be from a box, and the last. */
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

    /** Takes note of how many objects a question has passed by. */
    void passed(int objects) {
        credit = Math.min(credit + USUAL - objects, (long) USUAL * mostObjects);
        isUnfit |= credit < 0;
    }

    /** Lists an object of the array. */
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

    /** Strikes an object that is listed. */
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

    /** Lists an object where its box now is. */
    public void move(int id, double[] boxes) {
        int cell = cellOf(boxes, 6 * id);
        int old = cells[id];
        if (cell != old) {
            unlink(id, old);
            cells[id] = cell;
            link(id, cell);
        }
    }

    /** The cell of a box; makes sure that whoever looks for it looks far enough. */
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
     * A reach, at least the given one, such that the middle is not above the rounded sum of it and the low end, nor below
     * the rounded difference of the high end and it. Rounding keeps order: so a box that begins where a question ends, or
     * before, has its middle at most at the rounded sum of that end and the reach.
     */
    private static double reach(double before, double low, double middle, double high) {
        double reach = Math.max(before, Math.max(middle - low, high - middle));
        while (low + reach < middle || high - reach > middle) {
            reach = 2 * reach + Double.MIN_VALUE;
        }
        return reach;
    }
}
