package robosim.geometry.export;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.TriangleMesh;

/** The triangles of a shape, counter-clockwise seen from outside; without normals where each face is flat by itself. */
final class GlbShape {
    /** Flat sides of a round shape. */
    private static final int SIDES = 48;

    private static final int RINGS = SIDES / 2;

    private float[] points = new float[256];
    private float @Nullable [] normals;
    private int size;
    private int[] indices = new int[256];
    private int corners;

    private GlbShape(boolean withNormals) {
        normals = withNormals ? new float[256] : null;
    }

    float[] points() {
        return Arrays.copyOf(points, size);
    }

    /** Null where a viewer takes those of the faces. */
    float @Nullable [] normals() {
        return normals == null ? null : Arrays.copyOf(normals, size);
    }

    int[] indices() {
        return Arrays.copyOf(indices, corners);
    }

    /** A box with sides of 1. */
    static GlbShape box() {
        GlbShape shape = new GlbShape(true);
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                int[] quad = new int[4];
                for (int k = 0; k < 4; k++) {
                    double[] at = new double[3];
                    double[] out = new double[3];
                    at[axis] = side / 2.0;
                    at[(axis + 1) % 3] = (k == 0 || k == 3 ? -side : side) / 2.0;
                    at[(axis + 2) % 3] = (k < 2 ? -1 : 1) / 2.0;
                    out[axis] = side;
                    quad[k] = shape.vertex(at[0], at[1], at[2], out[0], out[1], out[2]);
                }
                shape.quad(quad[0], quad[1], quad[2], quad[3]);
            }
        }
        return shape;
    }

    /** A cylinder of radius 1 and height 1. */
    static GlbShape cylinder() {
        GlbShape shape = new GlbShape(true);
        int bottom = shape.vertex(0, -0.5, 0, 0, -1, 0);
        int top = shape.vertex(0, 0.5, 0, 0, 1, 0);
        int[] last = {};
        for (int k = 0; k <= SIDES; k++) {
            double x = Degrees.cos(360.0 / SIDES * (k % SIDES));
            double z = -Degrees.sin(360.0 / SIDES * (k % SIDES));
            int[] next = {
                shape.vertex(x, -0.5, z, x, 0, z),
                shape.vertex(x, 0.5, z, x, 0, z),
                shape.vertex(x, -0.5, z, 0, -1, 0),
                shape.vertex(x, 0.5, z, 0, 1, 0)
            };
            if (k > 0) {
                shape.quad(last[0], next[0], next[1], last[1]);
                shape.triangle(bottom, next[2], last[2]);
                shape.triangle(top, last[3], next[3]);
            }
            last = next;
        }
        return shape;
    }

    /** A sphere, cut at its equator, with its halves moved apart by half a segment each. */
    static GlbShape capsule(double radius, double segment) {
        GlbShape shape = new GlbShape(true);
        int rows = 0;
        for (int ring = 0; ring <= RINGS; ring++) {
            rows = shape.ring(radius, ring, ring <= RINGS / 2 ? -segment / 2 : segment / 2, rows);
            if (ring == RINGS / 2 && segment > 0) {
                rows = shape.ring(radius, ring, segment / 2, rows);
            }
        }
        return shape;
    }

    /** A ring of a ball, joined to the one below it unless it is the first. */
    private int ring(double radius, int ring, double lift, int rows) {
        double up = -Degrees.cos(180.0 / RINGS * ring);
        double out = Degrees.sin(180.0 / RINGS * ring);
        int first = size / 3;
        for (int k = 0; k <= SIDES; k++) {
            double x = out * Degrees.cos(360.0 / SIDES * (k % SIDES));
            double z = -out * Degrees.sin(360.0 / SIDES * (k % SIDES));
            vertex(radius * x, radius * up + lift, radius * z, x, up, z);
        }
        int below = first - SIDES - 1;
        for (int k = 0; k < SIDES && rows > 0; k++) {
            if (rows > 1) { // at the lower pole they are one point
                triangle(below + k, below + k + 1, first + k + 1);
            }
            if (ring < RINGS) {
                triangle(below + k, first + k + 1, first + k);
            }
        }
        return rows + 1;
    }

    static GlbShape mesh(TriangleMesh mesh) {
        GlbShape shape = new GlbShape(false);
        for (int v = 0; v < mesh.vertices(); v++) {
            shape.vertex(mesh.coordinate(v, 0), mesh.coordinate(v, 1), mesh.coordinate(v, 2), 0, 0, 0);
        }
        for (int t = 0; t < mesh.size(); t++) {
            shape.triangle(mesh.vertex(t, 0), mesh.vertex(t, 1), mesh.vertex(t, 2));
        }
        return shape;
    }

    /** Boxes of as many cells as make a rectangle, in the grid's own frame. */
    static GlbShape grid(GridObject grid) {
        GlbShape shape = new GlbShape(false);
        double half = grid.height() / 2;
        for (GridCells.Rectangle each : new GridCells(grid).rectangles) {
            int first = shape.size / 3;
            for (int k = 0; k < 8; k++) {
                int column = (k & 1) == 0 ? each.fromColumn() : each.toColumn();
                int row = (k & 4) == 0 ? each.fromRow() : each.toRow();
                shape.vertex(
                        (column - grid.columns() / 2.0) * grid.cell(),
                        (k & 2) == 0 ? -half : half,
                        (row - grid.rows() / 2.0) * grid.cell(),
                        0,
                        0,
                        0);
            }
            shape.quad(first, first + 4, first + 6, first + 2);
            shape.quad(first + 1, first + 3, first + 7, first + 5);
            shape.quad(first, first + 1, first + 5, first + 4);
            shape.quad(first + 2, first + 6, first + 7, first + 3);
            shape.quad(first, first + 2, first + 3, first + 1);
            shape.quad(first + 4, first + 5, first + 7, first + 6);
        }
        return shape;
    }

    private int vertex(double x, double y, double z, double outX, double outY, double outZ) {
        if (size + 3 > points.length) {
            points = Arrays.copyOf(points, 2 * points.length);
            normals = normals == null ? null : Arrays.copyOf(normals, points.length);
        }
        points[size] = (float) (x + 0.0);
        points[size + 1] = (float) (y + 0.0);
        points[size + 2] = (float) (z + 0.0);
        if (normals != null) {
            normals[size] = (float) (outX + 0.0);
            normals[size + 1] = (float) (outY + 0.0);
            normals[size + 2] = (float) (outZ + 0.0);
        }
        size += 3;
        return size / 3 - 1;
    }

    private void triangle(int a, int b, int c) {
        if (corners + 3 > indices.length) {
            indices = Arrays.copyOf(indices, 2 * indices.length);
        }
        indices[corners++] = a;
        indices[corners++] = b;
        indices[corners++] = c;
    }

    private void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }
}
