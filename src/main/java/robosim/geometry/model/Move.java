package robosim.geometry.model;

import java.io.Serializable;
import robosim.geometry.check.Checks;

/**
 * A motion: first a straight translation, then in place a turn about the own Y, then about the own X.
 *
 * <p>All components are along and about the object's own axes (forward is +X) or, if a method says so, the world's. In
 * both cases the turn by {@code ry} comes first.
 *
 * <p>In {@link Dimension#PLANAR} an object's own turns are the same as in SPATIAL: its own X and Y may be tipped, and a
 * turn about its own X tips it, which changes its projection. Turns about the world's axes are about the vertical only
 * there, and {@code rx} is ignored.
 *
 * @param x  world units forward
 * @param y  world units up
 * @param z  world units to the right of forward
 * @param rx degrees about the X axis, after the turn by {@code ry}; of any size: more than 360 is more than one full
 *     turn; ignored in PLANAR where the axes are the world's
 * @param ry degrees about the Y axis
 */
public record Move(double x, double y, double z, double rx, double ry) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Refuses values that are NaN or infinite, and translations beyond 2<sup>100</sup>. */
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
