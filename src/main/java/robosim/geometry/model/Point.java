package robosim.geometry.model;

import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * A place, or a displacement, in the world.
 *
 * @param x world units, at most 2<sup>100</sup> in magnitude
 * @param y world units, upwards
 * @param z world units
 */
public record Point(double x, double y, double z) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Refuses what is NaN, infinite or beyond 2<sup>100</sup>; makes -0.0 into +0.0. */
    public Point {
        x = Checks.coordinate("x", x);
        y = Checks.coordinate("y", y);
        z = Checks.coordinate("z", z);
    }

    /** The origin. */
    public Point() {
        this(0, 0, 0);
    }
}
