package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * Two wheels beside each other, each driven by itself: {@code v = (r + l) / 2} and {@code w = (r - l) / track} for the speeds
 * of their rims (Siegwart, Nourbakhsh and Scaramuzza 2011, 3.2).
 *
 * <pre>{@code
 * DifferentialDrive drive = new DifferentialDrive(0.5, 1, 2).driving(0.8, 0);
 * Body body = Body.of(10, 1);
 * drive.next(new Twist(0, 0, 0, 0), body, 0.1).x(); // 0.2: after 0.1 s at 2 m/s^2
 * drive.next(new Twist(0, 0, 0, 0), body, 1).x();   // 0.8
 * drive.wheels(-0.5, 0.5).next(new Twist(0, 0, 0, 0), body, 1).x(); // 0.0: it turns in place
 * }</pre>
 *
 * @param track           metres between the wheels
 * @param maxSpeed        most speed of a rim, m/s; infinite for no limit. If a command asks for more, both are reduced in
 *                        the same proportion, so that the curve is the same
 * @param maxAcceleration by how much the speed of a rim may change, m/s<sup>2</sup>; infinite for no limit
 * @param left            the command: speed of the left rim, m/s
 * @param right           the command: speed of the right rim, m/s
 */
public record DifferentialDrive(double track, double maxSpeed, double maxAcceleration, double left, double right)
        implements Drive {
    /** Refuses values that are out of range or not a number. */
    public DifferentialDrive {
        track = QuantityChecks.positive("track", track);
        maxSpeed = QuantityChecks.limit("maxSpeed", maxSpeed);
        maxAcceleration = QuantityChecks.limit("maxAcceleration", maxAcceleration);
        left = QuantityChecks.finite("left", left);
        right = QuantityChecks.finite("right", right);
    }

    /** A drive that is told to stand. */
    public DifferentialDrive(double track, double maxSpeed, double maxAcceleration) {
        this(track, maxSpeed, maxAcceleration, 0, 0);
    }

    /** This drive with speeds of the rims, m/s, as the command. */
    public DifferentialDrive wheels(double ofLeft, double ofRight) {
        return new DifferentialDrive(track, maxSpeed, maxAcceleration, ofLeft, ofRight);
    }

    /** This drive with a speed, m/s, and a speed of turning, degrees a second, as the command. */
    public DifferentialDrive driving(double forward, double turn) {
        double aside = aside(Checks.angle("turn", turn));
        return wheels(QuantityChecks.finite("forward", forward) - aside, forward + aside);
    }

    /** By how much a rim is faster or slower than the middle while the body turns. */
    private double aside(double degrees) {
        return Degrees.toRadians(degrees) * (track / 2);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body, seconds);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        double step = QuantityChecks.step(maxAcceleration, seconds);
        double fastest = Math.max(Math.abs(left), Math.abs(right));
        double share = fastest > maxSpeed ? maxSpeed / fastest : 1;
        double aside = aside(v[3]);
        double l = QuantityChecks.toward(v[0] - aside, left * share, step);
        double r = QuantityChecks.toward(v[0] + aside, right * share, step);
        v[0] = (l + r) / 2;
        v[1] = 0;
        v[2] = 0;
        v[3] = Degrees.toDegrees((r - l) / track);
        body.limit(v);
    }
}
