package robosim.geometry.narrow.sat;

import robosim.geometry.exact.DoubleDouble;
import robosim.geometry.exact.DoubleDoubleSum;
import robosim.geometry.narrow.leaf.Leaf;

/** The counterpart of {@link AxisBody} in pairs of doubles: a polytope's extent along an axis. */
final class DoubleDoubleBody {
    private static final int MOST_POINTS = 3;
    private static final int MOST_EDGES = 8;

    /** The extent along the axis of the last {@link #project}. */
    final DoubleDoubleSum lo = new DoubleDoubleSum();

    final DoubleDoubleSum hi = new DoubleDoubleSum();

    private final double[] edge = new double[3 * MOST_EDGES];
    private final double[] edgeTail = new double[3 * MOST_EDGES];
    private int edges;

    /** Corners, or only a centre, with half vectors. */
    private final double[] point = new double[3 * MOST_POINTS];

    private final double[] pointTail = new double[3 * MOST_POINTS];
    private int points;
    private final double[] half = new double[12];
    private final double[] halfTail = new double[12];
    private int halves;

    private final DoubleDoubleSum reach = new DoubleDoubleSum();

    /** Loads a leaf as {@link AxisBody} does for a mode of {@link MovingAxes}. */
    void load(AxisBody.Mode mode, Leaf leaf, double ox, double oy, double oz) {
        points = 0;
        halves = 0;
        edges = 0;
        boolean flat = mode == AxisBody.Mode.PLANAR;
        switch (leaf.kind.polytope()) {
            case TRIANGLE -> triangle(leaf.row, leaf.at, flat, ox, oy, oz);
            case BOX -> box(leaf.row, leaf.at, mode, ox, oy, oz);
        }
    }

    private void triangle(double[] row, int at, boolean flat, double ox, double oy, double oz) {
        for (int k = at; k < at + 9; k += 3) {
            addPoint(row[k], ox, flat ? 0 : row[k + 1], flat ? 0 : oy, row[k + 2], oz);
        }
        for (int k = 0; k < 9; k += 3) {
            int next = at + (k + 3) % 9;
            int from = at + k;
            edges = k / 3 + 1;
            difference(row[next], row[from], edge, edgeTail, k);
            difference(flat ? 0 : row[next + 1], flat ? 0 : row[from + 1], edge, edgeTail, k + 1);
            difference(row[next + 2], row[from + 2], edge, edgeTail, k + 2);
        }
    }

    private void box(double[] row, int at, AxisBody.Mode mode, double ox, double oy, double oz) {
        boolean spatial = mode == AxisBody.Mode.SPATIAL;
        boolean flat = mode == AxisBody.Mode.PLANAR;
        addPoint(row[at], ox, flat ? 0 : row[at + 1], flat ? 0 : oy, row[at + 2], oz);
        for (int k = 0; k < 3; k++) {
            double y = spatial ? row[at + 9 + k] : 0;
            addHalf(row[at + 3 + k], row[at + 6 + k], y, row[at + 12 + k]);
            addEdge(row[at + 6 + k], y, row[at + 12 + k]);
        }
        if (mode == AxisBody.Mode.UPRIGHT) {
            addHalf(row[at + 4], 0, 1, 0);
        }
    }

    /** Sets {@link #lo} and {@link #hi}. */
    void project(DoubleDoubleSum[] axis) {
        dot(axis, point, pointTail, 0, lo);
        hi.set(lo);
        for (int k = 3; k < 3 * points; k += 3) {
            dot(axis, point, pointTail, k, reach);
            if (reach.isBelow(lo)) {
                lo.set(reach);
            }
            if (hi.isBelow(reach)) {
                hi.set(reach);
            }
        }
        for (int k = 0; k < halves; k += 3) {
            dot(axis, half, halfTail, k, reach);
            if (reach.hi < 0) {
                reach.negate();
            }
            lo.subtract(reach);
            hi.add(reach);
        }
    }

    private static void dot(DoubleDoubleSum[] axis, double[] v, double[] tail, int k, DoubleDoubleSum out) {
        out.clear();
        for (int m = 0; m < 3; m++) {
            if (axis[m].hi != 0 && v[k + m] != 0) {
                out.addProduct(axis[m].hi, axis[m].lo, v[k + m], tail[k + m]);
            }
            out.plain &= axis[m].plain;
        }
    }

    /** Writes the direction of an edge. */
    void edge(int index, DoubleDoubleSum[] out) {
        for (int m = 0; m < 3; m++) {
            out[m].clear();
            out[m].add(edge[3 * index + m], edgeTail[3 * index + m]);
        }
    }

    private void addPoint(double x, double ox, double y, double oy, double z, double oz) {
        int k = 3 * points++;
        difference(x, ox, point, pointTail, k);
        difference(y, oy, point, pointTail, k + 1);
        difference(z, oz, point, pointTail, k + 2);
    }

    private void addHalf(double h, double x, double y, double z) {
        product(h, x, halves);
        product(h, y, halves + 1);
        product(h, z, halves + 2);
        halves += 3;
    }

    private void product(double p, double q, int k) {
        half[k] = p * q;
        halfTail[k] = DoubleDouble.productTail(p, q, half[k]);
    }

    private void addEdge(double x, double y, double z) {
        int k = 3 * edges++;
        edge[k] = x;
        edge[k + 1] = y;
        edge[k + 2] = z;
        edgeTail[k] = 0;
        edgeTail[k + 1] = 0;
        edgeTail[k + 2] = 0;
    }

    private static void difference(double p, double q, double[] out, double[] tail, int k) {
        out[k] = p - q;
        tail[k] = DoubleDouble.differenceTail(p, q, out[k]);
    }
}
