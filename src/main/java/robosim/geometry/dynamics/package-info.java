/**
 * What moves a robot: bodies with a mass and surfaces, drives that turn commands into velocities within their limits, and
 * odometry that is off as that of a real robot is;
 * and {@link robosim.geometry.dynamics.Dynamics}, which moves them all through a PLANAR world, or lets them fall in a SPATIAL one. All values are immutable and in SI units, with angles in degrees; a
 * world unit is a metre. {@link robosim.geometry.Geometry} knows nothing of this package, and a world that uses none of it
 * pays nothing.
 *
 * <ul>
 *   <li>{@link Dynamics}: steps the bodies of a world through time
 *   <li>{@link Body}: mass, inertia and surface of an object, and its drive
 *   <li>{@link Surface}: friction and restitution, and how those of two objects are combined
 *   <li>{@link Drive}: what turns a command into motion: {@link DifferentialDrive}, {@link AckermannDrive}, {@link
 *       OmnidirectionalDrive}, {@link SwerveDrive} with its {@link Motor}s, {@link VelocityDrive}, {@link ForceDrive}
 *   <li>{@link StepResult}: what happened in a step: contacts, and bodies that were stopped
 *   <li>{@link BodyContact}: a contact of two bodies: point, normal, impulse, phase
 *   <li>{@link SpatialVelocity}: the velocity of a body where heights count
 *   <li>{@link Odometry}: what a robot measures of its own motion, with its errors
 * </ul>
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 5, 20);
 * world.addObject(new BoxObject(new Point(3, 0, 0), 1, 2, 8).turned(0, 10).named("wall"));
 * BoxObject cart = new BoxObject(new Point(0, 0, 0), 0.8, 0.5, 0.5).moveable("cart");
 * world.addObject(cart);
 * Body body = Body.ofMass(cart, 40);
 * DifferentialDrive drive = new DifferentialDrive(0.5, 1.2, 2).driving(1, 0);
 * Twist velocity = new Twist(0, 0, 0, 0);
 * for (int step = 0; step < 100; step++) {
 *     velocity = drive.next(velocity, body, 0.05);
 *     Move way = new Move(velocity.x() * 0.05, 0, velocity.z() * 0.05, 0, velocity.ry() * 0.05);
 *     world.moveAndSlide("cart", way, 0.001, 4);
 * }
 * velocity.x();                                     // 1
 * world.getObject("cart").center().z() != 0;        // true: it has slid along the wall
 * world.getProximity("cart", 1) > 0;                // true
 * }</pre>
 */
@NullMarked
package robosim.geometry.dynamics;

import org.jspecify.annotations.NullMarked;
