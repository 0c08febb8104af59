package robosim.geometry.protocol;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * Range and width of a sonar.
 *
 * @param min   blind range, world units; a nearer echo is reported as {@code min} and still hides what is behind it
 * @param max   range, world units, {@code min <= max}; may be infinite
 * @param width full opening angle in <b>radians</b>, from 0 (a line) up to, not including, pi
 */
public record Beam(double min, double max, double width) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** RoboSim's beam: a line without an end. */
    public static final Beam LINE = new Beam(0, Double.POSITIVE_INFINITY, 0);

    /** Refuses values that are NaN or out of range. */
    public Beam {
        Checks.size("min", min);
        if (!(max >= min)) {
            throw new IllegalArgumentException("max must be at least min, " + min + " (got: " + max + ")");
        }
        if (!(width >= 0 && width < Math.PI)) {
            throw new IllegalArgumentException(
                    "width must be an angle in radians from 0 up to, not including, pi (got: " + width + ")");
        }
    }
}
