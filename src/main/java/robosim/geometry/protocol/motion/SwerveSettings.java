package robosim.geometry.protocol.motion;

import java.io.Serial;
import java.io.Serializable;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.model.Point;

/**
 * The wheels of a drive of kind {@link DriveSettings.Kind#SWERVE}.
 *
 * @param wheels      where each is, from the object's centre: metres forward, 0, and to the right; 1 to 64
 * @param grip        friction of a wheel with the floor
 * @param maxSteering <b>radians</b> a second by which a wheel is steered; infinite for at once, 0 for wheels that are not steered
 * @param motor       what drives each wheel; null for one that friction alone limits
 */
public record SwerveSettings(
        List<Point> wheels,
        double grip,
        double maxSteering,
        @Nullable Motor motor) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    private static final int MOST_WHEELS = 64;

    /**
     * A direct-current motor and its gears.
     *
     * @param stallTorque      newton metres at the motor, at 12 V
     * @param freeTurns        turns a minute without load, at 12 V
     * @param stallCurrent     amperes at stall, at 12 V
     * @param gearRatio        turns of the motor for one of the wheel
     * @param wheelRadius      metres
     * @param currentLimit     amperes; infinite for no limit
     * @param supplyResistance ohms of the supply times the number of motors that draw from it; 0 for none
     */
    public record Motor(
            double stallTorque,
            double freeTurns,
            double stallCurrent,
            double gearRatio,
            double wheelRadius,
            double currentLimit,
            double supplyResistance)
            implements Serializable {
        @Serial
        private static final long serialVersionUID = 1;

        /** Refuses numbers that are out of range. */
        public Motor {
            stallTorque = Amounts.positive("stallTorque", stallTorque);
            freeTurns = Amounts.positive("freeTurns", freeTurns);
            stallCurrent = Amounts.positive("stallCurrent", stallCurrent);
            gearRatio = Amounts.positive("gearRatio", gearRatio);
            wheelRadius = Amounts.positive("wheelRadius", wheelRadius);
            currentLimit = Amounts.limit("currentLimit", currentLimit);
            supplyResistance = Amounts.atLeastZero("supplyResistance", supplyResistance);
        }

        private static @Nullable Motor of(robosim.geometry.dynamics.@Nullable Motor motor) {
            return motor == null
                    ? null
                    : new Motor(
                            motor.stallTorque(),
                            motor.freeTurns(),
                            motor.stallCurrent(),
                            motor.gearRatio(),
                            motor.wheelRadius(),
                            motor.currentLimit(),
                            motor.supplyResistance());
        }

        private robosim.geometry.dynamics.Motor motor() {
            return new robosim.geometry.dynamics.Motor(
                    stallTorque, freeTurns, stallCurrent, gearRatio, wheelRadius, currentLimit, supplyResistance);
        }
    }

    /** The wheels of a drive as they are sent, without its command. */
    static SwerveSettings of(SwerveDrive drive) {
        return new SwerveSettings(
                drive.modules().stream()
                        .map(each -> new Point(each.x(), 0, each.z()))
                        .toList(),
                drive.grip(),
                Amounts.radians(drive.maxSteering()),
                Motor.of(drive.motor()));
    }

    /** The drive, told to stand. */
    public SwerveDrive drive() {
        return new SwerveDrive(
                wheels.stream()
                        .map(each -> new SwerveDrive.Module(each.x(), each.z()))
                        .toList(),
                motor == null ? null : motor.motor(),
                grip,
                Amounts.degrees(maxSteering));
    }

    /** Refuses null, numbers that are out of range, and none or too many wheels. */
    public SwerveSettings {
        wheels = Checks.copy("wheels", wheels, Point.class);
        if (wheels.isEmpty() || wheels.size() > MOST_WHEELS) {
            throw new IllegalArgumentException("wheels must be 1 to " + MOST_WHEELS + " (got: " + wheels.size() + ")");
        }
        for (Point wheel : wheels) {
            Amounts.finite("wheels.x", wheel.x());
            Amounts.finite("wheels.z", wheel.z());
            if (wheel.y() != 0) {
                throw new IllegalArgumentException("wheels must be on the floor; set y to 0 (got: " + wheel + ")");
            }
        }
        grip = Amounts.atLeastZero("grip", grip);
        maxSteering = Amounts.limit("maxSteering", maxSteering);
    }
}
