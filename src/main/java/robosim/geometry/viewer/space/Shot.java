package robosim.geometry.viewer.space;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.GeometryObject;

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
                : new SpaceView(view.pose().within(object.pose()), view.fieldOfView(), view.width(), view.height());
    }
}
