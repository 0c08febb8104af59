package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;

/**
 * Where on an object a sensor is, and which way it faces.
 *
 * @param place    in the object's own frame
 * @param rotation nine numbers, row by row, whose columns are the sensor's own axes in the frame of the object
 */
public record Mount(Point place, Numbers rotation) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** At the centre, facing forward. */
    public static final Mount CENTER = new Mount(new Point(), Numbers.of(1, 0, 0, 0, 1, 0, 0, 0, 1));

    /** Refuses null, and numbers that are not a rotation. */
    public Mount {
        Checks.present("place", place);
        Pose.ORIGIN.oriented(Checks.present("rotation", rotation).values());
    }

    /** A sensor that faces forward. */
    public Mount(Point place) {
        this(place, CENTER.rotation());
    }

    /** The same as a pose in the object's own frame. */
    public Pose pose() {
        return Pose.of(place, 0).oriented(rotation.values());
    }
}
