package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;

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

    /** A body without drag and rolling resistance. */
    public BodyRequest(
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
            @Nullable Velocity velocity) {
        this(
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
                0,
                0,
                List.of());
    }

    /** A smooth body of the default mass and friction on the floor, which nothing drives, dampens or limits. */
    public static BodyRequest of(String objectName) {
        double none = Double.POSITIVE_INFINITY;
        return new BodyRequest(objectName, 0, 0, SurfaceSettings.SMOOTH, 0, 0, none, none, FLOOR_FRICTION, null, null);
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
