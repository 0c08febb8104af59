package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * A car: driven along its length, steered by its front axle. It turns about a point on the line of its rear axle, by
 * {@code w = v tan(steering) / wheelbase}, so it does not turn while it stands (LaValle 2006, 13.1). The object's centre is
 * on the rear axle unless {@link #withCentreAhead} says how far ahead of it. The front wheels are where they are told to be at
 * once.
 *
 * <pre>{@code
 * AckermannDrive car = new AckermannDrive(2.5, 35, 10, 3).withCentreAhead(1.25); // its centre halfway between the axles
 * }</pre>
 *
 * @param wheelbase       metres from axle to axle
 * @param maxSteering     degrees to each side, from 0 up to, not including, 90; a command beyond it is reduced to it
 * @param maxSpeed        m/s; infinite for no limit
 * @param maxAcceleration m/s<sup>2</sup>; infinite for no limit
 * @param centreAhead     metres from the rear axle forward to the object's centre; negative where the centre is behind it
 * @param speed           the command: m/s of the rear axle, negative for backwards
 * @param steering        the command: degrees, positive to the left, between -90 and 90
 */
public record AckermannDrive(
        double wheelbase,
        double maxSteering,
        double maxSpeed,
        double maxAcceleration,
        double centreAhead,
        double speed,
        double steering)
        implements Drive {
    /** Refuses values that are out of range or not a number. */
    public AckermannDrive {
        wheelbase = QuantityChecks.positive("wheelbase", wheelbase);
        if (!(maxSteering >= 0 && maxSteering < 90)) {
            throw new IllegalArgumentException(
                    "maxSteering must be from 0 up to, not including, 90 degrees (got: " + maxSteering + ")");
        }
        maxSteering += 0.0;
        maxSpeed = QuantityChecks.limit("maxSpeed", maxSpeed);
        maxAcceleration = QuantityChecks.limit("maxAcceleration", maxAcceleration);
        centreAhead = QuantityChecks.finite("centreAhead", centreAhead);
        speed = QuantityChecks.finite("speed", speed);
        steering = Checks.angle("steering", steering);
        if (!(Math.abs(steering) < 90)) {
            throw new IllegalArgumentException(
                    "steering must be between -90 and 90 degrees, the angle of the front wheels (got: " + steering
                            + ")");
        }
    }

    /** A car whose centre is on its rear axle. */
    public AckermannDrive(
            double wheelbase,
            double maxSteering,
            double maxSpeed,
            double maxAcceleration,
            double speed,
            double steering) {
        this(wheelbase, maxSteering, maxSpeed, maxAcceleration, 0, speed, steering);
    }

    /** A car that is told to stand, its wheels straight, its centre on its rear axle. */
    public AckermannDrive(double wheelbase, double maxSteering, double maxSpeed, double maxAcceleration) {
        this(wheelbase, maxSteering, maxSpeed, maxAcceleration, 0, 0, 0);
    }

    /** This car with a speed, m/s, and an angle of the front wheels, degrees to the left, as the command. */
    public AckermannDrive driving(double forward, double left) {
        return new AckermannDrive(wheelbase, maxSteering, maxSpeed, maxAcceleration, centreAhead, forward, left);
    }

    /** This car with the object's centre so many metres ahead of its rear axle. */
    public AckermannDrive withCentreAhead(double metres) {
        return new AckermannDrive(wheelbase, maxSteering, maxSpeed, maxAcceleration, metres, speed, steering);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body, seconds);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        double forward = QuantityChecks.toward(
                v[0], QuantityChecks.clamp(speed, maxSpeed), QuantityChecks.step(maxAcceleration, seconds));
        // Before the curve is applied, since a limit of the speed would change it.
        forward = QuantityChecks.clamp(forward, body.maxSpeed());
        double wheels = QuantityChecks.clamp(steering, maxSteering);
        double tangent = Degrees.sin(wheels) / Degrees.cos(wheels);
        double turn = Degrees.toDegrees(forward * tangent / wheelbase);
        // A car that may not turn so fast goes more slowly, on the same curve.
        double share = Math.abs(turn) > body.maxTurn() ? body.maxTurn() / Math.abs(turn) : 1;
        v[0] = forward * share;
        v[1] = 0;
        v[3] = QuantityChecks.clamp(turn, body.maxTurn());
        v[2] = 0.0 - Degrees.toRadians(v[3]) * centreAhead; // a turn to the left takes what is ahead to the left
    }
}
