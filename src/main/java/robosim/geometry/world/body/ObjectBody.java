package robosim.geometry.world.body;

import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.Surface;

/**
 * What a world file says about the body of an object; of a static object its surface alone.
 *
 * @param mass          kg; 0 for what its shape weighs at 200 kg/m<sup>3</sup>, about the density of a small robot
 * @param inertia       kg m<sup>2</sup> about the vertical; 0 for that of a solid of its shape, or of the box around it
 * @param surface       how it bounces and rubs
 * @param floorFriction sliding friction on the floor of a planar world; 0 for what rolls. In a spatial world its own friction
 *                      with what is below it, unless that of its surface is more
 * @param damping       by how much the speed falls, as a share of it each second
 * @param turnDamping   the same of the speed of turning
 * @param maxSpeed      m/s; infinite for no limit
 * @param maxTurn       degrees a second; infinite for no limit
 * @param drag          quadratic drag, kg/m: at a speed v a force of {@code drag * v * v}
 * @param rolling       rolling resistance, a share of the load; in a planar world it adds to {@code floorFriction}
 * @param ignored       names of objects or layers that it passes through, and they through it
 * @param drive         what drives it, told to stand; null if nothing does
 */
public record ObjectBody(
        double mass,
        double inertia,
        Surface surface,
        double floorFriction,
        double damping,
        double turnDamping,
        double maxSpeed,
        double maxTurn,
        double drag,
        double rolling,
        Set<String> ignored,
        @Nullable Drive drive) {
    /** The friction on the floor if a file does not say it, about that of a crate of wood. */
    public static final double FLOOR_FRICTION = 0.5;

    /** Smooth, of the default mass, inertia and friction on the floor; nothing drives, dampens or limits it. */
    public static final ObjectBody DEFAULT = new ObjectBody(
            0,
            0,
            Surface.SMOOTH,
            FLOOR_FRICTION,
            0,
            0,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            0,
            0,
            Set.of(),
            null);

    /** Refuses null, and numbers that are out of range. */
    public ObjectBody {
        mass = Checks.size("mass", mass);
        inertia = Checks.size("inertia", inertia);
        Checks.present("surface", surface);
        floorFriction = Checks.size("floorFriction", floorFriction);
        damping = Checks.size("damping", damping);
        turnDamping = Checks.size("turnDamping", turnDamping);
        maxSpeed = limit("maxSpeed", maxSpeed);
        maxTurn = limit("maxTurn", maxTurn);
        drag = Checks.size("drag", drag);
        rolling = Checks.size("rolling", rolling);
        ignored = Checks.names("ignored", ignored);
        for (String name : ignored) {
            if (name.chars().anyMatch(Character::isWhitespace)) {
                throw new IllegalArgumentException(
                        "ignored must have names without spaces in a world file; put the object"
                                + " into a layer (got: \"" + name + "\")");
            }
        }
        if (drive instanceof AckermannDrive car && car.centreAhead() != 0) {
            throw new IllegalArgumentException(
                    "drive must have its centre on its rear axle in a world file (got: " + car + ")");
        }
    }

    private static double limit(String argument, double value) {
        if (!(value >= 0)) {
            throw new IllegalArgumentException(argument + " must be at least 0 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** A surface, which is all that a static object has. */
    public static ObjectBody of(Surface surface) {
        return DEFAULT.withSurface(surface);
    }

    /** This body with another surface. */
    public ObjectBody withSurface(Surface other) {
        return new ObjectBody(
                mass,
                inertia,
                other,
                floorFriction,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                drag,
                rolling,
                ignored,
                drive);
    }

    /** Whether it has nothing but a surface. */
    public boolean isSurface() {
        return equals(of(surface));
    }
}
