package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;

/**
 * How a body moves and turns in space, along and about the axes of the world.
 *
 * <pre>{@code
 * SpatialVelocity thrown = new SpatialVelocity(3, 4, 0, 0, 0, -360);
 * thrown.speed();          // 5.0
 * }</pre>
 *
 * @param x  m/s along the world's X
 * @param y  m/s upward
 * @param z  m/s along the world's Z
 * @param rx degrees a second about the world's X, counter-clockwise seen from its end
 * @param ry degrees a second about the vertical
 * @param rz degrees a second about the world's Z
 */
public record SpatialVelocity(double x, double y, double z, double rx, double ry, double rz) {
    /** At rest. */
    public static final SpatialVelocity REST = new SpatialVelocity(0, 0, 0, 0, 0, 0);

    /** Refuses values that are NaN or infinite, and velocities beyond 2<sup>100</sup>. */
    public SpatialVelocity {
        x = Checks.coordinate("x", x);
        y = Checks.coordinate("y", y);
        z = Checks.coordinate("z", z);
        rx = QuantityChecks.finite("rx", rx);
        ry = QuantityChecks.finite("ry", ry);
        rz = QuantityChecks.finite("rz", rz);
    }

    /** How fast the centre moves, m/s. */
    public double speed() {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
