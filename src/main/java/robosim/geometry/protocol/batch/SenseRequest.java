package robosim.geometry.protocol.batch;

import java.io.Serial;
import robosim.geometry.exact.Checks;

/**
 * A request for the distances along all beams of a sensor that an object carries; answered by a {@link SenseAnswer}.
 *
 * @param objectName  the name of a moveable object
 * @param mount       where on the object the sensor is, and which way it faces
 * @param pattern     its beams
 * @param min         blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
 * @param max         range, world units, {@code min <= max}; may be infinite
 * @param width       full opening angle of each beam in radians, from 0 (a ray) up to, not including, pi
 * @param seesCarrier whether the object that carries the sensor echoes like any other
 * @param normals     whether the answer has the normals of the surfaces too, for rays only
 */
public record SenseRequest(
        String objectName,
        Mount mount,
        BeamPattern pattern,
        double min,
        double max,
        double width,
        boolean seesCarrier,
        boolean normals)
        implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, numbers that are NaN or out of range, and normals for beams that are not rays. */
    public SenseRequest {
        Checks.present("objectName", objectName);
        Checks.present("mount", mount);
        Checks.present("pattern", pattern);
        Checks.range(min, max);
        if (!(width >= 0 && width < Math.PI)) {
            throw new IllegalArgumentException(
                    "width must be an angle in radians from 0 up to, not including, pi (got: " + width + ")");
        }
        if (normals && width > 0) {
            throw new IllegalArgumentException(
                    "width must be 0 for normals, which cones have not (got: " + width + ")");
        }
    }

    /** A sensor of rays at the object's centre, facing forward, without an end: distances alone. */
    public SenseRequest(String objectName, BeamPattern pattern) {
        this(objectName, Mount.CENTER, pattern, 0, Double.POSITIVE_INFINITY, 0, false, false);
    }

    @Override
    public int size() {
        return pattern.size();
    }
}
