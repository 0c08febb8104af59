package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.model.Twist;

/**
 * A body that has the velocity it is given at once, whatever it had before.
 *
 * @param velocity along the own axes. A part upwards is for {@link #next} alone, where the caller moves the robot;
 *                 {@link Dynamics#drive} refuses one, since drives act along the ground
 */
public record VelocityDrive(Twist velocity) implements Drive {
    /** Refuses null. */
    public VelocityDrive {
        Checks.present("velocity", velocity);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body) {
        v[0] = velocity.x();
        v[1] = velocity.y();
        v[2] = velocity.z();
        v[3] = velocity.ry();
        body.limit(v);
    }
}
