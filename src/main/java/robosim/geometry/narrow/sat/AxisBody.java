package robosim.geometry.narrow.sat;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.narrow.leaf.Leaf;

/**
 * A box or a triangle for the method of separating axes: its extent along an axis, and the axes that it contributes.
 *
 * <p>Loaded relative to an origin, in space or as its projection on XZ (all y are 0). Every coordinate is off by at
 * most 8 units of roundoff (2^-53) of {@link #mx}, {@link #my}, {@link #mz}, the sums of the magnitudes that enter it.
 */
public final class AxisBody {
    /** As what two bodies are compared. */
    public enum Mode {
        /** As projections on XZ. */
        PLANAR,
        /** As upright boxes in space. */
        UPRIGHT,
        /** As they are, in space. */
        SPATIAL
    }

    public static final double ROUNDOFF = FilterBound.bound(32 * 0x1p-53);

    /** More than any product of doubles here loses to underflow. */
    public static final double TINY = 0x1p-1040;

    private static final int MOST_POINTS = 3;
    private static final int MOST_AXES = 8;

    /** The extent along the axis of the last {@link #project}. */
    double lo;

    double hi;

    /** Upper bounds of the magnitudes that each coordinate is summed from. */
    double mx;

    double my;
    double mz;

    /** Face normals; exact, except a triangle's, which are off by 4 units of roundoff of {@link #normalSize}. */
    int normals;

    final double[] normal = new double[3 * MOST_AXES];
    final double[] normalSize = new double[3 * MOST_AXES];

    /**
     * How each normal is computed: {@link #GIVEN}, or another of these constants plus the numbers of the edges used.
     */
    final int[] recipe = new int[MOST_AXES];

    static final int GIVEN = 0;

    /** In the plane: across an edge, and along it. */
    static final int ACROSS = 16;

    static final int ALONG = 32;

    /** The cross product of edges p and q: {@code CROSS + 8 p + q}. */
    static final int CROSS = 64;

    /** Edge directions, off by at most one unit of roundoff in each coordinate. */
    int edges;

    final double[] edge = new double[3 * MOST_AXES];

    /** Whether the body is a triangle in space that may have no area. */
    boolean doubtful;

    private int points;
    private final double[] px = new double[MOST_POINTS];
    private final double[] py = new double[MOST_POINTS];
    private final double[] pz = new double[MOST_POINTS];

    // Used where there are no points: a centre and half vectors.
    private double cx;
    private double cy;
    private double cz;
    private final double[] half = new double[9];
    private int halves;

    void spatial(Leaf leaf, double ox, double oy, double oz) {
        clear();
        switch (leaf.kind.polytope()) {
            case TRIANGLE -> {
                corners(leaf.row, leaf.at, ox, oy, oz, 1);
                spatialTriangle();
            }
            case BOX -> {
                centre(leaf.row, leaf.at, ox, oy, oz);
                for (int k = 0; k < 3; k++) {
                    halfVector(leaf.get(3 + k), leaf.get(6 + k), leaf.get(9 + k), leaf.get(12 + k));
                    addEdge(leaf.get(6 + k), leaf.get(9 + k), leaf.get(12 + k));
                }
                addCross(3, 6);
                addCross(6, 0);
                addCross(0, 3);
            }
        }
    }

    /** The projection on XZ, with all heights 0. */
    void planar(Leaf leaf, double ox, double oz) {
        clear();
        switch (leaf.kind.polytope()) {
            case TRIANGLE -> {
                corners(leaf.row, leaf.at, ox, 0, oz, 0);
                planarTriangle();
            }
            case BOX -> {
                centre(leaf.row, leaf.at, ox, leaf.get(1), oz);
                for (int k = 0; k < 3; k++) {
                    double ux = leaf.get(6 + k);
                    double uz = leaf.get(12 + k);
                    if (ux != 0 || uz != 0) {
                        halfVector(leaf.get(3 + k), ux, 0, uz);
                        addNormal(-uz, 0, ux);
                    }
                }
            }
        }
    }

    /** An upright box: the normals of its base and the vertical. */
    void upright(Leaf leaf, double ox, double oy, double oz) {
        planar(leaf, ox, oz);
        cy = leaf.get(1) - oy;
        my = Math.abs(cy);
        halfVector(leaf.get(4), 0, 1, 0);
        addNormal(0, 1, 0);
    }

    /** Sets {@link #lo} and {@link #hi}. */
    void project(double nx, double ny, double nz) {
        if (points > 0) {
            double least = nx * px[0] + ny * py[0] + nz * pz[0];
            double most = least;
            for (int k = 1; k < points; k++) {
                double reach = nx * px[k] + ny * py[k] + nz * pz[k];
                least = Math.min(least, reach);
                most = Math.max(most, reach);
            }
            lo = least;
            hi = most;
        } else {
            double middle = nx * cx + ny * cy + nz * cz;
            double radius = 0;
            for (int k = 0; k < halves; k += 3) {
                radius += Math.abs(nx * half[k] + ny * half[k + 1] + nz * half[k + 2]);
            }
            lo = middle - radius;
            hi = middle + radius;
        }
    }

    private void clear() {
        normals = 0;
        edges = 0;
        halves = 0;
        points = 0;
        doubtful = false;
    }

    private void centre(double[] row, int at, double ox, double oy, double oz) {
        cx = row[at] - ox;
        cy = row[at + 1] - oy;
        cz = row[at + 2] - oz;
        mx = Math.abs(cx);
        my = Math.abs(cy);
        mz = Math.abs(cz);
    }

    private void halfVector(double h, double ux, double uy, double uz) {
        half[halves] = h * ux;
        half[halves + 1] = h * uy;
        half[halves + 2] = h * uz;
        mx += Math.abs(half[halves]);
        my += Math.abs(half[halves + 1]);
        mz += Math.abs(half[halves + 2]);
        halves += 3;
    }

    private void corners(double[] row, int at, double ox, double oy, double oz, double heights) {
        mx = 0;
        my = 0;
        mz = 0;
        for (int k = 0; k < 3; k++) {
            px[k] = row[at + 3 * k] - ox;
            py[k] = heights * (row[at + 3 * k + 1] - oy);
            pz[k] = row[at + 3 * k + 2] - oz;
            mx = Math.max(mx, Math.abs(px[k]));
            my = Math.max(my, Math.abs(py[k]));
            mz = Math.max(mz, Math.abs(pz[k]));
        }
        points = 3;
        for (int k = 0; k < 3; k++) {
            int next = 3 * ((k + 1) % 3);
            addEdge(
                    row[at + next] - row[at + 3 * k],
                    heights * (row[at + next + 1] - row[at + 3 * k + 1]),
                    row[at + next + 2] - row[at + 3 * k + 2]);
        }
    }

    private void spatialTriangle() {
        addCross(0, 3);
        doubtful = isDoubtful(0);
    }

    // A vertical triangle projects to a segment, so its direction bounds it too; any two axes bound a point.
    private void planarTriangle() {
        addCross(0, 3);
        boolean flat = isDoubtful(0);
        normals = 0;
        for (int k = 0; k < 9; k += 3) {
            addNormal(-edge[k + 2], 0, edge[k]);
            recipe[normals - 1] = ACROSS + k / 3;
        }
        if (flat) {
            for (int k = 0; k < 9; k += 3) {
                addNormal(edge[k], 0, edge[k + 2]);
                recipe[normals - 1] = ALONG + k / 3;
            }
            addNormal(1, 0, 0);
            addNormal(0, 0, 1);
        }
        edges = 0;
    }

    /** Whether a normal may consist of rounding errors only. */
    private boolean isDoubtful(int axis) {
        int k = 3 * axis;
        for (int m = k; m < k + 3; m++) {
            if (Math.abs(normal[m]) > AxisBody.ROUNDOFF * normalSize[m] + AxisBody.TINY) {
                return false;
            }
        }
        return true;
    }

    private void addNormal(double x, double y, double z) {
        recipe[normals] = GIVEN;
        int k = 3 * normals++;
        normal[k] = x;
        normal[k + 1] = y;
        normal[k + 2] = z;
        normalSize[k] = Math.abs(x);
        normalSize[k + 1] = Math.abs(y);
        normalSize[k + 2] = Math.abs(z);
    }

    private void addEdge(double x, double y, double z) {
        int k = 3 * edges++;
        edge[k] = x;
        edge[k + 1] = y;
        edge[k + 2] = z;
    }

    private void addCross(int i, int j) {
        recipe[normals] = CROSS + 8 * (i / 3) + j / 3;
        int k = 3 * normals++;
        double p = edge[i + 1] * edge[j + 2];
        double q = edge[i + 2] * edge[j + 1];
        normal[k] = p - q;
        normalSize[k] = Math.abs(p) + Math.abs(q);
        p = edge[i + 2] * edge[j];
        q = edge[i] * edge[j + 2];
        normal[k + 1] = p - q;
        normalSize[k + 1] = Math.abs(p) + Math.abs(q);
        p = edge[i] * edge[j + 1];
        q = edge[i + 1] * edge[j];
        normal[k + 2] = p - q;
        normalSize[k + 2] = Math.abs(p) + Math.abs(q);
    }
}
