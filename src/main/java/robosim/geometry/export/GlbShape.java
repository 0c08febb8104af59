package robosim.geometry.export;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.MeshObject;

/**
 * The triangles of a shape, counter-clockwise seen from outside; without normals where each face is flat by itself. Each
 * vertex has its place (s, t) in the plane of a texture, in the units of the shape, as
 * {@link robosim.geometry.material.Texture} defines it.
 */
final class GlbShape {
    /** Flat sides of a round shape. */
    private static final int SIDES = 48;

    private static final int RINGS = SIDES / 2;

    private float[] points = new float[256];
    private float @Nullable [] normals;
    private double[] places = new double[256];
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

    /** Two numbers for each vertex. */
    double[] places() {
        return Arrays.copyOf(places, size / 3 * 2);
    }

    int[] indices() {
        return Arrays.copyOf(indices, corners);
    }

    /** An object that is no group, in its own frame. */
    static GlbShape of(GeometryObject object) {
        if (object instanceof MeshObject mesh) {
            return mesh(mesh.triangles());
        }
        return object instanceof GridObject grid ? grid(grid) : of(object.roundedBox());
    }

    static GlbShape of(RoundedBox box) {
        double height = 2 * box.halfHeight();
        return box.ball() > 0
                ? capsule(box.ball(), height)
                : box.disc() > 0
                        ? cylinder(box.disc(), height)
                        : box(2 * box.halfWidth(), height, 2 * box.halfLength());
    }

    static GlbShape box(double width, double height, double length) {
        GlbShape shape = new GlbShape(true);
        double[] half = {width / 2, height / 2, length / 2};
        shape.box(new double[3], half, half);
        return shape;
    }

    /** Six faces around a middle; the texture lies as on a larger box, which is around the origin. */
    private void box(double[] middle, double[] half, double[] whole) {
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                int[] quad = new int[4];
                for (int k = 0; k < 4; k++) {
                    double[] at = middle.clone();
                    double[] out = new double[3];
                    int one = (axis + 1) % 3;
                    int two = (axis + 2) % 3;
                    at[axis] += side * half[axis];
                    at[one] += (k == 0 || k == 3 ? -side : side) * half[one];
                    at[two] += (k < 2 ? -1 : 1) * half[two];
                    out[axis] = side;
                    quad[k] = vertex(at, out, onBox(at, out, whole));
                }
                quad(quad[0], quad[1], quad[2], quad[3]);
            }
        }
    }

    /** Where a point lies in the texture of the side of a box that its normal's largest component names. */
    private static double[] onBox(double[] at, double[] out, double[] half) {
        double x = Math.abs(out[0]);
        double y = Math.abs(out[1]);
        double z = Math.abs(out[2]);
        if (y >= x && y >= z) {
            return new double[] {at[0] + half[0], half[2] - Math.signum(out[1]) * at[2]};
        }
        return new double[] {
            x >= z ? half[2] - Math.signum(out[0]) * at[2] : half[0] + Math.signum(out[2]) * at[0], at[1] + half[1]
        };
    }

    static GlbShape cylinder(double radius, double height) {
        GlbShape shape = new GlbShape(true);
        double[] half = {radius, height / 2, radius};
        int bottom = shape.cap(0, 0, -1, half);
        int top = shape.cap(0, 0, 1, half);
        int[] last = {};
        for (int k = 0; k <= SIDES; k++) {
            double x = Degrees.cos(360.0 / SIDES * (k % SIDES));
            double z = -Degrees.sin(360.0 / SIDES * (k % SIDES));
            double s = 2 * Math.PI / SIDES * k * radius;
            double[] out = {x, 0, z};
            int[] next = {
                shape.vertex(new double[] {radius * x, -height / 2, radius * z}, out, new double[] {s, 0}),
                shape.vertex(new double[] {radius * x, height / 2, radius * z}, out, new double[] {s, height}),
                shape.cap(x, z, -1, half),
                shape.cap(x, z, 1, half)
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

    /** A vertex of the top or the bottom of a cylinder of radius 1. */
    private int cap(double x, double z, int side, double[] half) {
        double[] at = {half[0] * x, half[1] * side, half[2] * z};
        double[] out = {0, side, 0};
        return vertex(at, out, onBox(at, out, half));
    }

    /** A sphere, cut at its equator, with its halves moved apart by half a segment each. */
    static GlbShape capsule(double radius, double segment) {
        GlbShape shape = new GlbShape(true);
        int rows = 0;
        for (int ring = 0; ring <= RINGS; ring++) {
            rows = shape.ring(radius, ring, ring <= RINGS / 2 ? 0 : segment, segment, rows);
            if (ring == RINGS / 2 && segment > 0) {
                rows = shape.ring(radius, ring, segment, segment, rows);
            }
        }
        return shape;
    }

    /** A ring of a ball, lifted from the lower half's place, and joined to the one below it unless it is the first. */
    private int ring(double radius, int ring, double lift, double segment, int rows) {
        double up = -Degrees.cos(180.0 / RINGS * ring);
        double out = Degrees.sin(180.0 / RINGS * ring);
        int first = size / 3;
        for (int k = 0; k <= SIDES; k++) {
            double x = out * Degrees.cos(360.0 / SIDES * (k % SIDES));
            double z = -out * Degrees.sin(360.0 / SIDES * (k % SIDES));
            double[] at = {radius * x, radius * up + lift - segment / 2, radius * z};
            double[] place = {2 * Math.PI / SIDES * k * radius, Math.PI / RINGS * ring * radius + lift};
            vertex(at, new double[] {x, up, z}, place);
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

    /** All triangles, which share their corners. */
    static GlbShape mesh(TriangleMesh mesh) {
        GlbShape shape = new GlbShape(false);
        double[] none = new double[3];
        for (int v = 0; v < mesh.vertices(); v++) {
            shape.vertex(corner(mesh, v), none, none);
        }
        for (int t = 0; t < mesh.size(); t++) {
            shape.triangle(mesh.vertex(t, 0), mesh.vertex(t, 1), mesh.vertex(t, 2));
        }
        return shape;
    }

    /** The triangles that have texture coordinates, each with corners of its own; places are shares of a picture. */
    static GlbShape pictured(TriangleMesh mesh) {
        GlbShape shape = new GlbShape(false);
        double[] none = new double[3];
        for (int t = 0; t < mesh.size(); t++) {
            for (int k = 0; k < 3 && mesh.isTextured(t); k++) {
                double[] place = {mesh.textured(t, k, 0), mesh.textured(t, k, 1)};
                int vertex = shape.vertex(corner(mesh, mesh.vertex(t, k)), none, place);
                if (k == 2) {
                    shape.triangle(vertex - 2, vertex - 1, vertex);
                }
            }
        }
        return shape;
    }

    /**
     * The triangles, each with corners of its own; places are those of a box.
     *
     * @param all also those that have texture coordinates
     */
    static GlbShape faces(TriangleMesh mesh, boolean all) {
        GlbShape shape = new GlbShape(false);
        double[] origin = new double[3];
        for (int t = 0; t < mesh.size(); t++) {
            if (all || !mesh.isTextured(t)) {
                double[] a = corner(mesh, mesh.vertex(t, 0));
                double[] b = corner(mesh, mesh.vertex(t, 1));
                double[] c = corner(mesh, mesh.vertex(t, 2));
                double[] out = new double[3];
                for (int k = 0; k < 3; k++) {
                    int i = (k + 1) % 3;
                    int j = (k + 2) % 3;
                    out[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
                }
                int first = shape.vertex(a, out, onBox(a, out, origin));
                shape.vertex(b, out, onBox(b, out, origin));
                shape.triangle(first, first + 1, shape.vertex(c, out, onBox(c, out, origin)));
            }
        }
        return shape;
    }

    private static double[] corner(TriangleMesh mesh, int vertex) {
        return new double[] {mesh.coordinate(vertex, 0), mesh.coordinate(vertex, 1), mesh.coordinate(vertex, 2)};
    }

    /** Boxes of as many cells as make a rectangle, in the grid's own frame; their faces share corners. */
    static GlbShape grid(GridObject grid) {
        GlbShape shape = new GlbShape(false);
        double[] none = new double[3];
        for (GridCells.Rectangle each : new GridCells(grid).rectangles) {
            double[] middle = middle(grid, each);
            double[] half = half(grid, each);
            int first = shape.size / 3;
            for (int k = 0; k < 8; k++) {
                double[] at = middle.clone();
                for (int axis = 0; axis < 3; axis++) {
                    at[axis] += (k >> axis & 1) == 0 ? -half[axis] : half[axis];
                }
                shape.vertex(at, none, none);
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

    /** The same, each face with corners of its own. */
    static GlbShape texturedGrid(GridObject grid) {
        GlbShape shape = new GlbShape(true);
        double[] whole = {grid.columns() * grid.cell() / 2, grid.height() / 2, grid.rows() * grid.cell() / 2};
        for (GridCells.Rectangle each : new GridCells(grid).rectangles) {
            shape.box(middle(grid, each), half(grid, each), whole);
        }
        return shape;
    }

    private static double[] middle(GridObject grid, GridCells.Rectangle cells) {
        double x = (cells.fromColumn() + cells.toColumn() - grid.columns()) * grid.cell() / 2;
        return new double[] {x, 0, (cells.fromRow() + cells.toRow() - grid.rows()) * grid.cell() / 2};
    }

    private static double[] half(GridObject grid, GridCells.Rectangle cells) {
        double x = (cells.toColumn() - cells.fromColumn()) * grid.cell() / 2;
        return new double[] {x, grid.height() / 2, (cells.toRow() - cells.fromRow()) * grid.cell() / 2};
    }

    private int vertex(double[] at, double[] out, double[] place) {
        if (size + 3 > points.length) {
            points = Arrays.copyOf(points, 2 * points.length);
            places = Arrays.copyOf(places, 2 * places.length);
            normals = normals == null ? null : Arrays.copyOf(normals, points.length);
        }
        for (int k = 0; k < 3; k++) {
            points[size + k] = (float) (at[k] + 0.0);
            if (normals != null) {
                normals[size + k] = (float) (out[k] + 0.0);
            }
        }
        places[size / 3 * 2] = place[0];
        places[size / 3 * 2 + 1] = place[1];
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
