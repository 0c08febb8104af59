package robosim.geometry.protocol;

import java.io.Serial;
import java.io.Serializable;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

/**
 * A request for the distance from the centre of an object in direction {@code (xOffset, 0, zOffset)} of its own frame;
 * the object itself does not echo.
 *
 * @param objectName the name of a moveable object
 * @param xOffset    forward component of the direction, which may have any length
 * @param zOffset    component to the right of forward; not zero together with {@code xOffset}
 * @param beam       range and width; null for the session's default
 */
public record SonarRequest(
        String objectName,
        double xOffset,
        double zOffset,
        @Nullable Beam beam) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses a name that is null, numbers that are NaN or beyond 2<sup>100</sup>, and a direction of zero. */
    public SonarRequest {
        Checks.present("objectName", objectName);
        Checks.coordinate("xOffset", xOffset);
        Checks.coordinate("zOffset", zOffset);
        if (xOffset == 0 && zOffset == 0) {
            throw new IllegalArgumentException(
                    "xOffset and zOffset must not both be zero (got: " + xOffset + ", " + zOffset + ")");
        }
    }

    /** A request with the session's default beam. */
    public SonarRequest(String objectName, double xOffset, double zOffset) {
        this(objectName, xOffset, zOffset, null);
    }
}
