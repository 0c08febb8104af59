package robosim.geometry.model;

import java.io.Serializable;
import robosim.geometry.exact.Checks;

/**
 * A motion: first a straight translation, then in place a turn about the own Y, then about the own X.
 *
 * <p>All is along and about the object's own axes (forward is +X) or, where a call says so, the world's: then too the
 * turn by {@code ry} comes first.
 *
 * @param x  world units forward
 * @param y  world units up
 * @param z  world units to the right of forward
 * @param rx degrees about the X axis, after the turn by {@code ry}; of any size, and more than 360 is more than a circle
 * @param ry degrees about the Y axis
 */
public record Move(double x, double y, double z, double rx, double ry) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Refuses what is NaN or infinite, and a translation beyond 2<sup>100</sup>. */
    public Move {
        x = Checks.coordinate("x", x);
        y = Checks.coordinate("y", y);
        z = Checks.coordinate("z", z);
        rx = Checks.angle("rx", rx);
        ry = Checks.angle("ry", ry);
    }

    /** No motion. */
    public Move() {
        this(0, 0, 0, 0, 0);
    }
}
