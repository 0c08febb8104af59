package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * What a robot is told to do from now on; the limits of its drive say how soon it does. A moveable object without a body gets
 * {@link BodyRequest#of one} with the default drive; a body without a drive gets that drive.
 *
 * @param objectName a moveable object
 * @param forward    m/s; of a force, newtons
 * @param right      m/s to the right, 0 for a drive that {@linkplain DriveSettings.Kind#canGoSideways cannot}, for which any
 *                   other number is refused; of a force, newtons
 * @param turn       <b>radians</b> a second, counter-clockwise seen from above; of a car, radians of the front wheels to the
 *                   left; of a force, newton metres
 */
public record DriveCommand(String objectName, double forward, double right, double turn) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, and numbers that are out of range. */
    public DriveCommand {
        Checks.present("objectName", objectName);
        forward = Amounts.finite("forward", forward);
        right = Amounts.finite("right", right);
        turn = Amounts.finite("turn", turn);
    }

    /** A speed and a turn. */
    public DriveCommand(String objectName, double forward, double turn) {
        this(objectName, forward, 0, turn);
    }
}
