package robosim.geometry.dynamics;

import robosim.geometry.model.Twist;

/**
 * What turns a command into a velocity, step after step. A drive is a value that holds its command: another command is another
 * value, made by a method such as {@link DifferentialDrive#driving}.
 *
 * <p>Velocities are along the own axes of the body as they are at the beginning of the step: forward is +X, to the right is
 * +Z, and a turn counter-clockwise is positive. Nothing here knows what is in the way.
 */
public sealed interface Drive
        permits DifferentialDrive, OmnidirectionalDrive, AckermannDrive, SwerveDrive, VelocityDrive, ForceDrive {
    /**
     * The velocity at the end of a step: as near to the command as the limits of the drive allow, then within the limits of
     * the body.
     *
     * @param now     the velocity at the beginning of the step
     * @param seconds length of the step; at least 0
     */
    Twist next(Twist now, Body body, double seconds);
}
