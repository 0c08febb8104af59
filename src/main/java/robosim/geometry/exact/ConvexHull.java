package robosim.geometry.exact;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * The convex hull of points, by Quickhull (Barber, Dobkin and Huhdanpaa 1996). Which side of a plane a point is on is decided for
 * the given numbers, without rounding, so no point is outside. Only the order in which points are added depends on rounded
 * distances.
 */
public final class ConvexHull {
    private final double[] points;
    private final List<Face> faces = new ArrayList<>();
    private final Deque<Face> open = new ArrayDeque<>();

    /** A triangle of the surface, counter-clockwise seen from outside. */
    private static final class Face {
        final int[] corners;
        final double[] places = new double[9];

        /** The faces beyond the edges from each corner to the next. */
        final Face[] beyond = new Face[3];

        /** Points above it that no other face has. */
        int[] outside = new int[4];

        int count;
        boolean isGone;

        Face(double[] points, int... corners) {
            this.corners = corners;
            for (int k = 0; k < 3; k++) {
                System.arraycopy(points, 3 * corners[k], places, 3 * k, 3);
            }
        }

        void add(int point) {
            if (count == outside.length) {
                outside = Arrays.copyOf(outside, 2 * count);
            }
            outside[count++] = point;
        }
    }

    private ConvexHull(double[] points) {
        this.points = points;
    }

    /**
     * The triangles of the surface as indices of points: closed, and counter-clockwise seen from outside. If all points are in one
     * plane, each triangle of their polygon comes twice, facing both ways; if they are on one line, or all the same, there is one
     * triangle of their ends.
     *
     * @param points three coordinates each, of at least one point
     */
    public static int[][] of(double[] points) {
        return new ConvexHull(points).build();
    }

    private int[][] build() {
        int a = end(-1);
        int b = end(1);
        if (compare(a, b) == 0) {
            return new int[][] {{a, a, a}};
        }
        int c = offLine(a, b);
        if (c < 0) {
            return new int[][] {{a, b, b}};
        }
        Face base = new Face(points, a, b, c);
        int d = offPlane(base);
        if (d < 0) {
            return flat(a, b, c);
        }
        begin(side(base, d) < 0 ? base : new Face(points, a, c, b), d);
        while (!open.isEmpty()) {
            Face face = open.pop();
            if (!face.isGone) {
                grow(face);
            }
        }
        return faces.stream()
                .filter(face -> !face.isGone)
                .map(face -> face.corners)
                .toArray(int[][]::new);
    }

    private double coordinate(int point, int axis) {
        return points[3 * point + axis];
    }

    private int count() {
        return points.length / 3;
    }

    private int compare(int p, int q) {
        int order = 0;
        for (int axis = 0; axis < 3 && order == 0; axis++) {
            order = Double.compare(coordinate(p, axis), coordinate(q, axis));
        }
        return order;
    }

    /** The last point in the order of coordinates, or for a sign of -1 the first. */
    private int end(int sign) {
        int end = 0;
        for (int p = 1; p < count(); p++) {
            if (sign * compare(p, end) > 0) {
                end = p;
            }
        }
        return end;
    }

    /** The side of a line that a point is on, in the projection without an axis. */
    private int side(int a, int b, int p, int without) {
        int u = (without + 1) % 3;
        int v = (without + 2) % 3;
        return Orientation.side(
                coordinate(a, u),
                coordinate(a, v),
                coordinate(b, u),
                coordinate(b, v),
                coordinate(p, u),
                coordinate(p, v));
    }

    /** +1 if a point is above a face, 0 in its plane. */
    private int side(Face face, int p) {
        return Orientation.volume(face.places, coordinate(p, 0), coordinate(p, 1), coordinate(p, 2));
    }

    /** A point far off the line of two others; -1 if there is none off it. */
    private int offLine(int a, int b) {
        int found = -1;
        double farthest = -1;
        for (int p = 0; p < count(); p++) {
            double area = 0;
            for (int axis = 0; axis < 3; axis++) {
                int u = (axis + 1) % 3;
                int v = (axis + 2) % 3;
                area += Math.abs((coordinate(b, u) - coordinate(a, u)) * (coordinate(p, v) - coordinate(a, v))
                        - (coordinate(b, v) - coordinate(a, v)) * (coordinate(p, u) - coordinate(a, u)));
            }
            if (area > farthest && (side(a, b, p, 0) != 0 || side(a, b, p, 1) != 0 || side(a, b, p, 2) != 0)) {
                farthest = area;
                found = p;
            }
        }
        return found;
    }

    /** A point far off the plane of a face; -1 if there is none off it. */
    private int offPlane(Face face) {
        int found = -1;
        double farthest = -1;
        for (int p = 0; p < count(); p++) {
            double height = Math.abs(height(face, p));
            if (height > farthest && side(face, p) != 0) {
                farthest = height;
                found = p;
            }
        }
        return found;
    }

    /** A rounded multiple of the height of a point above a face. */
    private double height(Face face, int p) {
        double[] t = face.places;
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int v = (axis + 2) % 3;
            double normal = (t[3 + u] - t[u]) * (t[6 + v] - t[v]) - (t[3 + v] - t[v]) * (t[6 + u] - t[u]);
            sum += normal * (coordinate(p, axis) - t[axis]);
        }
        return sum;
    }

    /** The polygon of points in one plane, a fan of triangles seen from either side: Andrew's monotone chain (1979). */
    private int[][] flat(int a, int b, int c) {
        int without = side(a, b, c, 0) != 0 ? 0 : side(a, b, c, 1) != 0 ? 1 : 2;
        int[] sorted = IntStream.range(0, count())
                .boxed()
                .sorted(this::compare)
                .mapToInt(Integer::intValue)
                .toArray();
        int[] chain = new int[2 * sorted.length];
        int size = 0;
        for (int pass = 0; pass < 2; pass++) {
            int least = size + 1;
            for (int k = 0; k < sorted.length; k++) {
                int p = sorted[pass == 0 ? k : sorted.length - 1 - k];
                while (size > least && side(chain[size - 2], chain[size - 1], p, without) <= 0) {
                    size--;
                }
                if (size < least || compare(chain[size - 1], p) != 0) {
                    chain[size++] = p;
                }
            }
            size--; // each chain ends where the other one begins
        }
        int[][] fan = new int[2 * (size - 2)][];
        for (int k = 2; k < size; k++) {
            fan[2 * k - 4] = new int[] {chain[0], chain[k - 1], chain[k]};
            fan[2 * k - 3] = new int[] {chain[0], chain[k], chain[k - 1]};
        }
        return fan;
    }

    /** Begins with a tetrahedron: a face and a point below it. */
    private void begin(Face base, int d) {
        int a = base.corners[0];
        int b = base.corners[1];
        int c = base.corners[2];
        Face[] made = {base, new Face(points, a, d, b), new Face(points, b, d, c), new Face(points, c, d, a)};
        for (int k = 0; k < 3; k++) {
            Face next = made[1 + (k + 1) % 3];
            base.beyond[k] = made[1 + k];
            made[1 + k].beyond[2] = base;
            made[1 + k].beyond[1] = next; // over the edge from d to the second corner
            next.beyond[0] = made[1 + k];
        }
        List<Face> all = List.of(made);
        for (int p = 0; p < count(); p++) {
            place(p, all);
        }
        keep(all);
    }

    /** Gives a point to the first of some faces that it is above. */
    private void place(int p, List<Face> among) {
        for (Face face : among) {
            if (side(face, p) > 0) {
                face.add(p);
                return;
            }
        }
    }

    private void keep(List<Face> made) {
        faces.addAll(made);
        for (Face face : made) {
            if (face.count > 0) {
                open.push(face);
            }
        }
    }

    /** Adds the point that is highest above a face: it replaces all faces that it is above by those of a cone. */
    private void grow(Face start) {
        int top = highest(start);
        List<Face> seen = new ArrayList<>(List.of(start));
        Map<Integer, Face> cone = new HashMap<>();
        List<Face> made = new ArrayList<>();
        start.isGone = true;
        for (int k = 0; k < seen.size(); k++) {
            Face face = seen.get(k);
            for (int edge = 0; edge < 3; edge++) {
                Face other = face.beyond[edge];
                if (other.isGone) {
                    continue;
                }
                if (side(other, top) > 0) {
                    other.isGone = true;
                    seen.add(other);
                }
            }
        }
        for (Face face : seen) {
            for (int edge = 0; edge < 3; edge++) {
                Face other = face.beyond[edge];
                if (!other.isGone) {
                    int from = face.corners[edge];
                    Face side = new Face(points, from, face.corners[(edge + 1) % 3], top);
                    side.beyond[0] = other;
                    other.beyond[edgeTo(other, from)] = side;
                    cone.put(from, side);
                    made.add(side);
                }
            }
        }
        for (Face side : made) {
            Face next = cone.get(side.corners[1]);
            if (next == null) {
                throw new IllegalStateException(
                        "the horizon must be closed (got: an end at point " + side.corners[1] + ")");
            }
            side.beyond[1] = next;
            next.beyond[2] = side;
        }
        for (Face face : seen) {
            for (int k = 0; k < face.count; k++) {
                if (face.outside[k] != top) {
                    place(face.outside[k], made);
                }
            }
        }
        keep(made);
    }

    private int highest(Face face) {
        int found = face.outside[0];
        double most = height(face, found);
        for (int k = 1; k < face.count; k++) {
            double height = height(face, face.outside[k]);
            if (height > most) {
                most = height;
                found = face.outside[k];
            }
        }
        return found;
    }

    /** The edge of a face that ends in a corner. */
    private static int edgeTo(Face face, int corner) {
        return face.corners[0] == corner ? 2 : face.corners[1] == corner ? 0 : 1;
    }
}
