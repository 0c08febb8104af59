package robosim.geometry.material;

import java.util.Arrays;
import robosim.geometry.check.Checks;

/**
 * Where the corners of a mesh's faces lie in a picture: points (u, v) of the picture, whose left lower corner is (0, 0) and
 * whose right upper corner is (1, 1), and for each corner of each face one of these points. No query about geometry looks at
 * it.
 *
 * <pre>{@code
 * List<Point> corners = List.of(new Point(0, 0, 0), new Point(2, 0, 0), new Point(2, 1, 0), new Point(0, 1, 0));
 * MeshObject poster = new MeshObject(corners, new int[][] {{0, 1, 2, 3}})
 *         .withTextureCoordinates(new TextureCoordinates(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, new int[] {0, 1, 2, 3}));
 * poster.triangles().isTextured(1);              // true
 * poster.triangles().textured(1, 2, 1);          // 1
 * }</pre>
 */
public final class TextureCoordinates {
    /** The index of a corner without a point; the picture is not on its face then. */
    public static final int NONE = -1;

    private final double[] points;
    private final int[] corners;

    /**
     * Points and their use.
     *
     * @param points  u and v of each point; numbers below 0 and above 1 are legal, as the picture repeats
     * @param corners for each corner of each face, in their order, the index of its point, or {@link #NONE}
     */
    public TextureCoordinates(double[] points, int[] corners) {
        this.points = Checks.present("points", points).clone();
        this.corners = Checks.present("corners", corners).clone();
        if (points.length % 2 != 0) {
            throw new IllegalArgumentException(
                    "points must have two numbers each (got: " + points.length + " numbers)");
        }
        for (int k = 0; k < points.length; k++) {
            this.points[k] = Checks.coordinate("points[" + k / 2 + "]." + "uv".charAt(k % 2), points[k]);
        }
        int count = points.length / 2;
        for (int k = 0; k < corners.length; k++) {
            if (corners[k] < NONE || corners[k] >= count) {
                throw new IllegalArgumentException("corners[" + k + "] must be -1 or one of the " + count
                        + " points, counted from 0 (got: " + corners[k] + ")");
            }
        }
    }

    /** u and v of each point; a fresh array. */
    public double[] points() {
        return points.clone();
    }

    /** For each corner of each face the index of its point, or {@link #NONE}; a fresh array. */
    public int[] corners() {
        return corners.clone();
    }

    /** One of the two numbers of a point: axis 0 to the right, 1 up. */
    public double coordinate(int point, int axis) {
        return points[2 * point + axis];
    }

    /**
     * By triangle three indices of points; the first is {@link #NONE} where one of the three is.
     *
     * @param faces     the mesh's, with three or four indices each
     * @param triangles how many there are when those of four are cut in two
     */
    public int[] ofTriangles(int[][] faces, int triangles) {
        int[] found = new int[3 * triangles];
        int at = 0;
        int t = 0;
        for (int[] face : faces) {
            if (at + face.length > corners.length) {
                throw wrongCount(faces);
            }
            for (int k = 2; k < face.length; k++, t++) {
                int first = corners[at];
                int second = corners[at + k - 1];
                int third = corners[at + k];
                found[3 * t] = second == NONE || third == NONE ? NONE : first;
                found[3 * t + 1] = second;
                found[3 * t + 2] = third;
            }
            at += face.length;
        }
        if (at != corners.length) {
            throw wrongCount(faces);
        }
        return found;
    }

    private IllegalArgumentException wrongCount(int[][] faces) {
        return new IllegalArgumentException("corners must have one index for each corner of the "
                + faces.length + " faces, "
                + Arrays.stream(faces).mapToLong(face -> face.length).sum() + " (got: "
                + corners.length + ")");
    }

    @Override
    public boolean equals(Object other) {
        return this == other
                || (other instanceof TextureCoordinates that
                        && Arrays.equals(points, that.points)
                        && Arrays.equals(corners, that.corners));
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(points) + Arrays.hashCode(corners);
    }

    @Override
    public String toString() {
        return points.length / 2 + " points of a picture for " + corners.length + " corners";
    }
}
