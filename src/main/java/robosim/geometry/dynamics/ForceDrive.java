package robosim.geometry.dynamics;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * A force and a torque on a body, constant along its own axes, which the body's damping resists. {@code new ForceDrive(0, 0, 0)}
 * is a body that rolls out. Nothing keeps a body that turns from going on straight, as wheels would; what {@link #next} answers
 * is along the axes that the body has when the step begins.
 *
 * <p>The exact solution of {@code v' = F / m - c v} for a damping c, as if the body did not turn in the step: so steps of any
 * length lead to the same velocity.
 *
 * @param x      newtons forward
 * @param z      newtons to the right
 * @param torque newton metres about the vertical, counter-clockwise
 */
public record ForceDrive(double x, double z, double torque) implements Drive {
    /** Refuses values that are not finite. */
    public ForceDrive {
        x = QuantityChecks.finite("x", x);
        z = QuantityChecks.finite("z", z);
        torque = QuantityChecks.finite("torque", torque);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body, seconds);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        double slowed = body.damping() * seconds;
        double turnSlowed = body.turnDamping() * seconds;
        change(
                v,
                body,
                seconds,
                Decay.kept(slowed),
                Decay.mean(slowed),
                Decay.kept(turnSlowed),
                Decay.mean(turnSlowed));
    }

    /** The mean of {@link #next} over a time, with the direction at its beginning. */
    Twist mean(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        double slowed = body.damping() * seconds;
        double turnSlowed = body.turnDamping() * seconds;
        change(
                v,
                body,
                seconds,
                Decay.mean(slowed),
                Decay.meanGain(slowed),
                Decay.mean(turnSlowed),
                Decay.meanGain(turnSlowed));
        return QuantityChecks.twist(v);
    }

    /** What {@link #next} makes of what {@link #mean} has answered, or of what collisions have left of that. */
    Twist rest(Twist mean, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(mean, body, seconds);
        double slowed = body.damping() * seconds;
        double turnSlowed = body.turnDamping() * seconds;
        change(
                v,
                body,
                seconds,
                Decay.rest(slowed),
                Decay.restGain(slowed),
                Decay.rest(turnSlowed),
                Decay.restGain(turnSlowed));
        return QuantityChecks.twist(v);
    }

    /** Leaves a share of the velocity, and adds a share of what the force would give without damping. */
    private void change(
            double[] v, Body body, double seconds, double kept, double gained, double turnKept, double turnGained) {
        double push = seconds / body.mass();
        double turn = Degrees.toDegrees(torque * (seconds / body.inertia()));
        v[0] = v[0] * kept + x * push * gained;
        v[1] *= kept;
        v[2] = v[2] * kept + z * push * gained;
        v[3] = v[3] * turnKept + turn * turnGained;
        body.limit(v);
    }
}
