/**
 * What a {@link robosim.geometry.protocol.StepBundle} consists of: bodies, drives and their commands, and what comes back:
 * where each body is, how fast it moves, and what it met. Units are SI; angles are in radians.
 *
 * <ul>
 *   <li>{@link BodyRequest}: gives a body to an object: mass, {@link SurfaceSettings}, {@link DriveSettings}
 *   <li>{@link DriveCommand}: what a robot should do from the beginning of a step
 *   <li>{@link SurfaceMixing}: how the surfaces of two objects are combined
 *   <li>{@link BodyAnswer}: where a body is after the step, and its {@link Velocity}
 *   <li>{@link ContactAnswer}: two objects that collided or touch
 *   <li>{@link StopAnswer}: a body that was stopped, and why
 * </ul>
 */
@NullMarked
package robosim.geometry.protocol.motion;

import org.jspecify.annotations.NullMarked;
