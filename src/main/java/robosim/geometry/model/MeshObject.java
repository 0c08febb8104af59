package robosim.geometry.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.ConvexHull;
import robosim.geometry.index.meshes.TriangleMesh;
import robosim.geometry.material.TextureCoordinates;

/**
 * A surface of triangles and quads; a quad is always the two triangles on its diagonal 0-2, even if its corners are not
 * in one plane.
 *
 * <p>Vertices are given in the mesh's own frame, whose origin is its centre: (0, 0, 0) until it is moved. All
 * placements of one mesh share its triangles and their tree. Degenerate faces are legal: each counts as the segment or
 * point that it degenerates to.
 *
 * <pre>{@code
 * List<Point> corners = List.of(new Point(0, 0, 0), new Point(2, 0, 0), new Point(0, 2, 0), new Point(0, 0, 2));
 * int[][] faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
 * MeshObject shell = new MeshObject(corners, faces);
 * MeshObject block = shell.solid();                            // closed, so that its inside counts too
 * SphereObject inside = new SphereObject(new Point(0.4, 0.4, 0.4), 0.1);
 * CollisionDetection.intersects(shell, inside);                // false: a surface is hollow
 * CollisionDetection.intersects(block, inside);                // true
 * }</pre>
 */
public final class MeshObject extends PlacedObject<MeshObject> implements GeometryObject {
    private static final long serialVersionUID = 1;

    /** A terrain of 4,096 x 4,096 heights, which takes some 6 GB. */
    private static final int MOST_HEIGHTS = 1 << 24;

    private final transient TriangleMesh triangles;
    private final transient boolean solid;
    private final transient @Nullable GeometryObject boundingVolume;

    /**
     * A surface, bounded by the box of its vertices.
     *
     * @param vertices corners in the mesh's own frame
     * @param faces    3 or 4 indices of vertices each; at least one face
     */
    public MeshObject(List<Point> vertices, int[][] faces) {
        this(Tag.NONE, Pose.ORIGIN, new TriangleMesh(flat(vertices), copy(faces)), false, null);
    }

    /**
     * A surface with a bounding volume, which is tested first and can only rule out contact.
     *
     * @param boundingVolume a box, cylinder or sphere in the own frame that encloses every face
     * @throws IllegalArgumentException if it does not, since collisions would be missed
     */
    public MeshObject(List<Point> vertices, int[][] faces, GeometryObject boundingVolume) {
        this(
                Tag.NONE,
                Pose.ORIGIN,
                new TriangleMesh(flat(vertices), copy(faces)),
                false,
                Checks.present("boundingVolume", boundingVolume));
        Enclosing.check(boundingVolume, this);
    }

    MeshObject(
            Tag tag, Pose pose, TriangleMesh triangles, boolean solid, @Nullable GeometryObject checkedBoundingVolume) {
        super(tag, pose, null);
        this.triangles = triangles;
        this.solid = solid;
        this.boundingVolume = checkedBoundingVolume;
    }

    private static double[] flat(List<Point> vertices) {
        double[] coordinates =
                new double[3 * Checks.present("vertices", vertices).size()];
        int k = 0;
        for (Point vertex : vertices) {
            Checks.present("vertices[" + k / 3 + "]", vertex);
            coordinates[k++] = vertex.x();
            coordinates[k++] = vertex.y();
            coordinates[k++] = vertex.z();
        }
        return coordinates;
    }

    static int[][] copy(int[][] faces) {
        return Arrays.stream(Checks.present("faces", faces))
                .map(face -> face == null ? null : face.clone())
                .toArray(int[][]::new);
    }

    /**
     * The convex hull of points: the solid that they span, a closed surface of triangles that are counter-clockwise seen from
     * outside. It is decided without rounding, so that it holds every point. Its corners are among the points. The hull of points
     * in one plane, on one line or all at one place is flat, a segment or a point.
     *
     * <pre>{@code
     * MeshObject wedge = MeshObject.hull(List.of(new Point(0, 0, 0), new Point(2, 0, 0), new Point(0, 2, 0),
     *         new Point(0, 0, 2), new Point(0.5, 0.5, 0.5)));
     * wedge.faces().length;                                            // 4: the last point is inside
     * }</pre>
     *
     * @param points in the mesh's own frame; at least one
     */
    public static MeshObject hull(List<Point> points) {
        double[] coordinates = flat(points);
        if (coordinates.length == 0) {
            throw new IllegalArgumentException("points must hold at least one point (got: none)");
        }
        return new MeshObject(Tag.NONE, Pose.ORIGIN, hull(coordinates), true, null);
    }

    /**
     * A terrain: the surface over a level grid of points, each of which has a height. Its own frame has its origin in the middle
     * of the grid, at height 0; columns go along its own X, rows along its own Z. Each cell is a quad on the diagonal from its
     * least corner to its greatest, counter-clockwise seen from above. Neighbours share corners to the bit, so nothing slips
     * through between them. What is below the surface is free.
     *
     * <pre>{@code
     * MeshObject ramp = MeshObject.heightfield(0.5, 3, 2, 0, 0, 1, 0, 0, 1);
     * ramp.faces().length;                                                     // 2
     * CollisionDetection.rayDistance(new Ray(new Point(0.25, 2, 0), new Point(0, -1, 0)), ramp); // 1.5
     * }</pre>
     *
     * <p>It is a mesh like any other, and takes as much memory: some 350 bytes for each height once its world has been asked.
     *
     * @param cell    world units from a point to the next; above 0
     * @param columns points along X; at least 2
     * @param rows    points along Z; at least 2. There are at most 2<sup>24</sup> points
     * @param heights world units, row by row, beginning with the least Z: that in column i and row j is {@code j * columns + i}
     */
    public static MeshObject heightfield(double cell, int columns, int rows, double... heights) {
        if (!(cell > 0)) {
            throw new IllegalArgumentException("cell must be above 0 (got: " + cell + ")");
        }
        if (columns < 2 || rows < 2 || (long) columns * rows > MOST_HEIGHTS) {
            throw new IllegalArgumentException("columns and rows must be at least 2, and their product at most "
                    + MOST_HEIGHTS + "; take every other height, or several terrains (got: " + columns + " x " + rows
                    + ")");
        }
        if (Checks.present("heights", heights).length != columns * rows) {
            throw new IllegalArgumentException("heights must be " + columns + " * " + rows + " = " + columns * rows
                    + " numbers (got: " + heights.length + ")");
        }
        double[] coordinates = new double[3 * heights.length];
        for (int k = 0; k < heights.length; k++) {
            int row = k / columns;
            coordinates[3 * k] = cell * (k % columns - 0.5 * (columns - 1));
            coordinates[3 * k + 1] = Checks.coordinate("heights[" + k + "]", heights[k]);
            coordinates[3 * k + 2] = cell * (row - 0.5 * (rows - 1));
        }
        int[][] faces = new int[(columns - 1) * (rows - 1)][];
        for (int f = 0; f < faces.length; f++) {
            int corner = f / (columns - 1) * columns + f % (columns - 1);
            faces[f] = new int[] {corner, corner + columns, corner + columns + 1, corner + 1};
        }
        return new MeshObject(Tag.NONE, Pose.ORIGIN, new TriangleMesh(coordinates, faces), false, null);
    }

    /** The convex hull of this mesh, where it stands and under its name. */
    public MeshObject hull() {
        double[] corners = new double[9 * triangles.size()];
        for (int k = 0; k < corners.length; k++) {
            corners[k] = triangles.coordinate(triangles.vertex(k / 9, k / 3 % 3), k % 3);
        }
        return new MeshObject(tag, pose, hull(corners), true, null);
    }

    /** The hull of points with no vertices but those of its faces, in the order given. */
    private static TriangleMesh hull(double[] coordinates) {
        int[][] faces = ConvexHull.of(coordinates);
        int[] used = Arrays.stream(faces)
                .flatMapToInt(Arrays::stream)
                .sorted()
                .distinct()
                .toArray();
        for (int[] face : faces) {
            Arrays.setAll(face, k -> Arrays.binarySearch(used, face[k]));
        }
        double[] kept = new double[3 * used.length];
        for (int k = 0; k < used.length; k++) {
            System.arraycopy(coordinates, 3 * used[k], kept, 3 * k, 3);
        }
        return new TriangleMesh(kept, faces);
    }

    /** This mesh with a bounding volume in its own frame, or with the default if null. */
    MeshObject bounded(@Nullable GeometryObject volume) {
        MeshObject bounded = new MeshObject(tag, pose, triangles, solid, volume);
        if (volume != null) {
            Enclosing.check(volume, bounded);
        }
        return bounded;
    }

    @Override
    MeshObject with(Tag newTag, Pose newPose) {
        return new MeshObject(newTag, newPose, triangles, solid, boundingVolume);
    }

    /**
     * This mesh as a solid: a point is inside if a ray from it crosses the surface an odd number of times.
     *
     * @throws IllegalArgumentException if the surface is not closed, that is, if an edge is used by an odd number of
     *     triangles after equal corners are joined
     */
    public MeshObject solid() {
        String open = triangles.openEdge();
        if (open != null) {
            throw new IllegalArgumentException(
                    "a solid mesh must be closed: close the surface or use it as a surface (got: " + open + ")");
        }
        return new MeshObject(tag, pose, triangles, true, boundingVolume);
    }

    /**
     * This mesh with places of its faces' corners in a picture, or without if null. It shares its corners and faces with this
     * one, but not the trees over them.
     *
     * @throws IllegalArgumentException if they are not of as many corners as this mesh's faces have
     */
    public MeshObject withTextureCoordinates(@Nullable TextureCoordinates coordinates) {
        return new MeshObject(tag, pose, triangles.with(coordinates), solid, boundingVolume);
    }

    /** Where the faces' corners lie in a picture; null if that was not given. */
    public @Nullable TextureCoordinates textureCoordinates() {
        return triangles.texture();
    }

    @Override
    public Kind kind() {
        return Kind.MESH;
    }

    /** Whether the inside counts too. */
    public boolean isSolid() {
        return solid;
    }

    /** The vertices in the own frame. */
    public List<Point> vertices() {
        List<Point> vertices = new ArrayList<>(triangles.vertices());
        for (int v = 0; v < triangles.vertices(); v++) {
            vertices.add(new Point(triangles.coordinate(v, 0), triangles.coordinate(v, 1), triangles.coordinate(v, 2)));
        }
        return List.copyOf(vertices);
    }

    /** The faces as given; a fresh array. */
    public int[][] faces() {
        return triangles.faces();
    }

    /**
     * The triangles that the faces are made of, shared by all placements: for the other packages of this module.
     *
     * @hidden
     */
    @SuppressWarnings({"exports", "InvalidBlockTag"}) // users of the module cannot see the type
    public TriangleMesh triangles() {
        return triangles;
    }

    /**
     * The bounding volume that was given, in the mesh's own frame; null if the default, the box of the vertices, is
     * used.
     */
    public @Nullable GeometryObject boundingVolume() {
        return boundingVolume;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof MeshObject that
                && solid == that.solid
                && tag.equals(that.tag)
                && pose.equals(that.pose)
                && Objects.equals(boundingVolume, that.boundingVolume)
                && triangles.equals(that.triangles);
    }

    @Override
    public int hashCode() {
        return 31 * Objects.hash(tag, pose) + triangles.hashCode();
    }

    @Override
    public String toString() {
        return (solid ? "solid mesh" : "mesh") + tag.text(pose) + ", " + triangles.vertices() + " vertices, "
                + triangles.size() + " triangles";
    }
}
