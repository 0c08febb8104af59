package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.dynamics.Surface;

/**
 * How a surface bounces and rubs.
 *
 * @param restitution     the share of the speed of approach at which two such surfaces part, from 0 to 1
 * @param staticFriction  the most that friction is, as a share of the force across the contact, while nothing slides
 * @param slidingFriction the same while it slides; at most {@code staticFriction}
 */
public record SurfaceSettings(double restitution, double staticFriction, double slidingFriction)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** Neither bounces nor rubs. */
    public static final SurfaceSettings SMOOTH = new SurfaceSettings(0, 0, 0);

    /** Refuses numbers that are out of range. */
    public SurfaceSettings {
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("restitution must be a number from 0 to 1 (got: " + restitution + ")");
        }
        restitution += 0.0;
        staticFriction = Amounts.atLeastZero("staticFriction", staticFriction);
        slidingFriction = Amounts.atLeastZero("slidingFriction", slidingFriction);
        if (slidingFriction > staticFriction) {
            throw new IllegalArgumentException("slidingFriction must be at most staticFriction, " + staticFriction
                    + " (got: " + slidingFriction + ")");
        }
    }

    /** A surface as it is sent. */
    public static SurfaceSettings of(Surface surface) {
        return new SurfaceSettings(surface.restitution(), surface.staticFriction(), surface.slidingFriction());
    }

    /** The surface. */
    public Surface surface() {
        return new Surface(restitution, staticFriction, slidingFriction);
    }
}
