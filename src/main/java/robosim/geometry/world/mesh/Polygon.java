package robosim.geometry.world.mesh;

import java.util.List;
import robosim.geometry.exact.Orientation;
import robosim.geometry.model.Point;
import robosim.geometry.world.shared.FileWork;

/**
 * Cuts a polygon into the triangles and quads of a mesh by ear clipping, projected along the axis along which its area
 * is largest.
 *
 * <p>Only triangles with the polygon's orientation are cut off. Their boundaries add up to the polygon's, so they tile
 * any polygon that does not cross itself; holes that are joined to the outline by a doubled edge are kept.
 */
public final class Polygon {
    private Polygon() {}

    /** Adds the faces of one polygon to a list. */
    public static void cut(List<Point> vertices, int[] corners, List<int[]> faces) {
        if (corners.length == 3) {
            faces.add(corners);
            return;
        }
        double[][] flat = flat(vertices, corners);
        if (corners.length == 4) {
            faces.add(quad(corners, flat));
            return;
        }
        new Clipping(flat, corners, faces).clip();
    }

    /** Adds the faces of one polygon of at least three corners; one that crosses itself is a fan, as programs draw it. */
    static void cutOrFan(List<Point> vertices, int[] corners, List<int[]> faces) {
        int before = faces.size();
        try {
            cut(vertices, corners, faces);
        } catch (IllegalArgumentException e) {
            faces.subList(before, faces.size()).clear();
            for (int k = 1; k + 1 < corners.length; k++) {
                faces.add(new int[] {corners[0], corners[k], corners[k + 1]});
            }
        }
    }

    /**
     * The remaining corners, and for each a corner that its ear contains, if known; this stays valid until that corner
     * or a neighbour is removed. So the total work is quadratic in the number of corners.
     */
    private static final class Clipping {
        private static final int UNKNOWN = 2;

        /** So many corners are looked at in about the time of a unit of work. */
        private static final int LOOKS = 64;

        private final double[][] flat;
        private final int[] corners;
        private final List<int[]> faces;

        private final int[] left;
        private int count;

        /** The turn at each corner: 1 in the polygon's orientation, 0 straight, -1 opposite; or {@link #UNKNOWN}. */
        private final int[] turn;

        /** For each corner: no original corner before this index lies in its triangle. */
        private final int[] within;

        /** Whether the corner at that index does. */
        private final boolean[] held;

        private final boolean[] gone;

        Clipping(double[][] flat, int[] corners, List<int[]> faces) {
            this.flat = flat;
            this.corners = corners;
            this.faces = faces;
            count = corners.length;
            left = new int[count];
            turn = new int[count];
            within = new int[count];
            held = new boolean[count];
            gone = new boolean[count];
            for (int k = 0; k < count; k++) {
                left[k] = k;
                turn[k] = UNKNOWN;
            }
        }

        void clip() {
            FileWork.take((long) count * count / LOOKS); // it is quadratic
            while (count > 3) {
                int ear = ear();
                int before = left[(ear + count - 1) % count];
                int after = left[(ear + 1) % count];
                faces.add(new int[] {corners[before], corners[left[ear]], corners[after]});
                gone[left[ear]] = true;
                turn[before] = UNKNOWN;
                turn[after] = UNKNOWN;
                System.arraycopy(left, ear + 1, left, ear, count - ear - 1);
                count--;
            }
            if (side(flat, left[0], left[1], left[2]) < 0) {
                throw crossed(corners.length);
            }
            faces.add(new int[] {corners[left[0]], corners[left[1]], corners[left[2]]});
        }

        /**
         * A corner whose triangle contains no other; else one between two collinear edges, which gives a flat triangle.
         */
        private int ear() {
            int inLine = -1;
            for (int k = 0; k < count; k++) {
                int b = left[k];
                if (turn[b] < 0) {
                    continue;
                }
                int a = left[(k + count - 1) % count];
                int c = left[(k + 1) % count];
                if (turn[b] == UNKNOWN) {
                    turn[b] = side(flat, a, b, c);
                    within[b] = 0;
                    held[b] = false;
                }
                if (turn[b] > 0 && isEmpty(a, b, c)) {
                    return k;
                }
                if (turn[b] == 0 && inLine < 0) {
                    inLine = k;
                }
            }
            if (inLine < 0) {
                throw crossed(corners.length);
            }
            return inLine;
        }

        private boolean isEmpty(int a, int b, int c) {
            if (held[b] && !gone[within[b]]) {
                return false;
            }
            double[] x = flat[0];
            double[] y = flat[1];
            double minX = Math.min(x[a], Math.min(x[b], x[c]));
            double maxX = Math.max(x[a], Math.max(x[b], x[c]));
            double minY = Math.min(y[a], Math.min(y[b], y[c]));
            double maxY = Math.max(y[a], Math.max(y[b], y[c]));
            int p = within[b];
            for (; p < gone.length; p++) {
                if (!gone[p]
                        && x[p] >= minX
                        && x[p] <= maxX
                        && y[p] >= minY
                        && y[p] <= maxY
                        && !same(flat, p, a)
                        && !same(flat, p, b)
                        && !same(flat, p, c)
                        && side(flat, a, b, p) >= 0
                        && side(flat, b, c, p) >= 0
                        && side(flat, c, a, p) >= 0) {
                    break;
                }
            }
            within[b] = p;
            held[b] = p < gone.length;
            return !held[b];
        }
    }

    // A mesh cuts a quad along the diagonal 0-2; if that lies outside, the corners are rotated to use the other
    // diagonal.
    private static int[] quad(int[] corners, double[][] flat) {
        boolean first = side(flat, 0, 1, 2) >= 0 && side(flat, 0, 2, 3) >= 0;
        boolean second = side(flat, 1, 2, 3) >= 0 && side(flat, 1, 3, 0) >= 0;
        return first || !second ? corners : new int[] {corners[1], corners[2], corners[3], corners[0]};
    }

    private static boolean same(double[][] flat, int p, int q) {
        return flat[0][p] == flat[0][q] && flat[1][p] == flat[1][q];
    }

    private static int side(double[][] flat, int a, int b, int p) {
        return Orientation.side(flat[0][a], flat[1][a], flat[0][b], flat[1][b], flat[0][p], flat[1][p]);
    }

    private static IllegalArgumentException crossed(int corners) {
        return new IllegalArgumentException("a polygon must not cross itself; cut it into triangles in the program that"
                + " made it (got: one of " + corners + " corners)");
    }

    /** Two coordinates of each corner, chosen so that the polygon is counter-clockwise in them and far from edge-on. */
    private static double[][] flat(List<Point> vertices, int[] corners) {
        double[][] xyz = new double[3][corners.length];
        for (int k = 0; k < corners.length; k++) {
            Point corner = vertices.get(corners[k]);
            xyz[0][k] = corner.x();
            xyz[1][k] = corner.y();
            xyz[2][k] = corner.z();
        }
        double[] areas = new double[3];
        int axis = 0;
        for (int k = 0; k < 3; k++) {
            areas[k] = doubleArea(xyz[(k + 1) % 3], xyz[(k + 2) % 3]);
            axis = Math.abs(areas[k]) > Math.abs(areas[axis]) ? k : axis;
        }
        double[] across = xyz[(axis + 1) % 3];
        double[] up = xyz[(axis + 2) % 3];
        return areas[axis] >= 0 ? new double[][] {across, up} : new double[][] {up, across};
    }

    // Twice the area by the sum of trapezoids about the first corner; its rounding only matters for slivers.
    private static double doubleArea(double[] x, double[] y) {
        double sum = 0;
        for (int k = 1; k + 1 < x.length; k++) {
            sum += (x[k] - x[0]) * (y[k + 1] - y[0]) - (x[k + 1] - x[0]) * (y[k] - y[0]);
        }
        return sum;
    }
}
