package robosim.geometry.net.session;

import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.exact.Degrees;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.DriveSettings.Kind;
import robosim.geometry.protocol.motion.SurfaceSettings;

/** Bodies and drives as a peer asks for them. */
public final class BodyRequests {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private BodyRequests() {}

    /** A body for an object, with a drive or without. */
    public static BodyRequest of(String name, Body body, @Nullable Drive drive) {
        return new BodyRequest(
                name,
                body.mass(),
                body.inertia(),
                of(body.surface()),
                body.damping(),
                body.turnDamping(),
                body.maxSpeed(),
                radians(body.maxTurn()),
                body.floorFriction(),
                drive == null ? null : of(drive),
                null);
    }

    /** A surface. */
    public static SurfaceSettings of(Surface surface) {
        return new SurfaceSettings(surface.restitution(), surface.staticFriction(), surface.slidingFriction());
    }

    /** A drive, without its command. */
    public static DriveSettings of(Drive drive) {
        if (drive instanceof DifferentialDrive wheels) {
            return new DriveSettings(
                    Kind.DIFFERENTIAL, wheels.track(), wheels.maxSpeed(), wheels.maxAcceleration(), NONE, NONE);
        }
        if (drive instanceof OmnidirectionalDrive any) {
            return new DriveSettings(
                    Kind.OMNIDIRECTIONAL,
                    0,
                    any.maxSpeed(),
                    any.maxAcceleration(),
                    radians(any.maxTurn()),
                    radians(any.maxTurnAcceleration()));
        }
        if (drive instanceof AckermannDrive car) {
            if (car.centreAhead() != 0) {
                throw new IllegalArgumentException(
                        "drive must have its centre on its rear axle in a session or a test; use"
                                + " Dynamics for another one (got: " + car + ")");
            }
            return new DriveSettings(
                    Kind.ACKERMANN,
                    car.wheelbase(),
                    car.maxSpeed(),
                    car.maxAcceleration(),
                    Degrees.toRadians(car.maxSteering()),
                    NONE);
        }
        return DriveSettings.of(drive instanceof VelocityDrive ? Kind.VELOCITY : Kind.FORCE);
    }

    private static double radians(double degrees) {
        return degrees == NONE ? degrees : Degrees.toRadians(degrees);
    }
}
