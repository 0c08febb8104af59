package robosim.geometry.world.mesh;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** A polygon on the ground that is extruded upward. */
public final class Prism {
    private Prism() {}

    /**
     * A solid mesh.
     *
     * @param corners x and y of each, of which x becomes X and y the opposite of Z; counter-clockwise from above
     * @throws IllegalArgumentException if the polygon crosses itself
     */
    public static MeshObject of(List<double[]> corners, double low, double high) {
        int count = corners.size();
        List<Point> vertices = new ArrayList<>();
        int[] top = new int[count];
        for (int k = 0; k < 2 * count; k++) {
            double[] corner = corners.get(k % count);
            vertices.add(new Point(corner[0], k < count ? low : high, -corner[1]));
            top[k % count] = k;
        }
        List<int[]> faces = new ArrayList<>();
        Polygon.cut(vertices, top, faces);
        int caps = faces.size();
        for (int k = 0; k < caps; k++) {
            int[] face = faces.get(k);
            int[] bottom = new int[face.length];
            for (int corner = 0; corner < face.length; corner++) {
                // From the same corner on, so that a quad keeps its diagonal.
                bottom[corner] = face[(face.length - corner) % face.length] - count;
            }
            faces.add(bottom);
        }
        for (int k = 0; k < count; k++) {
            int next = (k + 1) % count;
            faces.add(new int[] {k, next, count + next, count + k});
        }
        return new MeshObject(vertices, faces.toArray(int[][]::new)).solid();
    }

    /** Twice the area of a polygon; above 0 if it is counter-clockwise. */
    public static double doubleArea(List<double[]> points) {
        double sum = 0;
        double[] first = points.get(0);
        for (int k = 1; k + 1 < points.size(); k++) {
            double[] a = points.get(k);
            double[] b = points.get(k + 1);
            sum += (a[0] - first[0]) * (b[1] - first[1]) - (b[0] - first[0]) * (a[1] - first[1]);
        }
        return sum;
    }
}
