package robosim.geometry.viewer.window;

import org.jspecify.annotations.Nullable;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.space.Picture;
import robosim.geometry.viewer.space.SpaceView;

/**
 * A moveable object that a hand has taken hold of in a picture in three dimensions: the point of it that was touched stays
 * under the hand, at its height.
 */
final class FloorHand {
    /** Farther away than this many times the distance of the point touched, a place near the horizon is not meant. */
    private static final double FARTHEST = 20;

    final String robot;
    private final double height;
    private final double offsetX;
    private final double offsetZ;
    private final double farthest;

    private FloorHand(GeometryObject object, String robot, Point touched, Point eye) {
        this.robot = robot;
        this.height = touched.y();
        this.offsetX = object.center().x() - touched.x();
        this.offsetZ = object.center().z() - touched.z();
        double dx = touched.x() - eye.x();
        double dy = touched.y() - eye.y();
        double dz = touched.z() - eye.z();
        this.farthest = FARTHEST * Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** A hand on what is seen; null unless that can be moved. */
    static @Nullable FloorHand on(Picture.@Nullable Seen seen, Point eye) {
        GeometryObject object = seen == null ? null : seen.object();
        Point point = seen == null ? null : seen.point();
        String name = object == null || !object.isMoveable() ? null : object.name();
        return name == null || object == null || point == null ? null : new FloorHand(object, name, point, eye);
    }

    /**
     * Where the object's centre is to go, by its X and Z, for the touched point to be seen at a point of the view; null
     * where the view shows no place at its height.
     */
    double @Nullable [] place(SpaceView view, double x, double y) {
        Point eye = view.pose().center();
        Point way = view.direction(x, y);
        double far = (height - eye.y()) / way.y();
        if (!(far > 0 && far < farthest)) { // written so that NaN fails it
            return null;
        }
        return new double[] {eye.x() + far * way.x() + offsetX, eye.z() + far * way.z() + offsetZ};
    }
}
