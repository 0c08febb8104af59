package robosim.geometry.model;

import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * A half line.
 *
 * @param start     where it begins, a point of the ray
 * @param direction where it goes; of any length except zero; the length has no effect on distances
 */
public record Ray(Point start, Point direction) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Refuses a direction of length zero. */
    public Ray {
        Checks.present("start", start);
        Checks.present("direction", direction);
        if (direction.x() == 0 && direction.y() == 0 && direction.z() == 0) {
            throw new IllegalArgumentException("direction must not be zero (got: " + direction + ")");
        }
    }
}
