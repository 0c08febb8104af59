package robosim.geometry.net.session;

import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.Motor;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.DriveSettings.Kind;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.SwerveSettings;

/** Bodies and drives as a peer asks for them, and what an object weighs if nobody says so. */
public final class BodyRequests {
    private static final double NONE = Double.POSITIVE_INFINITY;

    /** kg/m^3: a Pioneer P3-DX is 9 kg in a box of 0.455 x 0.381 x 0.237 m, a TurtleBot3 Burger 1 kg in 0.138 x 0.178 x 0.192 m. */
    private static final double DENSITY = 200;

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
                null,
                body.drag(),
                body.rolling(),
                List.copyOf(body.ignored()));
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
        if (drive instanceof SwerveDrive swerve) {
            Motor motor = swerve.motor();
            return DriveSettings.of(new SwerveSettings(
                    swerve.modules().stream()
                            .map(each -> new Point(each.x(), 0, each.z()))
                            .toList(),
                    swerve.grip(),
                    radians(swerve.maxSteering()),
                    motor == null
                            ? null
                            : new SwerveSettings.Motor(
                                    motor.stallTorque(),
                                    motor.freeTurns(),
                                    motor.stallCurrent(),
                                    motor.gearRatio(),
                                    motor.wheelRadius(),
                                    motor.currentLimit(),
                                    motor.supplyResistance())));
        }
        return DriveSettings.of(drive instanceof VelocityDrive ? Kind.VELOCITY : Kind.FORCE);
    }

    /** A swerve drive as a peer asks for it, without its command. */
    static SwerveDrive swerve(SwerveSettings asked) {
        SwerveSettings.Motor motor = asked.motor();
        double steering = asked.maxSteering();
        return new SwerveDrive(
                asked.wheels().stream()
                        .map(each -> new SwerveDrive.Module(each.x(), each.z()))
                        .toList(),
                motor == null
                        ? null
                        : new Motor(
                                motor.stallTorque(),
                                motor.freeTurns(),
                                motor.stallCurrent(),
                                motor.gearRatio(),
                                motor.wheelRadius(),
                                motor.currentLimit(),
                                motor.supplyResistance()),
                asked.grip(),
                steering == NONE ? steering : Degrees.toDegrees(steering));
    }

    private static double radians(double degrees) {
        return degrees == NONE ? degrees : Degrees.toRadians(degrees);
    }

    /**
     * A body of a shape as a peer asks for it; of shapes that {@link Body#ofMass} does not know, that of the box around it.
     *
     * @param mass    kg; 0 for what it weighs at the default density
     * @param inertia kg m^2; 0 for that of the shape
     * @throws IllegalArgumentException if it has no volume, or no width, to work these out from
     */
    static Body body(GeometryObject shape, double mass, double inertia) {
        Body solid = solid(shape, mass);
        return inertia == 0 ? solid : Body.of(solid.mass(), inertia);
    }

    private static Body solid(GeometryObject shape, double mass) {
        if (shape.kind().isSized()) {
            return mass == 0 ? Body.ofDensity(shape, DENSITY) : Body.ofMass(shape, mass);
        }
        Bounds box = shape.bounds();
        double kg = mass == 0 ? DENSITY * box.width() * box.height() * box.length() : mass;
        return Body.of(kg, kg * (box.width() * box.width() + box.length() * box.length()) / 12);
    }
}
