package robosim.geometry.index.hierarchy;

import robosim.geometry.index.quadtree.LongHeap;

/** Visits the objects of two hierarchies around a point in the order of the distances of their bounds. */
public final class NearestCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    /** Rounds up the square of a limit by more than the squares of distances are off. */
    private static final double UP = 1 + 0x1p-48;

    /** The upper half of an entry. */
    private static final long KEY = -1L << Integer.SIZE;

    /** The bit that is set in the links of the second hierarchy. */
    private static final int SECOND = 1 << 29;

    private Hierarchy first = Hierarchy.EMPTY;
    private Hierarchy second = first;
    private double x;
    private double y;
    private double z;

    /** The last object, by the square of the distance of its bounds. */
    private long last;

    /** Links, by the upper halves of the bits of the squares of the distances of their bounds. */
    private final LongHeap queue = new LongHeap();

    /** Asks for what is around a point. */
    public void around(double px, double py, double pz) {
        x = px;
        y = py;
        z = pz;
    }

    /** Starts to search two hierarchies, which share no object. */
    public void start(Hierarchy one, Hierarchy another) {
        if (first != one || second != another) { // writing a reference is slow
            first = one;
            second = another;
        }
        queue.clear();
        push(one, 0);
        push(another, SECOND);
    }

    private void push(Hierarchy tree, int mark) {
        tree.settle();
        if (tree.size() > 0) {
            queue.push(mark);
        }
    }

    /** The next object whose bounds are within a limit; -1 after the last. The limit may shrink from call to call. */
    public int next(double limit) {
        double most = limit * limit * UP + Double.MIN_NORMAL;
        long within = Double.doubleToRawLongBits(most) | ~KEY;
        while (!queue.isEmpty() && queue.least() <= within) {
            long nearest = queue.pop();
            int link = (int) nearest;
            if (link < 0) {
                last = nearest;
                return link & ~(Integer.MIN_VALUE | SECOND);
            }
            open((link & SECOND) == 0 ? first : second, link & ~SECOND, link & SECOND, most);
        }
        return -1;
    }

    /** A lower bound, to some 2^-20 of it, of how far the last object is, and all that follow. */
    public double entry() {
        double square = Double.longBitsToDouble(last & KEY);
        return square < Double.MIN_NORMAL ? 0 : Math.sqrt(square) / UP;
    }

    private void open(Hierarchy tree, int node, int mark, double most) {
        float[] n = tree.nodes;
        int at = node * Hierarchy.STRIDE;
        int link = at + Hierarchy.LINKS;
        for (int k = at; k < at + WIDTH * PART; k += PART, link++) {
            double dx = Math.max(0, Math.max(n[k] - x, x - n[k + 3]));
            double dy = Math.max(0, Math.max(n[k + 1] - y, y - n[k + 4]));
            double dz = Math.max(0, Math.max(n[k + 2] - z, z - n[k + 5]));
            double far = dx * dx + dy * dy + dz * dz;
            // A child that is missing is infinitely far.
            if (far <= most && far < Double.POSITIVE_INFINITY) {
                int child = Float.floatToRawIntBits(n[link]) | mark;
                queue.push((Double.doubleToRawLongBits(far) & KEY) | (child & ~KEY));
            }
        }
    }
}
