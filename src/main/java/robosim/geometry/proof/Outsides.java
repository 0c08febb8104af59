package robosim.geometry.proof;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.proof.Proof.Flaw;

/** Finds rays that show whether points are inside solid meshes. */
final class Outsides {
    /** Directions along no edge that anybody is likely to model. */
    private static final double[][] RAYS = {
        {0.6173, 0.5281, 0.3727}, {-0.4519, 0.7307, 0.2213}, {0.1931, -0.3343, 0.8837}, {-0.7027, -0.2741, -0.5167},
        {0.3119, 0.0713, -0.9391}, {-0.1277, -0.9349, 0.3011}, {0.8713, -0.1499, -0.4253}, {-0.5477, 0.4129, -0.7013}
    };

    /** Triangles that are counted between two parts of the work. */
    private static final int PART = 1024;

    private final SceneRows rows;
    private final List<GeometryObject> objects;
    private final Runnable betweenParts;

    Outsides(SceneRows rows, Runnable betweenParts) {
        this.rows = rows;
        this.betweenParts = betweenParts;
        objects = rows.objects;
    }

    /** A ray from a point that crosses a closed surface as often as a parity says; null if there is none. */
    @Nullable
    Point direction(Vec start, List<Piece> solid, int parity) {
        for (double[] ray : RAYS) {
            int crossings = crossings(start, Vec.of(ray[0], ray[1], ray[2]), solid);
            if (crossings >= 0) {
                return crossings % 2 == parity ? new Point(ray[0], ray[1], ray[2]) : null;
            }
        }
        return null;
    }

    /** How many triangles a ray crosses; -1 if it passes an edge. */
    private int crossings(Vec start, Vec ray, List<Piece> solid) {
        try {
            int count = 0;
            for (int from = 0; from < solid.size(); from += PART) {
                betweenParts.run();
                count += ScenePieces.crossings(start, ray, solid.subList(from, Math.min(from + PART, solid.size())));
            }
            return count;
        } catch (Flaw passesAnEdge) {
            return -1;
        }
    }

    /** Adds what a course needs; returns why it cannot, or nothing. */
    String add(Course course, @Nullable GeometryObject body, int self, int other, List<Witness.Outside> out) {
        List<int[]> own = body == null || !mayBeSolid(body) ? List.of() : ScenePieces.solids(body, 0);
        for (int object = 0; object < objects.size(); object++) {
            if (other == Claim.ALL ? object != self : object == other) {
                String failure = add(course, object, own, out);
                if (!failure.isEmpty()) {
                    return failure;
                }
            }
        }
        return "";
    }

    private static boolean mayBeSolid(GeometryObject object) {
        return object instanceof MeshObject || object instanceof ObjectGroup;
    }

    private String add(Course course, int object, List<int[]> own, List<Witness.Outside> out) {
        if (mayBeSolid(objects.get(object))) {
            for (int[] solid : ScenePieces.solids(objects.get(object), rows.first[object])) {
                for (int i = 0; i < course.rows.length; i++) {
                    betweenParts.run();
                    if (!isClear(course, new int[] {i, i + 1}, solid)) {
                        Point ray = direction(first(course.rows[i]), rows.exact(solid), 0);
                        if (ray == null) {
                            return "piece " + i + " of the body was not seen outside solid mesh " + solid[0];
                        }
                        out.add(new Witness.Outside(i, solid[0], true, ray));
                    }
                }
            }
        }
        for (int[] solid : own) {
            for (int j = rows.first[object]; j < rows.first[object + 1]; j++) {
                betweenParts.run();
                if (!isClear(course, solid, new int[] {j, j + 1})) {
                    Point ray = direction(first(rows.rows[j]), body(course, solid), 0);
                    if (ray == null) {
                        return "piece " + j + " was not seen outside the body's solid mesh " + solid[0];
                    }
                    out.add(new Witness.Outside(solid[0], j, false, ray));
                }
            }
        }
        return "";
    }

    private static Vec first(double[] row) {
        return Vec.of(row[0], row[1], row[2]);
    }

    private static List<Piece> body(Course course, int[] range) {
        List<Piece> pieces = new ArrayList<>();
        for (int i = range[0]; i < range[1]; i++) {
            pieces.add(new Piece(course.rows[i]));
        }
        return pieces;
    }

    /** Whether an axis alone keeps all of some pieces from all of others. */
    private boolean isClear(Course course, int[] mine, int[] theirs) {
        double[] n = new double[3];
        for (int axis = 0; axis < 3 && !course.isTurn(); axis++) {
            n[axis] = 1;
            double most = Double.NEGATIVE_INFINITY;
            double least = Double.POSITIVE_INFINITY;
            double[] back = {-n[0], -n[1], -n[2]};
            for (int i = mine[0]; i < mine[1]; i++) {
                double pad = Rows.ROUNDING * course.size(i);
                most = Math.max(most, course.top(i, n, 0, course.end) + pad);
                least = Math.min(least, -course.top(i, back, 0, course.end) - pad);
            }
            n[axis] = 0;
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int j = theirs[0]; j < theirs[1]; j++) {
                low = Math.min(low, rows.bounds[6 * j + axis]);
                high = Math.max(high, rows.bounds[6 * j + 3 + axis]);
            }
            if (most < low || least > high) {
                return true;
            }
        }
        return false;
    }
}
