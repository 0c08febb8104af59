package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.List;
import robosim.geometry.check.Checks;

/**
 * A request for the distances along all beams of a sensor, on an object or at a place of the world, and for what else a
 * frame has: the objects that are seen, their labels, and normals; answered by a {@link SenseAnswer}.
 *
 * @param objectName  the name of the moveable object that carries the sensor; empty for one that nothing carries
 * @param mount       where on the object the sensor is, and which way it faces; in the world if nothing carries it
 * @param pattern     its beams
 * @param min         blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
 * @param max         range, world units, {@code min <= max}; may be infinite
 * @param width       full opening angle of each beam in radians, from 0 (a ray) up to, not including, pi
 * @param seesCarrier whether the object that carries the sensor echoes like any other
 * @param normals     whether the answer has the normals of the surfaces too, for rays only
 * @param objects     whether the answer has the objects that are seen too, and the labels of their materials, for rays only
 * @param motion      how the object moves meanwhile; null stands for {@link ScanMotion#NONE}
 * @param rep117      whether an echo nearer than {@code min} is reported as {@code -Infinity}, as REP 117 of ROS has it
 * @param ignored     names of objects that do not echo, or of layers of which none does; null stands for none
 */
public record SenseRequest(
        String objectName,
        Mount mount,
        BeamPattern pattern,
        double min,
        double max,
        double width,
        boolean seesCarrier,
        boolean normals,
        boolean objects,
        ScanMotion motion,
        boolean rep117,
        List<String> ignored)
        implements BatchRequest {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, numbers that are NaN or out of range, and normals or objects for beams that are not rays. */
    public SenseRequest {
        motion = motion == null ? ScanMotion.NONE : motion; // as in messages of before
        ignored = MeasureRequest.names(ignored == null ? List.of() : ignored);
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
        if (objects && width > 0) {
            throw new IllegalArgumentException(
                    "width must be 0 for objects, whose parts cones have not (got: " + width + ")");
        }
        if (seesCarrier && !motion.equals(ScanMotion.NONE)) {
            throw new IllegalArgumentException(
                    "seesCarrier must be false where the object moves during the scan (got: true)");
        }
    }

    /** A sensor of rays at the object's centre, facing forward, without an end: distances alone. */
    public SenseRequest(String objectName, BeamPattern pattern) {
        this(
                objectName,
                Mount.CENTER,
                pattern,
                0,
                Double.POSITIVE_INFINITY,
                0,
                false,
                false,
                false,
                ScanMotion.NONE,
                false,
                List.of());
    }

    /** The same, which reports an echo nearer than its blind range as {@code -Infinity}. */
    public SenseRequest asRep117() {
        return new SenseRequest(
                objectName, mount, pattern, min, max, width, seesCarrier, normals, objects, motion, true, ignored);
    }

    /** The same without some objects, or all of some layers. */
    public SenseRequest ignoring(List<String> names) {
        return new SenseRequest(
                objectName, mount, pattern, min, max, width, seesCarrier, normals, objects, motion, rep117, names);
    }

    /** Whether an object carries the sensor. */
    public boolean isCarried() {
        return !objectName.isEmpty();
    }

    @Override
    public boolean isAboutMover() {
        return isCarried();
    }

    @Override
    public int size() {
        return pattern.size();
    }
}
