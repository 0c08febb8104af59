package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.Surface;

/**
 * How the surfaces of two objects make that of their contact, for all contacts of a world.
 *
 * @param restitution of the two numbers of restitution
 * @param friction    of the two numbers of static friction, and of those of sliding friction
 */
public record SurfaceMixing(Rule restitution, Rule friction) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** What two numbers make. */
    public enum Rule {
        /** The square root of the product, for both unless a step sets another rule. */
        GEOMETRIC_MEAN,
        /** The arithmetic mean. */
        MEAN,
        /** The larger one, as dyn4j and Box2D have it for restitution. */
        LARGER,
        /** The smaller one, as ODE, and so Gazebo, have it for friction. */
        SMALLER,
        /** The product, as Bullet has it for both. */
        PRODUCT
    }

    /** Refuses null. */
    public SurfaceMixing {
        Checks.present("restitution", restitution);
        Checks.present("friction", friction);
    }

    /** The rules as they are sent. */
    public static SurfaceMixing of(Surface.Mixing restitution, Surface.Mixing friction) {
        return new SurfaceMixing(Rule.valueOf(restitution.name()), Rule.valueOf(friction.name()));
    }

    /** Gives these rules to a world. */
    public void applyTo(Dynamics dynamics) {
        dynamics.mix(Surface.Mixing.valueOf(restitution.name()), Surface.Mixing.valueOf(friction.name()));
    }
}
