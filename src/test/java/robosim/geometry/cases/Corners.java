package robosim.geometry.cases;

import java.util.List;
import robosim.geometry.Geometry;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;

/** The corners of two triangles in all orders. */
final class Corners {
    private static final int[][] ORDERS = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

    private Corners() {}

    /** Whether two triangles get one verdict in all 36 orders of their corners; true of anything else. */
    static boolean allOrders(GeometryObject a, GeometryObject b, Dimension dimension, boolean verdict) {
        if (!isTriangle(a) || !isTriangle(b)) {
            return true;
        }
        for (int[] first : ORDERS) {
            for (int[] second : ORDERS) {
                GeometryObject one = ordered((MeshObject) a, first);
                GeometryObject other = ordered((MeshObject) b, second);
                Geometry world = Trial.world(dimension, List.of(one, other), 0);
                world.addObjectUnchecked(one);
                if (world.testObject(other) != verdict) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean isTriangle(GeometryObject object) {
        return object instanceof MeshObject mesh && mesh.vertices().size() == 3 && mesh.faces().length == 1;
    }

    private static MeshObject ordered(MeshObject triangle, int[] order) {
        List<Point> v = triangle.vertices();
        MeshObject ordered =
                new MeshObject(List.of(v.get(order[0]), v.get(order[1]), v.get(order[2])), new int[][] {{0, 1, 2}});
        return ordered.at(triangle.pose());
    }
}
