package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.model.Twist;

/**
 * How the object that carries a sensor moves while the beams are fired, the columns of the pattern one after the other: see
 * {@link robosim.geometry.model.SenseOptions#withMotion}. At the first column it is where it stands in the world.
 *
 * @param duration seconds from the first column to the first one of the next scan
 * @param x        world units a second forward, in the object's own frame
 * @param y        world units a second up
 * @param z        world units a second to the right
 * @param ry       radians a second about its own Y, counter-clockwise seen from above
 */
public record ScanMotion(double duration, double x, double y, double z, double ry) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** All beams at once. */
    public static final ScanMotion NONE = new ScanMotion(0, 0, 0, 0, 0);

    /** Refuses numbers that are NaN or out of range. */
    public ScanMotion {
        if (!(duration >= 0 && duration <= Checks.LIMIT)) {
            throw new IllegalArgumentException("duration must be from 0 to 2^100 seconds (got: " + duration + ")");
        }
        Checks.coordinate("x", x);
        Checks.coordinate("y", y);
        Checks.coordinate("z", z);
        Checks.radians("ry", ry);
    }

    /**
     * The velocity, in degrees a second.
     *
     * @param degrees the same as {@link #ry}
     */
    public Twist twist(double degrees) {
        return new Twist(x, y, z, degrees);
    }
}
