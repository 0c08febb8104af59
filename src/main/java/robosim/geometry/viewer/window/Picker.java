package robosim.geometry.viewer.window;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.viewer.scene.CellArea;
import robosim.geometry.viewer.scene.Footprint;
import robosim.geometry.viewer.scene.Scene;

/** Finds the object at a point of the floor. */
final class Picker {
    private Picker() {}

    /**
     * The topmost object there; moveable ones take precedence over static ones.
     *
     * @param slack world units by which the point may miss an object; an object that is hit takes precedence
     * @return null if there is none
     */
    static @Nullable GeometryObject at(List<Scene.Thing> things, double x, double z, double slack) {
        GeometryObject found = null;
        double best = Double.POSITIVE_INFINITY;
        for (Scene.Thing thing : things) {
            GeometryObject object = thing.object();
            double rank = rank(object.isMoveable(), distance(object, x, z, slack), slack);
            if (rank < best || (rank == best && found != null && isOver(object, found))) {
                found = object;
                best = rank;
            }
        }
        return found;
    }

    /** Whether of two objects at the same place the later one is painted over the earlier. */
    private static boolean isOver(GeometryObject later, GeometryObject earlier) {
        return later.isMoveable() || later.bounds().maxY() >= earlier.bounds().maxY();
    }

    /**
     * The rank of an object, smaller is better: first objects that are hit, then near misses, and in each case moveable
     * objects first.
     */
    private static double rank(boolean moveable, double distance, double slack) {
        if (distance > slack) {
            return Double.POSITIVE_INFINITY;
        }
        return (distance == 0 ? 0 : 2 + distance / slack) + (moveable ? 0 : 1.5);
    }

    /** The distance of a point from an object's projection on the floor; 0 on it. Exact only below {@code limit}. */
    private static double distance(GeometryObject object, double x, double z, double limit) {
        double least = Double.POSITIVE_INFINITY;
        for (Footprint outline : Footprint.of(object)) {
            if (outline instanceof Footprint.Disc disc) {
                least = Math.min(least, Math.max(0, StrictMath.hypot(x - disc.x(), z - disc.z()) - disc.radius()));
            } else if (outline instanceof Footprint.Polygon polygon) {
                least = Math.min(least, distance(polygon.corners(), x, z));
            } else if (outline instanceof CellArea cells) {
                least = Math.min(least, cells.distance(x, z, limit));
            }
            if (least == 0) {
                return 0;
            }
        }
        return least <= limit ? least : Double.POSITIVE_INFINITY;
    }

    /** The distance of a point from a convex polygon of x, z, x, z ..., a segment or a point. */
    private static double distance(double[] corners, double x, double z) {
        int count = corners.length / 2;
        boolean left = false;
        boolean right = false;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < count; k++) {
            double ax = corners[2 * k];
            double az = corners[2 * k + 1];
            int next = (k + 1) % count;
            double dx = corners[2 * next] - ax;
            double dz = corners[2 * next + 1] - az;
            double side = dx * (z - az) - dz * (x - ax);
            left |= side > 0;
            right |= side < 0;
            double square = dx * dx + dz * dz;
            double along = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (z - az) * dz) / square)) : 0;
            least = Math.min(least, StrictMath.hypot(x - ax - along * dx, z - az - along * dz));
        }
        boolean inside = count > 2 && !(left && right);
        return inside ? 0 : least;
    }
}
