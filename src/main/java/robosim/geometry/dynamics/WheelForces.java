package robosim.geometry.dynamics;

import java.util.Arrays;
import java.util.List;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * What the wheels of a drive do to a body on a level floor: impulses at each, one after the other until nothing changes any more,
 * along its direction within what the motor gives, and all within the circle of friction.
 */
final class WheelForces {
    /** The forces of motors are worked out anew after so many seconds at most, a hundredth of the time in which robots speed up. */
    private static final double PART = 1.0 / 512;

    private static final int MOST_PARTS = 1 << 12;
    private static final int MOST_ROUNDS = 200;

    /** Changes of the velocity by less no longer count, m/s. */
    private static final double SMALL = 1e-12;

    /** A wheel that gives more than this share of its friction slides. */
    private static final double ALL = 1 - 1e-9;

    private final List<SwerveDrive.Module> modules;
    private final SwerveDrive drive;
    private final Body body;

    /** The most force at a wheel, newtons. */
    private final double most;

    /** By wheel: its direction, forward and to the right; and impulses along and across it. */
    private final double[] forward;

    private final double[] right;
    private final double[] given;

    /** By wheel: whether it gives all that friction allows, so that its motor turns it as it is told to. */
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

    /** How fast a wheel spins: as it is told to, or less fast where its motor gives no more than friction takes from it. */
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
        SwerveDrive.Module at = modules.get(k);
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
    static Twist velocity(List<SwerveDrive.Module> modules, double[] speeds) {
        double[][] sums = new double[3][4];
        for (int k = 0; k < speeds.length; k++) {
            SwerveDrive.Module at = modules.get(k);
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
