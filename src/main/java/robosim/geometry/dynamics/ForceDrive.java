package robosim.geometry.dynamics;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * A force and a torque on a body, constant along its own axes, which the body's damping resists. {@code new ForceDrive(0, 0, 0)}
 * is a body that rolls out. Nothing keeps a body that turns from going on straight, as wheels would; what {@link #next} answers
 * is along the axes that the body has when the step begins.
 *
 * <p>One step of the implicit Euler method, {@code v' = (v + dt F / m) / (1 + c dt)} for a damping c, which never overshoots,
 * however long the step (Hairer and Wanner 1996, IV.3).
 *
 * @param x      newtons forward
 * @param z      newtons to the right
 * @param torque newton metres about the vertical, counter-clockwise
 */
public record ForceDrive(double x, double z, double torque) implements Drive {
    /** Refuses values that are not finite. */
    public ForceDrive {
        x = Quantity.finite("x", x);
        z = Quantity.finite("z", z);
        torque = Quantity.finite("torque", torque);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = Quantity.numbers(now, body, seconds);
        next(v, body, seconds);
        return Quantity.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        double slower = 1 + body.damping() * seconds;
        double turnSlower = 1 + body.turnDamping() * seconds;
        double push = seconds / body.mass();
        double turn = Degrees.toDegrees(torque * (seconds / body.inertia()));
        v[0] = (v[0] + x * push) / slower;
        v[1] /= slower;
        v[2] = (v[2] + z * push) / slower;
        v[3] = (v[3] + turn) / turnSlower;
        body.limit(v);
    }
}
