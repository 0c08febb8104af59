package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.protocol.batch.Numbers;

/**
 * Where a body is after a step, and how fast it moves.
 *
 * @param objectName its name
 * @param center     where its centre is
 * @param heading    <b>radians</b> from the world's X, counter-clockwise seen from above
 * @param rotation   nine numbers, row by row, whose columns are its own axes in the world, if it does not stand upright; else
 *                   none
 * @param velocity   along its own axes
 */
public record BodyAnswer(String objectName, Point center, double heading, Numbers rotation, Velocity velocity)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, a heading beyond a half turn, and numbers that are not a rotation. */
    public BodyAnswer {
        Checks.present("objectName", objectName);
        Checks.present("center", center);
        if (!(Math.abs(heading) <= Math.PI)) {
            throw new IllegalArgumentException(
                    "heading must be an angle in radians from -pi to pi (got: " + heading + ")");
        }
        heading += 0.0;
        if (Checks.present("rotation", rotation).size() > 0) {
            Pose.ORIGIN.oriented(rotation.values());
        }
        Checks.present("velocity", velocity);
    }

    /** Where it is. */
    public Pose pose() {
        return rotation.size() == 0
                ? Pose.of(center, Degrees.toDegrees(heading))
                : Pose.of(center, 0).oriented(rotation.values());
    }
}
