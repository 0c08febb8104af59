package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Twist;

/**
 * What drives a body, without a command.
 *
 * @param kind                which drive it is
 * @param base                metres between the wheels of a differential drive, or between the axles of a car; 0 for as far as
 *                            its shape is wide or long, and for other kinds
 * @param maxSpeed            m/s; infinite for no limit
 * @param maxAcceleration     m/s<sup>2</sup>; infinite for no limit
 * @param maxTurn             <b>radians</b> a second, of a car the radians that its front wheels turn to each side, below pi/2;
 *                            infinite for no limit, which is pi/3 for a car. A differential drive has none but that of its rims
 * @param maxTurnAcceleration radians a second, each second; infinite for no limit. Of an omnidirectional drive alone
 * @param centreAhead         metres from the rear axle of a car forward to the object's centre; negative where the centre is
 *                            behind it. 0 for other kinds
 * @param swerve              the wheels of a swerve drive, which has none of the numbers above; null for one in each corner of its
 *                            shape with a friction of 1, and for other kinds
 */
public record DriveSettings(
        Kind kind,
        double base,
        double maxSpeed,
        double maxAcceleration,
        double maxTurn,
        double maxTurnAcceleration,
        double centreAhead,
        @Nullable SwerveSettings swerve)
        implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    private static final double NONE = Double.POSITIVE_INFINITY;

    /** The angle of a car's front wheels if nobody limits it, degrees: about twice that of a real one. */
    private static final double CAR_STEERING = 60;

    /** A differential drive as wide as its body, without limits. */
    public static final DriveSettings DEFAULT = of(Kind.DIFFERENTIAL);

    /** The drives. */
    public enum Kind {
        /** Two wheels beside each other: a speed and a turn. */
        DIFFERENTIAL,
        /** Speeds forward and to the right, and a turn. */
        OMNIDIRECTIONAL,
        /**
         * A car: a speed, and an angle of the front wheels. It turns about its rear axle, which is at the object's centre
         * unless {@code centreAhead} is given.
         */
        ACKERMANN,
        /** Has the velocity that it is given at once. */
        VELOCITY,
        /** Newtons forward and to the right, and newton metres. */
        FORCE,
        /** Wheels at given places, which are steered or not: speeds forward and to the right, and a turn. */
        SWERVE,
        /** None: a body that is given it loses the drive that it had. */
        NONE;

        /** Whether a command to the right means anything to it: wheels that do not swivel only roll. */
        public boolean canGoSideways() {
            return this == OMNIDIRECTIONAL || this == SWERVE || this == VELOCITY || this == FORCE;
        }

        /** The turn of a {@link DriveCommand}, of what people give: degrees, or newton metres for a force. */
        public double turn(double given) {
            return this == FORCE ? given : Degrees.toRadians(given);
        }

        /** The numbers that it has, in words. */
        private String numbers() {
            return switch (this) {
                case DIFFERENTIAL -> "base, maxSpeed and maxAcceleration";
                case OMNIDIRECTIONAL -> "maxSpeed, maxAcceleration, maxTurn and maxTurnAcceleration";
                case ACKERMANN -> "base, maxSpeed, maxAcceleration, maxTurn and centreAhead";
                case SWERVE -> "swerve alone";
                case VELOCITY, FORCE, NONE -> "none of these numbers";
            };
        }
    }

    /** Refuses null, numbers that are out of range, and numbers that its kind has not. */
    public DriveSettings {
        Checks.present("kind", kind);
        base = Amounts.orDefault("base", base);
        maxSpeed = Amounts.limit("maxSpeed", maxSpeed);
        maxAcceleration = Amounts.limit("maxAcceleration", maxAcceleration);
        maxTurn = Amounts.limit("maxTurn", maxTurn);
        maxTurnAcceleration = Amounts.limit("maxTurnAcceleration", maxTurnAcceleration);
        centreAhead = Amounts.finite("centreAhead", centreAhead);
        boolean isCar = kind == Kind.ACKERMANN;
        boolean isWheeled = isCar || kind == Kind.DIFFERENTIAL;
        boolean isFree = kind == Kind.VELOCITY || kind == Kind.FORCE || kind == Kind.SWERVE || kind == Kind.NONE;
        refuse(!isWheeled && base != 0, kind, "base", base);
        refuse(!isCar && centreAhead != 0, kind, "centreAhead", centreAhead);
        refuse(isFree && maxSpeed < Double.POSITIVE_INFINITY, kind, "maxSpeed", maxSpeed);
        refuse(isFree && maxAcceleration < Double.POSITIVE_INFINITY, kind, "maxAcceleration", maxAcceleration);
        refuse((isFree || kind == Kind.DIFFERENTIAL) && maxTurn < Double.POSITIVE_INFINITY, kind, "maxTurn", maxTurn);
        refuse(
                kind != Kind.OMNIDIRECTIONAL && maxTurnAcceleration < Double.POSITIVE_INFINITY,
                kind,
                "maxTurnAcceleration",
                maxTurnAcceleration);
        if (kind != Kind.SWERVE && swerve != null) {
            throw new IllegalArgumentException("swerve must be left out for a drive of kind " + kind + ", which has "
                    + kind.numbers() + " (got: " + swerve + ")");
        }
        if (isCar && maxTurn < Double.POSITIVE_INFINITY && maxTurn >= Math.PI / 2) {
            throw new IllegalArgumentException("maxTurn of a car must be below pi/2 (got: " + maxTurn + ")");
        }
    }

    /** A drive whose wheels are not at given places. */
    public DriveSettings(
            Kind kind,
            double base,
            double maxSpeed,
            double maxAcceleration,
            double maxTurn,
            double maxTurnAcceleration,
            double centreAhead) {
        this(kind, base, maxSpeed, maxAcceleration, maxTurn, maxTurnAcceleration, centreAhead, null);
    }

    /** A swerve drive. */
    public static DriveSettings of(SwerveSettings swerve) {
        return new DriveSettings(Kind.SWERVE, 0, NONE, NONE, NONE, NONE, 0, Checks.present("swerve", swerve));
    }

    /** A drive as it is sent, without its command. */
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
                    Amounts.radians(any.maxTurn()),
                    Amounts.radians(any.maxTurnAcceleration()));
        }
        if (drive instanceof AckermannDrive car) {
            return new DriveSettings(
                    Kind.ACKERMANN,
                    car.wheelbase(),
                    car.maxSpeed(),
                    car.maxAcceleration(),
                    Amounts.radians(car.maxSteering()),
                    NONE,
                    car.centreAhead());
        }
        if (drive instanceof SwerveDrive swerve) {
            return of(SwerveSettings.of(swerve));
        }
        return of(drive instanceof VelocityDrive ? Kind.VELOCITY : Kind.FORCE);
    }

    /**
     * The drive with a command.
     *
     * @param shape  gives the measures that are left out: its extents in its own frame
     * @param before what drove the body so far; the modules of a swerve drive keep their angles, so that each turns the shorter
     *               way
     */
    public Drive drive(Bounds shape, DriveCommand command, @Nullable Drive before) {
        double turn = Degrees.toDegrees(command.turn());
        return switch (kind) {
            case DIFFERENTIAL ->
                new DifferentialDrive(base == 0 ? shape.length() : base, maxSpeed, maxAcceleration)
                        .driving(command.forward(), turn);
            case OMNIDIRECTIONAL ->
                new OmnidirectionalDrive(
                                maxSpeed,
                                maxAcceleration,
                                Amounts.degrees(maxTurn),
                                Amounts.degrees(maxTurnAcceleration))
                        .driving(command.forward(), command.right(), turn);
            case ACKERMANN ->
                new AckermannDrive(
                                base == 0 ? shape.width() : base,
                                maxTurn == NONE ? CAR_STEERING : Amounts.degrees(maxTurn),
                                maxSpeed,
                                maxAcceleration)
                        .withCentreAhead(centreAhead)
                        .driving(command.forward(), turn);
            case VELOCITY -> new VelocityDrive(new Twist(command.forward(), 0, command.right(), turn));
            case FORCE -> new ForceDrive(command.forward(), command.right(), command.turn());
            case SWERVE -> swerve(shape, before).driving(command.forward(), command.right(), turn);
            case NONE -> throw new IllegalStateException("kind NONE must be handled before drives are made");
        };
    }

    /** A drive whose object's centre is on the rear axle, if it is a car. */
    public DriveSettings(
            Kind kind,
            double base,
            double maxSpeed,
            double maxAcceleration,
            double maxTurn,
            double maxTurnAcceleration) {
        this(kind, base, maxSpeed, maxAcceleration, maxTurn, maxTurnAcceleration, 0);
    }

    private SwerveDrive swerve(Bounds shape, @Nullable Drive before) {
        SwerveDrive made = swerve == null ? SwerveDrive.of(shape.width(), shape.length(), null, 1) : swerve.drive();
        if (!(before instanceof SwerveDrive old)
                || old.modules().size() != made.modules().size()) {
            return made;
        }
        List<SwerveDrive.Module> turned = new ArrayList<>();
        for (int k = 0; k < made.modules().size(); k++) {
            turned.add(made.modules().get(k).to(old.modules().get(k).angle(), 0));
        }
        return made.with(turned);
    }

    /** This car with the object's centre so many metres ahead of its rear axle. */
    public DriveSettings withCentreAhead(double metres) {
        return new DriveSettings(kind, base, maxSpeed, maxAcceleration, maxTurn, maxTurnAcceleration, metres);
    }

    private static void refuse(boolean wrong, Kind kind, String argument, double value) {
        if (wrong) {
            throw new IllegalArgumentException(argument + " must be left out for a drive of kind " + kind
                    + ", which has " + kind.numbers() + " (got: " + value + ")");
        }
    }

    /** A drive without limits. */
    public static DriveSettings of(Kind kind) {
        return new DriveSettings(kind, 0, NONE, NONE, NONE, NONE);
    }
}
