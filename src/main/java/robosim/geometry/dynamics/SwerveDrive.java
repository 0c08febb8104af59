package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * Wheels at given places of a robot, each with a direction and a speed of its own: a swerve drive, whose modules are steered, or
 * with a {@code maxSteering} of 0 a drive of wheels that are not, such as a tank drive of six. Each wheel gives what its motor can,
 * along its direction, and holds across it, both within the circle of its friction; beyond that it slides, so a robot
 * that drives too fast into a curve skids, and one that is pushed gives way. All wheels carry the same share of the weight.
 *
 * <pre>{@code
 * Motor motor = new Motor(7.09, 6000, 366, 6.75, 0.0508, 80, 0);
 * SwerveDrive swerve = SwerveDrive.of(0.6, 0.6, motor, 1.1);
 * SwerveDrive sideways = swerve.driving(0, 2, 0);
 * sideways.modules().get(0).angle();                                                // -90.0
 * sideways.next(new Twist(0, 0, 0, 0), Body.of(50, 5), 5).z();                      // 2.0
 * sideways.next(new Twist(9, 0, 0, 0), Body.of(50, 5), 0.1).x() > 7.9;              // true: it slides on, slowed by 1.1 g
 * }</pre>
 *
 * @param modules     the wheels, as they are to be: 1 to 64
 * @param motor       what drives each wheel; null for one that is limited by the friction of its wheel alone
 * @param grip        friction of a wheel with the floor, static and sliding; in a SPATIAL world also at most what
 *                    {@link Body#floorFriction} gives there
 * @param maxSteering degrees a second by which {@link Dynamics} turns a module towards its command; infinite for at once
 */
public record SwerveDrive(List<Module> modules, @Nullable Motor motor, double grip, double maxSteering)
        implements Drive {
    private static final int MOST_MODULES = 64;

    /**
     * A wheel, and what it is to do.
     *
     * @param x     metres forward from the object's centre
     * @param z     metres to the right
     * @param angle degrees counter-clockwise from forward: where the wheel rolls to
     * @param speed m/s of its rim
     */
    public record Module(double x, double z, double angle, double speed) {
        /** Refuses values that are not finite. */
        public Module {
            x = QuantityChecks.finite("x", x);
            z = QuantityChecks.finite("z", z);
            angle = Checks.angle("angle", angle);
            speed = QuantityChecks.finite("speed", speed);
        }

        /** A wheel that looks forward and stands. */
        public Module(double x, double z) {
            this(x, z, 0, 0);
        }

        /** This module with another angle, degrees, and speed, m/s. */
        public Module to(double newAngle, double newSpeed) {
            return new Module(x, z, newAngle, newSpeed);
        }
    }

    /** Refuses null, values that are out of range, and none or too many modules. */
    public SwerveDrive {
        modules = List.copyOf(Checks.present("modules", modules));
        if (modules.isEmpty() || modules.size() > MOST_MODULES) {
            throw new IllegalArgumentException(
                    "modules must be 1 to " + MOST_MODULES + " (got: " + modules.size() + ")");
        }
        grip = QuantityChecks.atLeastZero("grip", grip);
        maxSteering = QuantityChecks.limit("maxSteering", maxSteering);
    }

    /**
     * Four modules in the corners of a rectangle, that steer at once.
     *
     * @param wheelbase metres from the front wheels to the rear ones
     * @param track     metres from the left wheels to the right ones
     */
    public static SwerveDrive of(double wheelbase, double track, @Nullable Motor motor, double grip) {
        double x = QuantityChecks.positive("wheelbase", wheelbase) / 2;
        double z = QuantityChecks.positive("track", track) / 2;
        List<Module> corners = List.of(new Module(x, -z), new Module(x, z), new Module(-x, -z), new Module(-x, z));
        return new SwerveDrive(corners, motor, grip, Double.POSITIVE_INFINITY);
    }

    /** This drive with modules that do something else, or are elsewhere. */
    public SwerveDrive with(List<Module> others) {
        return new SwerveDrive(others, motor, grip, maxSteering);
    }

    /** This drive with modules that turn by at most so many degrees a second; 0 for wheels that are not steered. */
    public SwerveDrive steering(double degrees) {
        return new SwerveDrive(modules, motor, grip, degrees);
    }

    /**
     * This drive with the angles and speeds of its modules that make a motion of the whole robot: all slower where one would
     * be faster than its motor can turn it. A module turns the shorter way, and runs backward where that is shorter. Wheels that
     * are not steered get the speed along their direction.
     *
     * @param forward m/s
     * @param right   m/s
     * @param turn    degrees a second, counter-clockwise
     */
    public SwerveDrive driving(double forward, double right, double turn) {
        double w = Degrees.toRadians(Checks.angle("turn", turn));
        List<Module> to = new ArrayList<>(modules.size());
        double fastest = 0;
        for (Module each : modules) {
            double x = QuantityChecks.finite("forward", forward) + w * each.z;
            double z = QuantityChecks.finite("right", right) - w * each.x;
            double along = x * Degrees.cos(each.angle) - z * Degrees.sin(each.angle);
            double speed = Math.sqrt(x * x + z * z);
            if (maxSteering == 0 || speed == 0) {
                to.add(each.to(each.angle, along));
            } else {
                double sign = along < 0 ? -1 : 1; // turns by no more than a quarter
                to.add(each.to(Degrees.toDegrees(StrictMath.atan2(-sign * z, sign * x)), sign * speed));
            }
            fastest = Math.max(fastest, Math.abs(to.get(to.size() - 1).speed));
        }
        double most = motor == null ? Double.POSITIVE_INFINITY : motor.freeSpeed();
        if (fastest > most) {
            double share = most / fastest;
            to.replaceAll(each -> each.to(each.angle, each.speed * share));
        }
        return with(to);
    }

    /** A command of this drive where its modules have turned from those of another one for a time. */
    SwerveDrive turnedFrom(SwerveDrive before, double seconds) {
        if (maxSteering == Double.POSITIVE_INFINITY || before.modules.size() != modules.size()) {
            return this;
        }
        double most = maxSteering * seconds;
        List<Module> turned = new ArrayList<>(modules.size());
        for (int k = 0; k < modules.size(); k++) {
            Module to = modules.get(k);
            double from = before.modules.get(k).angle;
            double by = Math.IEEEremainder(to.angle - from, 360);
            turned.add(Math.abs(by) <= most ? to : to.to(from + Math.copySign(most, by), to.speed));
        }
        return with(turned);
    }

    /** The most by which it speeds up a body, m/s^2: by its friction, and by its motors at stall. */
    double acceleration(Body body) {
        double friction = grip * Body.GRAVITY;
        return motor == null ? friction : Math.min(friction, modules.size() * motor.force(0) / body.mass());
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body, seconds);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        new WheelForces(this, body).move(v, seconds);
        body.limit(v);
    }

    /**
     * How fast the wheels turn while the robot moves: as fast as the ground where they roll, as fast as their command where they
     * spin because their motor is stronger than their friction, as against a wall.
     *
     * @param now the velocity of the robot
     * @return m/s of each rim, in the order of the modules
     */
    public double[] wheelSpeeds(Twist now, Body body) {
        double[] v = QuantityChecks.numbers(now, body, 0);
        return new WheelForces(this, body).speeds(v);
    }

    /**
     * What odometry makes of the {@link #wheelSpeeds} and the angles of the modules: the motion of a robot on which they would
     * roll, by least squares. Where wheels spin or slide, the robot moves otherwise.
     */
    public Twist wheelVelocity(Twist now, Body body) {
        return WheelForces.velocity(modules, wheelSpeeds(now, body));
    }
}
