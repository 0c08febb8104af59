package robosim.geometry.index.hierarchy;

import robosim.geometry.index.regions.EntryQueue;

/**
 * Visits the objects of two hierarchies around a point, or of those only the ones that a cone from there may meet, in the order
 * of the distances of their bounds.
 */
public final class NearestCursor {
    private static final int WIDTH = Hierarchy.WIDTH;
    private static final int PART = Hierarchy.PART;

    /** Rounds up the square of a limit by more than the squares of distances are off. */
    private static final double UP = 1 + 0x1p-48;

    /** The bit that is set in the links of the second hierarchy. */
    private static final int SECOND = 1 << 29;

    private Hierarchy first = new Hierarchy(() -> {});
    private Hierarchy second = first;
    private double x;
    private double y;
    private double z;

    // The cone about a unit vector, by half its opening angle.
    private boolean isCone;
    private double ux;
    private double uy;
    private double uz;
    private double cos;
    private double sin;

    /** Links by the squares of the distances of their bounds. */
    private final EntryQueue queue = new EntryQueue();

    /** Asks for what is around a point. */
    public void around(double px, double py, double pz) {
        x = px;
        y = py;
        z = pz;
        isCone = false;
    }

    /** Asks for what a cone from a point may meet, about a unit vector; half its opening angle is below 90 degrees. */
    public void cone(double px, double py, double pz, double ax, double ay, double az, double halfCos, double halfSin) {
        around(px, py, pz);
        isCone = true;
        ux = ax;
        uy = ay;
        uz = az;
        cos = halfCos;
        sin = halfSin;
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
            queue.push(0, mark);
        }
    }

    /** The next object whose bounds are within a limit; -1 after the last. The limit may shrink from call to call. */
    public int next(double limit) {
        double most = limit * limit * UP + Double.MIN_NORMAL;
        while (!queue.isEmpty() && queue.leastKey() <= most) {
            int link = queue.pop();
            if (link < 0) {
                return link & ~(Integer.MIN_VALUE | SECOND);
            }
            open((link & SECOND) == 0 ? first : second, link & ~SECOND, link & SECOND, most);
        }
        return -1;
    }

    private void open(Hierarchy tree, int node, int mark, double most) {
        float[] n = tree.nodes;
        int at = node * Hierarchy.STRIDE;
        int link = at + Hierarchy.LINKS;
        for (int k = at; k < at + WIDTH * PART; k += PART, link++) {
            double dx = Math.max(0, Math.max(n[k] - x, x - n[k + 3]));
            double dy = Math.max(0, Math.max(n[k + 1] - y, y - n[k + 4]));
            double dz = Math.max(0, Math.max(n[k + 2] - z, z - n[k + 5]));
            double square = dx * dx + dy * dy + dz * dz;
            // A child that is missing is infinitely far.
            if (square <= most && square < Double.POSITIVE_INFINITY && !(isCone && isBeyondCone(n, k))) {
                queue.push(square, Float.floatToRawIntBits(n[link]) | mark);
            }
        }
    }

    /**
     * Whether a box lies beyond the plane that touches the cone along the line nearest to the box's centre. With e the
     * unit vector from the axis to the centre, the plane's normal is {@code e cos - u sin}; no point of the cone is in
     * front of it, as its distance from the axis is at most {@code sin / cos} times its position along the axis.
     */
    private boolean isBeyondCone(float[] of, int at) {
        double hx = 0.5 * ((double) of[at + 3] - of[at]);
        double hy = 0.5 * ((double) of[at + 4] - of[at + 1]);
        double hz = 0.5 * ((double) of[at + 5] - of[at + 2]);
        double mx = of[at] + hx - x;
        double my = of[at + 1] + hy - y;
        double mz = of[at + 2] + hz - z;
        double ahead = mx * ux + my * uy + mz * uz;
        double ex = mx - ahead * ux;
        double ey = my - ahead * uy;
        double ez = mz - ahead * uz;
        double aside = Math.sqrt(ex * ex + ey * ey + ez * ez);
        double size = Math.abs(mx) + Math.abs(my) + Math.abs(mz) + hx + hy + hz;
        if (!(aside > 0x1p-20 * size)) {
            return false;
        }
        double nx = ex / aside * cos - ux * sin;
        double ny = ey / aside * cos - uy * sin;
        double nz = ez / aside * cos - uz * sin;
        double gap = nx * mx + ny * my + nz * mz - (Math.abs(nx) * hx + Math.abs(ny) * hy + Math.abs(nz) * hz);
        // e is off by at most 2^-30 of its length along the axis, and otherwise by roundings of 2^-53.
        return gap > 0x1p-28 * size + 0x1p-40 * (Math.abs(x) + Math.abs(y) + Math.abs(z));
    }
}
