package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;

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

    private static double finite(String argument, double value) {
        if (!(Math.abs(value) <= 0x1p100)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }
}
