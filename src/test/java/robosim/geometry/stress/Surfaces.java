package robosim.geometry.stress;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.reference.Truth.Form;

/** Small meshes made up at random, and the triangles that they are. */
final class Surfaces {
    private static final int[][] TETRAHEDRON = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    private static final int[][] OCTAHEDRON = {
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}
    };
    private static final int[][] CUBE = {
        {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}
    };

    private static final double[][] TETRAHEDRON_AT = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    private static final double[][] OCTAHEDRON_AT = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}
    };

    private final SplittableRandom random;

    /** The mesh made last. */
    List<double[]> corners = new ArrayList<>();

    List<int[]> faces = new ArrayList<>();

    /** How the mesh is turned and where it is put; null where it stays as it is, and nothing is rounded. */
    private double @Nullable [] place;

    Surfaces(SplittableRandom random) {
        this.random = random;
    }

    /** A closed surface about the origin, of size about 1: one of several solids, with dents; sometimes with a hollow. */
    void closed(boolean grid) {
        clear();
        shell(grid, 1, 0, 0, 0);
        if (random.nextInt(6) == 0) {
            shell(grid, 0.25, 0, 0, 0); // a hollow
        } else if (random.nextInt(6) == 0) {
            shell(grid, 0.5, 2, grid ? 1 : Forms.between(random, 1), 0); // in two pieces
        }
    }

    private void clear() {
        corners = new ArrayList<>();
        faces = new ArrayList<>();
        place = null;
    }

    private void shell(boolean grid, double size, double x, double y, double z) {
        int sort = random.nextInt(3);
        int first = corners.size();
        int count = sort == 0 ? 4 : sort == 1 ? 6 : 8;
        for (int k = 0; k < count; k++) {
            double[] at = sort == 0
                    ? TETRAHEDRON_AT[k].clone()
                    : sort == 1
                            ? OCTAHEDRON_AT[k].clone()
                            : new double[] {(k & 1) * 2 - 1, (k >> 1 & 1) * 2 - 1, (k >> 2 & 1) * 2 - 1};
            double[] by = {x, y, z};
            for (int axis = 0; axis < 3; axis++) {
                double jitter = grid ? random.nextInt(-2, 3) / 8.0 : Forms.between(random, 0.3);
                at[axis] = size * (at[axis] + jitter) + by[axis];
            }
            corners.add(at);
        }
        for (int[] face : sort == 0 ? TETRAHEDRON : sort == 1 ? OCTAHEDRON : CUBE) {
            int[] shifted = face.clone();
            for (int k = 0; k < shifted.length; k++) {
                shifted[k] += first;
            }
            faces.add(shifted);
        }
    }

    /** A strip of triangles and quads, open and crumpled; on a grid some of them have no area. */
    void strip(boolean grid) {
        clear();
        int count = random.nextInt(3, grid ? 8 : 6);
        for (int k = 0; k < count; k++) {
            corners.add(new double[] {coordinate(grid), coordinate(grid), coordinate(grid)});
        }
        for (int k = 2; k < count; k++) {
            boolean quad = k > 2 && random.nextInt(3) == 0;
            faces.add(quad ? new int[] {k - 3, k - 2, k, k - 1} : new int[] {k - 2, k - 1, k});
        }
    }

    /** One quad, flat or not. */
    void quad(boolean grid) {
        clear();
        for (int k = 0; k < 4; k++) {
            double x = k == 0 || k == 3 ? -1 : 1;
            double z = k < 2 ? -1 : 1;
            double bend = grid ? random.nextInt(-1, 2) * random.nextInt(2) : Forms.between(random, 0.5);
            double slip = grid ? random.nextInt(-1, 2) / 2.0 : Forms.between(random, 0.5);
            corners.add(new double[] {x + slip, bend, z - slip});
        }
        faces.add(new int[] {0, 1, 2, 3});
    }

    private double coordinate(boolean grid) {
        return grid ? random.nextInt(-2, 3) : Forms.between(random, 1);
    }

    void move(double x, double y, double z) {
        for (double[] corner : corners) {
            corner[0] += x;
            corner[1] += y;
            corner[2] += z;
        }
    }

    void scale(int power) {
        for (double[] corner : corners) {
            for (int k = 0; k < 3; k++) {
                corner[k] = Math.scalb(corner[k], power);
            }
        }
    }

    /** Makes it thin along one axis, or nearly flat in some plane. */
    void squash(double factor) {
        int axis = random.nextInt(3);
        double x = random.nextBoolean() ? 0 : Forms.between(random, 1);
        for (double[] corner : corners) {
            corner[axis] = factor * corner[axis] + x * corner[(axis + 1) % 3];
        }
    }

    /** A point at a corner, on an edge or on a face. */
    double[] point() {
        double[] p = new double[3];
        Forms.point(Form.TRIANGLE, random, face(), p);
        return p;
    }

    /** A point in the plane of a face, on it or beside it. */
    double[] about() {
        double[] p = new double[3];
        Mixed.about(Form.TRIANGLE, random, face(), p);
        return p;
    }

    private double[] face() {
        double[] triangles = triangles();
        double[] row = new double[Case.ROW];
        System.arraycopy(triangles, 9 * random.nextInt(triangles.length / 9), row, 0, 9);
        return row;
    }

    /** Moves it so that a point of it comes to the origin. */
    void center(double[] point) {
        move(-point[0], -point[1], -point[2]);
    }

    /** Steps a coordinate of a corner by an ulp or two. */
    void nudge() {
        double[] corner = corners.get(random.nextInt(corners.size()));
        int axis = random.nextInt(3);
        corner[axis] = Forms.step(corner[axis], random.nextInt(-2, 3));
    }

    /** Turns the mesh and puts its centre somewhere: its corners are then rounded once. */
    void turnAndPut(double x, double y, double z) {
        double[] row = new double[Case.ROW];
        Forms.turn(random, row);
        row[0] = x;
        row[1] = y;
        row[2] = z;
        place = row;
    }

    MeshObject mesh() {
        List<Point> points = new ArrayList<>(corners.size());
        for (double[] corner : corners) {
            points.add(new Point(corner[0], corner[1], corner[2]));
        }
        MeshObject mesh = new MeshObject(points, faces.toArray(int[][]::new));
        if (place == null) {
            return mesh;
        }
        double[] turn = new double[9];
        System.arraycopy(place, 6, turn, 0, 9);
        return mesh.oriented(turn).movedTo(new Point(place[0], place[1], place[2]));
    }

    /** The triangles of it where it stands; a quad is two of them on the diagonal 0-2. */
    double[] triangles() {
        int count = 0;
        for (int[] face : faces) {
            count += face.length - 2;
        }
        double[] out = new double[9 * count];
        int to = 0;
        for (int[] face : faces) {
            for (int k = 2; k < face.length; k++) {
                to = write(out, to, face[0]);
                to = write(out, to, face[k - 1]);
                to = write(out, to, face[k]);
            }
        }
        return out;
    }

    private int write(double[] out, int to, int corner) {
        double[] p = corners.get(corner);
        for (int axis = 0; axis < 3; axis++) {
            // Each placed coordinate is made once, in this order.
            out[to + axis] = place == null
                    ? p[axis]
                    : place[6 + 3 * axis] * p[0]
                            + place[7 + 3 * axis] * p[1]
                            + place[8 + 3 * axis] * p[2]
                            + place[axis];
        }
        return to + 3;
    }
}
