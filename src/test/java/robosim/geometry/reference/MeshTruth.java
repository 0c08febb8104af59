package robosim.geometry.reference;

import static robosim.geometry.reference.Vectors.cross;
import static robosim.geometry.reference.Vectors.dot;
import static robosim.geometry.reference.Vectors.minus;

import java.util.Arrays;
import robosim.geometry.reference.Quantity.Arithmetic;
import robosim.geometry.reference.Truth.Form;

/** Yes or no about surfaces that are given as triangles, nine numbers each, without a tree: every triangle is asked. */
public final class MeshTruth {
    private MeshTruth() {}

    /** Whether two surfaces have a point in common. */
    public static boolean meet(Arithmetic n, double[] a, double[] b) {
        Hull[] first = new Hull[a.length / 9];
        for (int k = 0; k < b.length; k += 9) {
            if (meets(n, a, first, Form.TRIANGLE, Arrays.copyOfRange(b, k, k + 9))) {
                return true;
            }
        }
        return false;
    }

    /** Whether a form that is no cylinder meets a surface. */
    public static boolean meets(Arithmetic n, double[] triangles, Form form, double[] row) {
        return meets(n, triangles, new Hull[triangles.length / 9], form, row);
    }

    /**
     * @param hulls those of the triangles that were needed so far
     */
    private static boolean meets(Arithmetic n, double[] triangles, Hull[] hulls, Form form, double[] row) {
        Hull hull = null;
        for (int k = 0; k < hulls.length; k++) {
            double[] triangle = Arrays.copyOfRange(triangles, 9 * k, 9 * k + 9);
            if (isFar(form, row, triangle)) {
                continue;
            }
            if (hull == null) {
                hull = Truth.hull(n, form, row);
            }
            if (hulls[k] == null) {
                hulls[k] = Hull.triangle(n, triangle);
            }
            if (hulls[k].meets(hull)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the coordinates alone, which nothing has rounded, show two triangles to be apart. */
    private static boolean isFar(Form form, double[] row, double[] triangle) {
        if (form != Form.TRIANGLE) {
            return false;
        }
        for (int k = 0; k < 3; k++) {
            double least = Math.min(triangle[k], Math.min(triangle[3 + k], triangle[6 + k]));
            double most = Math.max(triangle[k], Math.max(triangle[3 + k], triangle[6 + k]));
            if (least > Math.max(row[k], Math.max(row[3 + k], row[6 + k]))
                    || most < Math.min(row[k], Math.min(row[3 + k], row[6 + k]))) {
                return true;
            }
        }
        return false;
    }

    /** Whether a ray, given by start and direction, hits a surface. */
    public static boolean isHit(Arithmetic n, double[] triangles, double[] ray) {
        for (int k = 0; k < triangles.length; k += 9) {
            if (Truth.spatialRay(n, ray, Form.TRIANGLE, Arrays.copyOfRange(triangles, k, k + 9))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a point that is not on a closed surface lies inside: by the parity of what a ray crosses, in some direction
     * in which it meets no edge and no corner. There is one, as only so many are in their way.
     */
    public static boolean isInside(Arithmetic n, double[] triangles, double x, double y, double z) {
        Quantity[] from = Vectors.of(n, x, y, z);
        Quantity[][] corners = new Quantity[triangles.length / 3][];
        for (int k = 0; k < corners.length; k++) {
            corners[k] = minus(Vectors.of(n, triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2]), from);
        }
        for (int attempt = 1; attempt < 1000; attempt++) {
            // Not along anything that a test is likely to make up
            Quantity[] way = Vectors.of(n, 7 + attempt, 3 * attempt * attempt - 20, 31 - 5 * attempt);
            int crossings = crossings(corners, way);
            if (crossings >= 0) {
                return crossings % 2 == 1;
            }
        }
        throw new IllegalStateException("every direction meets an edge (got: " + Arrays.toString(triangles) + ")");
    }

    /** How many triangles the ray from the origin crosses; -1 where it meets an edge, or its line does. */
    private static int crossings(Quantity[][] corners, Quantity[] way) {
        int crossings = 0;
        for (int k = 0; k < corners.length; k += 3) {
            Quantity[] a = corners[k];
            Quantity[] b = corners[k + 1];
            Quantity[] c = corners[k + 2];
            int ab = dot(way, cross(a, b)).signum();
            int bc = dot(way, cross(b, c)).signum();
            int ca = dot(way, cross(c, a)).signum();
            if ((ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0)) {
                continue; // passes by
            }
            if (ab == 0 && bc == 0 && ca == 0 && isFlat(a, b, c)) {
                continue; // a point, or a segment in line with the start, which is not on it
            }
            if (ab == 0 || bc == 0 || ca == 0) {
                return -1;
            }
            if (dot(a, cross(b, c)).signum() == ab) {
                crossings++;
            }
        }
        return crossings;
    }

    private static boolean isFlat(Quantity[] a, Quantity[] b, Quantity[] c) {
        for (Quantity part : cross(minus(b, a), minus(c, a))) {
            if (part.signum() != 0) {
                return false;
            }
        }
        return true;
    }
}
