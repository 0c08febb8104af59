package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.model.Twist;

/**
 * A drive that goes in any direction on the ground and turns as it likes, as one with Swedish or Mecanum wheels (Siegwart,
 * Nourbakhsh and Scaramuzza 2011, 3.2).
 *
 * @param maxSpeed            m/s in any direction; infinite for no limit
 * @param maxAcceleration     m/s<sup>2</sup> in any direction; infinite for no limit
 * @param maxTurn             degrees a second; infinite for no limit
 * @param maxTurnAcceleration degrees a second, each second; infinite for no limit
 * @param command             the velocity that it is told to have, along the own axes; its part upwards is ignored
 */
public record OmnidirectionalDrive(
        double maxSpeed, double maxAcceleration, double maxTurn, double maxTurnAcceleration, Twist command)
        implements Drive {
    /** Refuses values that are out of range or not a number. */
    public OmnidirectionalDrive {
        maxSpeed = QuantityChecks.limit("maxSpeed", maxSpeed);
        maxAcceleration = QuantityChecks.limit("maxAcceleration", maxAcceleration);
        maxTurn = QuantityChecks.limit("maxTurn", maxTurn);
        maxTurnAcceleration = QuantityChecks.limit("maxTurnAcceleration", maxTurnAcceleration);
        Checks.present("command", command);
    }

    /** A drive that is told to stand. */
    public OmnidirectionalDrive(double maxSpeed, double maxAcceleration, double maxTurn, double maxTurnAcceleration) {
        this(maxSpeed, maxAcceleration, maxTurn, maxTurnAcceleration, new Twist(0, 0, 0, 0));
    }

    /** This drive with speeds forward and to the right, m/s, and of turning, degrees a second, as the command. */
    public OmnidirectionalDrive driving(double forward, double right, double turn) {
        return new OmnidirectionalDrive(
                maxSpeed, maxAcceleration, maxTurn, maxTurnAcceleration, new Twist(forward, 0, right, turn));
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        double[] v = QuantityChecks.numbers(now, body, seconds);
        next(v, body, seconds);
        return QuantityChecks.twist(v);
    }

    void next(double[] v, Body body, double seconds) {
        double asked = Math.sqrt(command.x() * command.x() + command.z() * command.z());
        double share = asked > maxSpeed ? maxSpeed / asked : 1;
        double dx = command.x() * share - v[0];
        double dz = command.z() * share - v[2];
        double change = Math.sqrt(dx * dx + dz * dz);
        double most = QuantityChecks.step(maxAcceleration, seconds);
        v[3] = QuantityChecks.toward(
                v[3], QuantityChecks.clamp(command.ry(), maxTurn), QuantityChecks.step(maxTurnAcceleration, seconds));
        if (change <= most) {
            v[0] = command.x() * share;
            v[2] = command.z() * share;
        } else {
            double made = most / change;
            v[0] += dx * made;
            v[2] += dz * made;
        }
        v[1] = 0;
        body.limit(v);
    }
}
