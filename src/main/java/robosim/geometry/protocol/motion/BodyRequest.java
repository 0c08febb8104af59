package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;

/**
 * Gives a moveable object a body, or another one; or a static object a surface, which is all that one has. A body that an
 * object had keeps its velocity unless another is given.
 *
 * @param objectName  an object of the world
 * @param mass        kg; 0 for what its shape weighs at 200 kg/m<sup>3</sup>, about the density of a small robot
 * @param inertia     moment of inertia about the vertical through the centre, kg m<sup>2</sup>; 0 for that of a solid of
 *                    its shape, or of the box around it
 * @param surface     how it bounces and rubs
 * @param damping     by how much the speed falls, as a share of it each second
 * @param turnDamping the same of the speed of turning
 * @param maxSpeed    m/s; infinite for no limit
 * @param maxTurn     <b>radians</b> a second; infinite for no limit
 * @param floorFriction sliding friction on the floor of a planar world, which slows what nothing drives; 0 for what rolls. In a
 *                    spatial world its own friction with what is below it, unless that of its surface is more
 * @param drive       what drives it; null for what it had, at first nothing: it is pushed, and rolls out
 * @param velocity    its velocity; null for what it had, at first none
 * @param drag        quadratic drag, kg/m: at a speed v a force of {@code drag * v * v}
 * @param rolling     rolling resistance, a share of the load; in a planar world it adds to {@code floorFriction}
 * @param ignored     names of objects, or of layers, that it passes through and they through it; null stands for none
 */
public record BodyRequest(
        String objectName,
        double mass,
        double inertia,
        SurfaceSettings surface,
        double damping,
        double turnDamping,
        double maxSpeed,
        double maxTurn,
        double floorFriction,
        @Nullable DriveSettings drive,
        @Nullable Velocity velocity,
        double drag,
        double rolling,
        List<String> ignored)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** The friction of a body on the floor if nobody says so, about that of a crate of wood. */
    public static final double FLOOR_FRICTION = 0.5;

    /** kg/m^3: a Pioneer P3-DX is 9 kg in a box of 0.455 x 0.381 x 0.237 m, a TurtleBot3 Burger 1 kg in 0.138 x 0.178 x 0.192 m. */
    private static final double DENSITY = 200;

    private static final double NONE = Double.POSITIVE_INFINITY;

    /** Refuses null, and numbers that are out of range. */
    public BodyRequest {
        Checks.present("objectName", objectName);
        mass = Amounts.orDefault("mass", mass);
        inertia = Amounts.orDefault("inertia", inertia);
        Checks.present("surface", surface);
        damping = Amounts.atLeastZero("damping", damping);
        turnDamping = Amounts.atLeastZero("turnDamping", turnDamping);
        maxSpeed = Amounts.limit("maxSpeed", maxSpeed);
        maxTurn = Amounts.limit("maxTurn", maxTurn);
        floorFriction = Amounts.atLeastZero("floorFriction", floorFriction);
        drag = Amounts.atLeastZero("drag", drag);
        rolling = Amounts.atLeastZero("rolling", rolling);
        ignored = ignored == null ? List.of() : Checks.copy("ignored", ignored, String.class);
    }

    /** A smooth body of the default mass and friction on the floor, which nothing drives, dampens or limits. */
    public static BodyRequest of(String objectName) {
        return new BodyRequest(
                objectName,
                0,
                0,
                SurfaceSettings.SMOOTH,
                0,
                0,
                NONE,
                NONE,
                FLOOR_FRICTION,
                null,
                null,
                0,
                0,
                List.of());
    }

    /** A body as it is sent, with a drive or without. */
    public static BodyRequest of(String objectName, Body body, @Nullable Drive drive) {
        return new BodyRequest(
                objectName,
                body.mass(),
                body.inertia(),
                SurfaceSettings.of(body.surface()),
                body.damping(),
                body.turnDamping(),
                body.maxSpeed(),
                Amounts.radians(body.maxTurn()),
                body.floorFriction(),
                drive == null ? null : DriveSettings.of(drive),
                null,
                body.drag(),
                body.rolling(),
                List.copyOf(body.ignored()));
    }

    /**
     * The body for a shape; of shapes that {@link Body#ofMass} does not know, that of the box around it.
     *
     * @throws IllegalArgumentException if it has no volume, or no width, to work mass and inertia out from
     */
    public Body body(GeometryObject shape) {
        Body solid = solid(shape);
        return (inertia == 0 ? solid : Body.of(solid.mass(), inertia))
                .withSurface(surface.surface())
                .withDamping(damping, turnDamping)
                .withLimits(maxSpeed, Amounts.degrees(maxTurn))
                .withFloorFriction(floorFriction)
                .withDrag(drag, rolling)
                .ignoring(ignored);
    }

    private Body solid(GeometryObject shape) {
        if (shape.kind().isSized()) {
            return mass == 0 ? Body.ofDensity(shape, DENSITY) : Body.ofMass(shape, mass);
        }
        Bounds box = shape.bounds();
        double kg = mass == 0 ? DENSITY * box.width() * box.height() * box.length() : mass;
        return Body.of(kg, kg * (box.width() * box.width() + box.length() * box.length()) / 12);
    }

    /** This body with another mass, kg. */
    public BodyRequest withMass(double other) {
        return with(other, surface, damping, turnDamping, floorFriction, drive, velocity);
    }

    /** This body with another surface. */
    public BodyRequest withSurface(SurfaceSettings other) {
        return with(mass, other, damping, turnDamping, floorFriction, drive, velocity);
    }

    /** This body with other dampings, shares of the speeds each second. */
    public BodyRequest withDamping(double ofSpeed, double ofTurn) {
        return with(mass, surface, ofSpeed, ofTurn, floorFriction, drive, velocity);
    }

    /** This body with another friction on the floor. */
    public BodyRequest withFloorFriction(double other) {
        return with(mass, surface, damping, turnDamping, other, drive, velocity);
    }

    /** This body with another drive. */
    public BodyRequest withDrive(DriveSettings other) {
        return with(mass, surface, damping, turnDamping, floorFriction, other, velocity);
    }

    /** This body with a velocity. */
    public BodyRequest withVelocity(Velocity other) {
        return with(mass, surface, damping, turnDamping, floorFriction, drive, other);
    }

    /** This body with quadratic drag, kg/m, and rolling resistance, a share of the load. */
    public BodyRequest withDrag(double quadratic, double ofRolling) {
        return new BodyRequest(
                objectName,
                mass,
                inertia,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                drive,
                velocity,
                quadratic,
                ofRolling,
                ignored);
    }

    /** This body passing through the objects of some names or layers. */
    public BodyRequest ignoring(List<String> names) {
        return new BodyRequest(
                objectName,
                mass,
                inertia,
                surface,
                damping,
                turnDamping,
                maxSpeed,
                maxTurn,
                floorFriction,
                drive,
                velocity,
                drag,
                rolling,
                names);
    }

    private BodyRequest with(
            double kg,
            SurfaceSettings by,
            double ofSpeed,
            double ofTurn,
            double onFloor,
            @Nullable DriveSettings driven,
            @Nullable Velocity moving) {
        return new BodyRequest(
                objectName,
                kg,
                inertia,
                by,
                ofSpeed,
                ofTurn,
                maxSpeed,
                maxTurn,
                onFloor,
                driven,
                moving,
                drag,
                rolling,
                ignored);
    }
}
