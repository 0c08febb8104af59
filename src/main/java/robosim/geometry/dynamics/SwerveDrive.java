package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
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

    /**
     * What the wheels of a drive do to a body on a level floor: impulses at each, one after the other until nothing changes any more,
     * along its direction within what the motor gives, and all within the circle of friction.
     */
    private static final class WheelForces {
        /** The forces of motors are worked out anew after so many seconds at most, a hundredth of the time in which robots speed up. */
        private static final double PART = 1.0 / 512;

        private static final int MOST_PARTS = 1 << 8;
        private static final int MOST_ROUNDS = 200;

        /** Changes of the velocity by less no longer count, m/s. */
        private static final double SMALL = 1e-12;

        /** A wheel that gives more than this share of its friction slides. */
        private static final double ALL = 1 - 1e-9;

        private final List<Module> modules;
        private final SwerveDrive drive;
        private final Body body;

        /** The most force at a wheel, newtons. */
        private final double most;

        /** By wheel: its direction, forward and to the right; and impulses along and across it. */
        private final double[] forward;

        private final double[] right;
        private final double[] given;

        /** By wheel: whether it gives all that friction allows, so that its motor turns it at the commanded speed. */
        private final boolean[] spins;

        // The velocity now: m/s and radians a second.
        private double x;
        private double z;
        private double w;

        WheelForces(SwerveDrive drive, Body body) {
            this.drive = drive;
            this.body = body;
            modules = drive.modules();
            int count = modules.size();
            most = drive.grip() * body.mass() * Body.GRAVITY / count;
            forward = new double[count];
            right = new double[count];
            given = new double[2 * count];
            spins = new boolean[count];
            for (int k = 0; k < count; k++) {
                forward[k] = Degrees.cos(modules.get(k).angle());
                right[k] = 0.0 - Degrees.sin(modules.get(k).angle());
            }
        }

        /** Changes a velocity by what the wheels do in a time; metres a second and degrees a second. */
        void move(double[] v, double seconds) {
            begin(v);
            int parts = (int) Math.max(1, Math.min(MOST_PARTS, Math.ceil(seconds / PART)));
            for (int part = 0; part < parts && seconds > 0; part++) {
                double before = x + z + w;
                solve(seconds / parts);
                if (x + z + w == before && part > 0) {
                    break; // it has reached its command
                }
            }
            v[0] = x;
            v[1] = 0;
            v[2] = z;
            v[3] = Degrees.toDegrees(w);
        }

        /** How fast the wheels turn at a velocity. */
        double[] speeds(double[] v) {
            begin(v);
            solve(PART);
            begin(v);
            double[] speeds = new double[modules.size()];
            for (int k = 0; k < speeds.length; k++) {
                speeds[k] = spins[k] ? spinning(k) : speed(k, forward[k], right[k]);
            }
            return speeds;
        }

        /** How fast a wheel spins: at its commanded speed, or slower where its motor gives no more than friction takes from it. */
        private double spinning(int k) {
            double told = modules.get(k).speed();
            Motor motor = drive.motor();
            if (motor == null) {
                return told;
            }
            double rubs = Math.abs(given[2 * k]) / PART;
            return QuantityChecks.clamp(told, Math.max(0, motor.speed(rubs)));
        }

        private void begin(double[] v) {
            x = v[0];
            z = v[2];
            w = Degrees.toRadians(v[3]);
        }

        /** The speed of the body at a wheel along a direction. */
        private double speed(int k, double ahead, double aside) {
            Module at = modules.get(k);
            return (x + w * at.z()) * ahead + (z - w * at.x()) * aside;
        }

        /** The torque about the centre of a force at a wheel along a direction, counter-clockwise. */
        private double arm(int k, double ahead, double aside) {
            return modules.get(k).z() * ahead - modules.get(k).x() * aside;
        }

        private double ease(double arm) {
            return 1 / (1 / body.mass() + arm * arm / body.inertia());
        }

        private void solve(double seconds) {
            int count = modules.size();
            Arrays.fill(given, 0);
            double[] strongest = new double[2 * count];
            for (int k = 0; k < count; k++) {
                Motor motor = drive.motor();
                double speed = speed(k, forward[k], right[k]);
                strongest[2 * k] = motor == null ? Double.POSITIVE_INFINITY : motor.force(speed) * seconds;
                strongest[2 * k + 1] = motor == null ? Double.NEGATIVE_INFINITY : -motor.force(-speed) * seconds;
            }
            double change = 1;
            for (int round = 0; round < MOST_ROUNDS && change > SMALL; round++) {
                change = 0;
                for (int k = 0; k < count; k++) {
                    // From either end in turns, so that no side is favoured.
                    int wheel = (round & 1) == 0 ? k : count - 1 - k;
                    change = Math.max(change, give(wheel, strongest[2 * wheel], strongest[2 * wheel + 1], seconds));
                }
            }
        }

        /** Lets a wheel give what it can; answers by how much that changes a velocity. */
        private double give(int k, double highest, double lowest, double seconds) {
            double ahead = forward[k];
            double aside = right[k];
            double armAlong = arm(k, ahead, aside);
            double armAcross = arm(k, -aside, ahead);
            double wanted = given[2 * k] + (modules.get(k).speed() - speed(k, ahead, aside)) * ease(armAlong);
            double along = Math.max(lowest, Math.min(highest, wanted));
            double across = given[2 * k + 1] - speed(k, -aside, ahead) * ease(armAcross);
            double size = Math.sqrt(along * along + across * across);
            double limit = most * seconds;
            spins[k] = size > limit * ALL;
            if (size > limit) {
                along *= limit / size;
                across *= limit / size;
            }
            double byAlong = along - given[2 * k];
            double byAcross = across - given[2 * k + 1];
            given[2 * k] = along;
            given[2 * k + 1] = across;
            x += (byAlong * ahead - byAcross * aside) / body.mass();
            z += (byAlong * aside + byAcross * ahead) / body.mass();
            w += (byAlong * armAlong + byAcross * armAcross) / body.inertia();
            return (Math.abs(byAlong) + Math.abs(byAcross)) / body.mass();
        }

        /**
         * The motion with which wheels at their angles roll at their speeds, by least squares: the normal equations of three
         * unknowns. What wheels that do not steer leave open, as that all of them slide sideways, is 0.
         */
        static Twist velocity(List<Module> modules, double[] speeds) {
            double[][] sums = new double[3][4];
            for (int k = 0; k < speeds.length; k++) {
                Module at = modules.get(k);
                double ahead = Degrees.cos(at.angle());
                double aside = 0.0 - Degrees.sin(at.angle());
                // A wheel measures its velocity as a whole: its speed along its direction, and nothing across it.
                add(sums, new double[] {ahead, aside, at.z() * ahead - at.x() * aside}, speeds[k]);
                add(sums, new double[] {-aside, ahead, -at.z() * aside - at.x() * ahead}, 0);
            }
            double[] v = solve(sums);
            return new Twist(v[0], 0, v[1], Degrees.toDegrees(v[2]));
        }

        private static void add(double[][] sums, double[] row, double value) {
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    sums[i][j] += row[i] * row[j];
                }
                sums[i][3] += row[i] * value;
            }
        }

        /** Gaussian elimination of a matrix that is symmetric; an unknown that nothing determines is 0. */
        private static double[] solve(double[][] a) {
            double scale = a[0][0] + a[1][1] + a[2][2];
            for (int k = 0; k < 3; k++) {
                for (int i = 0; i < 3; i++) {
                    if (i != k && Math.abs(a[k][k]) > 1e-12 * scale) {
                        double by = a[i][k] / a[k][k];
                        for (int j = k; j < 4; j++) {
                            a[i][j] -= by * a[k][j];
                        }
                    }
                }
            }
            double[] v = new double[3];
            for (int k = 0; k < 3; k++) {
                v[k] = Math.abs(a[k][k]) > 1e-12 * scale ? a[k][3] / a[k][k] : 0;
            }
            return v;
        }
    }
}
