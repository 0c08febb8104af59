package robosim.geometry.protocol;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * A move of one object: a straight translation along its own axes, then in place a turn about its own Y, then about its
 * own X. An answer repeats the request bit for bit.
 *
 * @param objectName the name of a moveable object
 * @param x          world units forward
 * @param y          world units up
 * @param z          world units to the right of forward
 * @param rx         <b>radians</b> about the own X, after the turn by {@code ry}
 * @param ry         <b>radians</b> about the own Y
 */
public record MoveRequest(String objectName, double x, double y, double z, double rx, double ry)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a name that is null and numbers that are NaN or beyond 2<sup>100</sup>. */
    public MoveRequest {
        Checks.present("objectName", objectName);
        Checks.coordinate("x", x);
        Checks.coordinate("y", y);
        Checks.coordinate("z", z);
        Checks.radians("rx", rx);
        Checks.radians("ry", ry);
    }
}
