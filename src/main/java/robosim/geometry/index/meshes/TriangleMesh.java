package robosim.geometry.index.meshes;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.material.TextureCoordinates;

/**
 * The triangles of a mesh in its own frame and their tree, shared by all placements of the mesh.
 */
public final class TriangleMesh {
    private static final int[] NO_POINTS = {};

    private final double[] coordinates;
    private final int[][] faces;

    /** Three vertex indices per triangle; a quad gives two consecutive triangles, on its diagonal 0-2. */
    private final int[] corners;

    /** By triangle, the index of its face. */
    private final int[] faceOf;

    private final @Nullable TextureCoordinates texture;

    /** By triangle three points of the texture; empty without one. */
    private final int[] texturePoints;

    private volatile @Nullable BoxTree tree;

    private volatile @Nullable WideTree wide;

    /** Nine coordinates per triangle, in the order of the tree's leaves; filled in when the tree is built. */
    private double[] leafCorners = {};

    private int @Nullable [] seeds;

    /** Keeps both arrays without copying them. */
    public TriangleMesh(double[] coordinates, int[][] faces) {
        Checks.present("vertices", coordinates);
        Checks.present("faces", faces);
        if (faces.length == 0) {
            throw new IllegalArgumentException("faces must hold at least one face (got: none)");
        }
        if (coordinates.length % 3 != 0) {
            throw new IllegalArgumentException(
                    "vertices must have three coordinates each (got: " + coordinates.length + " numbers)");
        }
        for (int k = 0; k < coordinates.length; k++) {
            coordinates[k] = Checks.coordinate("vertices[" + k / 3 + "]." + "xyz".charAt(k % 3), coordinates[k]);
        }
        int triangles = 0;
        for (int f = 0; f < faces.length; f++) {
            checkFace(f, faces[f], coordinates.length / 3);
            triangles += faces[f].length - 2;
        }
        this.coordinates = coordinates;
        this.faces = faces;
        this.texture = null;
        this.texturePoints = NO_POINTS;
        this.corners = new int[3 * triangles];
        this.faceOf = new int[triangles];
        int t = 0;
        for (int f = 0; f < faces.length; f++) {
            for (int k = 2; k < faces[f].length; k++) {
                corners[3 * t] = faces[f][0];
                corners[3 * t + 1] = faces[f][k - 1];
                corners[3 * t + 2] = faces[f][k];
                faceOf[t++] = f;
            }
        }
    }

    private TriangleMesh(TriangleMesh surface, @Nullable TextureCoordinates texture) {
        this.coordinates = surface.coordinates;
        this.faces = surface.faces;
        this.corners = surface.corners;
        this.faceOf = surface.faceOf;
        this.texture = texture;
        this.texturePoints = texture == null ? NO_POINTS : texture.ofTriangles(faces, faceOf.length);
    }

    /** The same triangles with other texture coordinates. Its trees are built afresh. */
    public TriangleMesh with(@Nullable TextureCoordinates coordinatesOfTexture) {
        return Objects.equals(texture, coordinatesOfTexture) ? this : new TriangleMesh(this, coordinatesOfTexture);
    }

    /** Where the faces' corners lie in a picture; null if that was not given. */
    public @Nullable TextureCoordinates texture() {
        return texture;
    }

    /** Whether all corners of a triangle have a place in a picture. */
    public boolean isTextured(int triangle) {
        return texturePoints.length > 0 && texturePoints[3 * triangle] != TextureCoordinates.NONE;
    }

    /**
     * The place of a triangle's corner in a picture.
     *
     * @param triangle one that {@linkplain #isTextured is textured}
     * @param corner   0 to 2
     * @param axis     0 for u, 1 for v
     */
    public double textured(int triangle, int corner, int axis) {
        if (texture == null || !isTextured(triangle)) {
            throw new IllegalArgumentException("triangle must be one with texture coordinates (got: " + triangle + ")");
        }
        return texture.coordinate(texturePoints[3 * triangle + corner], axis);
    }

    private static void checkFace(int f, int[] face, int vertices) {
        if (face == null || (face.length != 3 && face.length != 4)) {
            throw new IllegalArgumentException("faces[" + f + "] must have 3 or 4 indices (got: "
                    + (face == null ? "null" : String.valueOf(face.length)) + ")");
        }
        for (int index : face) {
            if (index < 0 || index >= vertices) {
                throw new IllegalArgumentException("faces[" + f + "] must have indices from 0 to " + (vertices - 1)
                        + ", the vertices given (got: " + index + ")");
            }
        }
    }

    /** The number of triangles. */
    public int size() {
        return faceOf.length;
    }

    /** The index of a triangle's face, in the order given. */
    public int face(int triangle) {
        return faceOf[triangle];
    }

    /** The index of one of the three vertices of a triangle. */
    public int vertex(int triangle, int corner) {
        return corners[3 * triangle + corner];
    }

    /** The number of vertices given. */
    public int vertices() {
        return coordinates.length / 3;
    }

    /** One coordinate (0 to 2) of a vertex, in the mesh's own frame. */
    public double coordinate(int vertex, int axis) {
        return coordinates[3 * vertex + axis];
    }

    /** All coordinates, as a fresh array. */
    public double[] coordinates() {
        return coordinates.clone();
    }

    /** The faces as given, as a deep copy. */
    public int[][] faces() {
        return Arrays.stream(faces).map(int[]::clone).toArray(int[][]::new);
    }

    /**
     * One coordinate of a vertex of a placed mesh: R p + centre, always evaluated in the same order, so that shared
     * vertices stay shared.
     *
     * @param place an array with the centre at 0-2 and the rotation at 6-14, counted from {@code at}
     */
    public double placed(int vertex, int axis, double[] place, int at) {
        int row = at + 6 + 3 * axis;
        int v = 3 * vertex;
        return place[row] * coordinates[v]
                + place[row + 1] * coordinates[v + 1]
                + place[row + 2] * coordinates[v + 2]
                + place[at + axis];
    }

    /** The tree over the triangles' boxes in the mesh's own frame, built on first use. */
    public BoxTree tree() {
        BoxTree built = tree;
        if (built == null) {
            synchronized (this) {
                built = tree;
                if (built == null) {
                    built = new BoxTree(boxes());
                    leafCorners = leafCorners(built);
                    tree = built;
                }
            }
        }
        return built;
    }

    /** The tree for rays, built on first use. */
    public WideTree wide() {
        WideTree built = wide;
        if (built == null) {
            synchronized (this) {
                built = wide;
                if (built == null) {
                    built = new WideTree(tree());
                    wide = built;
                }
            }
        }
        return built;
    }

    /**
     * The corners of all triangles in the mesh's own frame, nine coordinates each, in the order of the leaves of {@link
     * #tree()}, which must have been called before. This is the internal array: read only.
     */
    public double[] leafCorners() {
        return leafCorners;
    }

    /**
     * Writes the corners of a placed triangle, given its index in the order of the leaves: the same numbers as {@link
     * #placed}.
     */
    public void placedAt(int leafPlace, double[] place, int at, double[] out, int to) {
        for (int k = 0; k < 9; k += 3) {
            double x = leafCorners[9 * leafPlace + k];
            double y = leafCorners[9 * leafPlace + k + 1];
            double z = leafCorners[9 * leafPlace + k + 2];
            out[to + k] = place[at + 6] * x + place[at + 7] * y + place[at + 8] * z + place[at];
            out[to + k + 1] = place[at + 9] * x + place[at + 10] * y + place[at + 11] * z + place[at + 1];
            out[to + k + 2] = place[at + 12] * x + place[at + 13] * y + place[at + 14] * z + place[at + 2];
        }
    }

    private double[] leafCorners(BoxTree built) {
        double[] places = new double[9 * size()];
        for (int k = 0; k < size(); k++) {
            int t = built.item(k);
            for (int corner = 0; corner < 3; corner++) {
                System.arraycopy(coordinates, 3 * vertex(t, corner), places, 9 * k + 3 * corner, 3);
            }
        }
        return places;
    }

    private double[] boxes() {
        double[] boxes = new double[6 * size()];
        for (int t = 0; t < size(); t++) {
            for (int axis = 0; axis < 3; axis++) {
                double a = coordinate(vertex(t, 0), axis);
                double b = coordinate(vertex(t, 1), axis);
                double c = coordinate(vertex(t, 2), axis);
                boxes[6 * t + axis] = Math.min(a, Math.min(b, c));
                boxes[6 * t + 3 + axis] = Math.max(a, Math.max(b, c));
            }
        }
        return boxes;
    }

    /** One vertex of each connected part of the surface, in ascending order. */
    public synchronized int[] seeds() {
        if (seeds == null) {
            seeds = findSeeds();
        }
        return seeds.clone();
    }

    private int[] findSeeds() {
        int[] joined = joinEqual();
        int[] parent = new int[vertices()];
        Arrays.setAll(parent, v -> v);
        for (int t = 0; t < size(); t++) {
            int a = root(parent, joined[vertex(t, 0)]);
            int b = root(parent, joined[vertex(t, 1)]);
            parent[Math.max(a, b)] = Math.min(a, b);
            int c = root(parent, joined[vertex(t, 2)]);
            int ab = Math.min(a, b);
            parent[Math.max(ab, c)] = Math.min(ab, c);
        }
        return Arrays.stream(corners)
                .map(v -> root(parent, joined[v]))
                .sorted()
                .distinct()
                .toArray();
    }

    private static int root(int[] parent, int v) {
        int r = v;
        while (parent[r] != r) {
            parent[r] = parent[parent[r]];
            r = parent[r];
        }
        return r;
    }

    /**
     * For each vertex the first one at the same point. Found by sorting, so that no choice of coordinates makes it
     * slow.
     */
    public int[] joinEqual() {
        Integer[] sorted = new Integer[vertices()];
        Arrays.setAll(sorted, v -> v);
        Arrays.sort(sorted, (v, w) -> {
            int order = comparePlaces(v, w);
            return order != 0 ? order : Integer.compare(v, w);
        });
        int[] joined = new int[vertices()];
        for (int k = 0; k < sorted.length; k++) {
            int v = sorted[k];
            boolean same = k > 0 && comparePlaces(sorted[k - 1], v) == 0;
            joined[v] = same ? joined[sorted[k - 1]] : v;
        }
        return joined;
    }

    private int comparePlaces(int v, int w) {
        for (int axis = 0; axis < 3; axis++) {
            int order = Double.compare(coordinate(v, axis), coordinate(w, axis));
            if (order != 0) {
                return order;
            }
        }
        return 0;
    }

    /** An edge that an odd number of triangles use, as text for people; null if the surface is closed. */
    public @Nullable String openEdge() {
        int[] joined = joinEqual();
        Map<Long, Integer> uses = new HashMap<>();
        for (int t = 0; t < size(); t++) {
            for (int k = 0; k < 3; k++) {
                int a = joined[vertex(t, k)];
                int b = joined[vertex(t, (k + 1) % 3)];
                if (a != b) {
                    uses.merge(((long) Math.min(a, b) << 32) | Math.max(a, b), 1, Integer::sum);
                }
            }
        }
        return uses.entrySet().stream()
                .filter(use -> use.getValue() % 2 != 0)
                .min(Map.Entry.comparingByKey())
                .map(use -> "the edge of vertices " + (use.getKey() >> 32) + " and " + (use.getKey() & 0xffffffffL)
                        + " is used " + use.getValue() + (use.getValue() == 1 ? " time" : " times"))
                .orElse(null);
    }

    @Override
    public boolean equals(Object other) {
        return this == other
                || (other instanceof TriangleMesh that
                        && Objects.equals(texture, that.texture)
                        && Arrays.equals(coordinates, that.coordinates)
                        && Arrays.deepEquals(faces, that.faces));
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(coordinates) + Arrays.deepHashCode(faces);
    }
}
