package robosim.geometry.dynamics;

import robosim.geometry.exact.Checks;
import robosim.geometry.model.Twist;

/**
 * A body that has the velocity it is given at once, whatever it had before.
 *
 * @param velocity along the own axes
 */
public record VelocityDrive(Twist velocity) implements Drive {
    /** Refuses null. */
    public VelocityDrive {
        Checks.present("velocity", velocity);
    }

    @Override
    public Twist next(Twist now, Body body, double seconds) {
        Checks.present("now", now);
        Quantity.atLeastZero("seconds", seconds);
        return Checks.present("body", body).limited(velocity);
    }
}
