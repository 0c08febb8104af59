package robosim.geometry.viewer.space;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Rotations;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * A picture to be taken.
 *
 * @param view    from where; of a camera that something carries, in the own frame of that
 * @param carrier the name of the moveable object that carries the camera and is not in the picture; null for none
 */
public record Shot(SpaceView view, @Nullable String carrier) {
    public Shot {
        Checks.present("view", view);
    }

    /** The view in the world; null where the carrier is no more. */
    @Nullable
    SpaceView at(Moment moment) {
        if (carrier == null) {
            return view;
        }
        GeometryObject object = moment.mover(carrier);
        return object == null
                ? null
                : new SpaceView(placed(view.pose(), object.pose()), view.fieldOfView(), view.width(), view.height());
    }

    private static Pose placed(Pose inner, Pose frame) {
        double[] r = frame.rotation();
        double[] product = new double[9];
        Rotations.multiply(r, 0, inner.rotation(), 0, product, 0);
        Point c = inner.center();
        Point f = frame.center();
        Point at = new Point(
                f.x() + r[0] * c.x() + r[1] * c.y() + r[2] * c.z(),
                f.y() + r[3] * c.x() + r[4] * c.y() + r[5] * c.z(),
                f.z() + r[6] * c.x() + r[7] * c.y() + r[8] * c.z());
        return Pose.of(at, 0).oriented(product);
    }
}
