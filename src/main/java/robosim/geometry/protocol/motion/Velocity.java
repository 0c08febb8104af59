package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * A velocity along the own axes of a body.
 *
 * @param x  m/s forward
 * @param y  m/s up
 * @param z  m/s to the right
 * @param ry <b>radians</b> a second about the own Y, counter-clockwise seen from above
 */
public record Velocity(double x, double y, double z, double ry) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses numbers that are not finite. */
    public Velocity {
        x = finite("x", x);
        y = finite("y", y);
        z = finite("z", z);
        ry = finite("ry", ry);
    }

    /** A velocity as it is sent. */
    public static Velocity of(Twist velocity) {
        return new Velocity(velocity.x(), velocity.y(), velocity.z(), Degrees.toRadians(velocity.ry()));
    }

    /** The velocity in metres and degrees a second. */
    public Twist twist() {
        return new Twist(x, y, z, Degrees.toDegrees(ry));
    }

    private static double finite(String argument, double value) {
        if (!(Math.abs(value) <= 0x1p100)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }
}
