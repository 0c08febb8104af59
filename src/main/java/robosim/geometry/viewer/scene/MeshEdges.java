package robosim.geometry.viewer.scene;

import java.util.Arrays;
import robosim.geometry.index.meshes.TriangleMesh;

/**
 * The edges of a mesh and the triangles at each, with corners at the same place taken as one. In plain doubles, for
 * pictures.
 */
final class MeshEdges {
    /** Faces that meet at a larger angle, in degrees, have a line between them. */
    private static final double CREASE = 30;

    private static final double MOST_PARALLEL = StrictMath.cos(StrictMath.toRadians(CREASE));

    /** A face of which less than this part is seen from above counts as upright, since corners are rounded. */
    private static final double UPRIGHT = 1e-9;

    private final TriangleMesh mesh;

    /** By triangle and side k, from corner k to the next: the ends as one number, in the order of {@link #sorted}. */
    private final long[] ends;

    /** Sides 3t + k, sorted by their ends. */
    private final int[] sorted;

    MeshEdges(TriangleMesh mesh) {
        this.mesh = mesh;
        int[] welded = mesh.joinEqual(); // a format without shared vertices repeats them
        int sides = 3 * mesh.size();
        long[] byEnds = new long[sides];
        ends = new long[sides];
        for (int side = 0; side < sides; side++) {
            int a = welded[mesh.vertex(side / 3, side % 3)];
            int b = welded[mesh.vertex(side / 3, (side + 1) % 3)];
            ends[side] = (long) Math.min(a, b) << 32 | Math.max(a, b);
        }
        Integer[] order = new Integer[sides];
        Arrays.setAll(order, k -> k);
        Arrays.sort(order, (a, b) -> Long.compare(ends[a], ends[b])); // stable
        sorted = new int[sides];
        for (int k = 0; k < sides; k++) {
            sorted[k] = order[k];
            byEnds[k] = ends[order[k]];
        }
        System.arraycopy(byEnds, 0, ends, 0, sides);
    }

    /** Receives an edge that is drawn. */
    interface Drawn {
        /**
         * One edge.
         *
         * @param a       index of a vertex
         * @param b       index of a vertex
         * @param highest the triangle at this edge with the largest value of {@code tops}
         */
        void edge(int a, int b, int highest);
    }

    /**
     * Finds the edges that a picture needs: open ones, those between faces that are not nearly in one plane, and those of
     * the outline as seen from above.
     *
     * @param seen by vertex its place as seen from above: x, z, x, z ...
     * @param tops by triangle its height
     */
    void drawn(double[] seen, double[] tops, Drawn receiver) {
        for (int from = 0; from < sorted.length; ) {
            int to = from + 1;
            while (to < sorted.length && ends[to] == ends[from]) {
                to++;
            }
            boolean isPoint = ends[from] >>> 32 == (ends[from] & 0xffffffffL);
            if (!isPoint && isDrawn(seen, from, to)) {
                int highest = sorted[from] / 3;
                for (int k = from + 1; k < to; k++) {
                    highest = tops[sorted[k] / 3] > tops[highest] ? sorted[k] / 3 : highest;
                }
                receiver.edge(start(sorted[from]), end(sorted[from]), highest);
            }
            from = to;
        }
    }

    private boolean isDrawn(double[] seen, int from, int to) {
        int first = sorted[from];
        double[] normal = normal(first / 3);
        double[] inner = cross(normal, difference(end(first), start(first)));
        double own = dot(inner, difference(across(first), start(first)));
        double ownSeen = side(seen, first, across(first));
        boolean isUpright = isUpright(ownSeen, normal);
        boolean isOpen = true;
        boolean isOutline = true;
        for (int k = from + 1; k < to; k++) {
            int other = sorted[k];
            double[] its = normal(other / 3);
            double product = dot(normal, its);
            if (product * product < MOST_PARALLEL * MOST_PARALLEL * dot(normal, normal) * dot(its, its)) {
                return true;
            }
            isOpen &= dot(inner, difference(across(other), start(first))) * own > 0;
            double itsSeen = side(seen, first, across(other));
            isOutline &= itsSeen * ownSeen > 0 || isUpright(itsSeen, its) != isUpright;
        }
        return isOpen || isOutline;
    }

    /** Whether a triangle is seen from its side: twice the area that is seen is nothing of twice its area. */
    private static boolean isUpright(double seen, double[] normal) {
        return seen * seen < UPRIGHT * UPRIGHT * dot(normal, normal);
    }

    private int start(int side) {
        return mesh.vertex(side / 3, side % 3);
    }

    private int end(int side) {
        return mesh.vertex(side / 3, (side + 1) % 3);
    }

    private int across(int side) {
        return mesh.vertex(side / 3, (side + 2) % 3);
    }

    /** On which side of an edge a vertex is, as seen from above. */
    private double side(double[] seen, int edge, int vertex) {
        int a = 2 * start(edge);
        int b = 2 * end(edge);
        int p = 2 * vertex;
        return (seen[b] - seen[a]) * (seen[p + 1] - seen[a + 1]) - (seen[b + 1] - seen[a + 1]) * (seen[p] - seen[a]);
    }

    private double[] normal(int triangle) {
        int a = mesh.vertex(triangle, 0);
        return cross(difference(mesh.vertex(triangle, 1), a), difference(mesh.vertex(triangle, 2), a));
    }

    private double[] difference(int to, int from) {
        return new double[] {
            mesh.coordinate(to, 0) - mesh.coordinate(from, 0),
            mesh.coordinate(to, 1) - mesh.coordinate(from, 1),
            mesh.coordinate(to, 2) - mesh.coordinate(from, 2)
        };
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
