package robosim.geometry.world.shared;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;

/**
 * The floor that an infinite ground plane becomes: a thin box that fills its world, with its top at the height of the plane.
 * Nothing else fills a world that an importer made, since such a world leaves room around its objects.
 */
public final class Floor {
    /** A power of two, so that the top of a floor is exactly where most files have their ground. */
    public static final double THICKNESS = 0.125;

    private Floor() {}

    /** A floor in a world whose size is not known yet: a vertical line below the origin of the plane. */
    public static BoxObject at(double height) {
        return new BoxObject(new Point(0, height - THICKNESS / 2, 0), 0, THICKNESS, 0);
    }

    /** A floor, widened to fill a world. */
    public static BoxObject filling(BoxObject floor, double width, double length) {
        return resized(floor, floor.center().y(), floor.height(), width, length);
    }

    /** Whether an object of a world that an importer made is its floor. */
    public static boolean isFloor(GeometryObject object, double width, double length) {
        if (!(object instanceof BoxObject) || object.isMoveable()) {
            return false;
        }
        Bounds bounds = object.bounds();
        return bounds.width() == width && bounds.length() == length;
    }

    /**
     * A floor where another world includes it.
     *
     * @param up how far it is raised
     * @return as large as that world, and cut off at the lower border; null if it lies below, where nothing can fall
     */
    public static @Nullable BoxObject within(BoxObject floor, double up, double width, double height, double length) {
        double bottom = floor.bounds().minY() + up;
        double top = floor.bounds().maxY() + up;
        if (top <= -height / 2) {
            return null;
        }
        if (bottom >= -height / 2) {
            return resized(floor, floor.center().y() + up, floor.height(), width, length);
        }
        double thickness = top + height / 2;
        return resized(floor, top - thickness / 2, thickness, width, length);
    }

    private static BoxObject resized(BoxObject floor, double y, double thickness, double width, double length) {
        BoxObject box = new BoxObject(new Point(0, y, 0), width, thickness, length).withMaterial(floor.material());
        String name = floor.name();
        return name == null ? box : box.named(name);
    }
}
