package robosim.geometry;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/**
 * Slivers along the two families of straight lines on the surface y = x z: each of one family is close to each of the other, so
 * that all pairs of two such meshes must be looked at, and none touches.
 */
public final class Rulings {
    private Rulings() {}

    /** A world of two such meshes, of which one, "m", is a thousandth above the other. */
    public static Geometry world(int slivers) {
        Geometry world = new Geometry(10, 10, 10);
        world.addObjectUnchecked(mesh(slivers, true, 0));
        world.addObjectUnchecked(mesh(slivers, false, 1e-3).moveable("m"));
        return world;
    }

    /** The slivers along one family of lines. */
    public static MeshObject mesh(int slivers, boolean isFirst, double lift) {
        List<Point> vertices = new ArrayList<>();
        int[][] faces = new int[slivers][];
        for (int i = 0; i < slivers; i++) {
            double across = -1 + 2.0 * i / (slivers - 1);
            for (int k = 0; k < 3; k++) {
                double along = k == 0 ? -1 : 1;
                double beside = k == 2 ? across + 0.2 / slivers : across;
                double x = isFirst ? beside : along;
                double z = isFirst ? along : beside;
                vertices.add(new Point(x, x * z + lift, z));
            }
            faces[i] = new int[] {3 * i, 3 * i + 1, 3 * i + 2};
        }
        return new MeshObject(vertices, faces);
    }
}
