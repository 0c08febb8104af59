/**
 * The values that users work with: objects, rays, moves, and the two enums that choose dimension and accuracy.
 *
 * <ul>
 *   <li>{@link Point}: a place; {@link Pose} adds an attitude, {@link Twist} is a velocity
 *   <li>{@link Frame}: the same places and poses in the axes of ROS, with {@link Quaternion}s
 *   <li>{@link Move}: a translation and then turns
 *   <li>{@link Ray}: a start and a direction; {@link RayPattern} has the directions of many
 *   <li>{@link SenseOptions}: ranges and width of the beams of a pattern, what they ignore, and the number of threads
 *   <li>{@link GeometryObject}: an object of a world; its kinds:
 *   <li>{@link BoxObject}: a box; {@link CylinderObject}, {@link SphereObject} and {@link CapsuleObject} are the
 *       other primitives
 *   <li>{@link MeshObject}: triangles and quads
 *   <li>{@link GridObject}: the occupied cells of a map
 *   <li>{@link ObjectGroup}: several objects as one
 *   <li>{@link Bounds}: a box that encloses an object
 *   <li>{@link Accuracy} and {@link Dimension}: how exactly, and whether heights count
 * </ul>
 *
 * <h2>Space</h2>
 *
 * Right-handed axes with Y up; lengths in world units, angles in degrees. A positive angle is counter-clockwise about
 * its axis by the right-hand rule, so that a yaw of +90 takes forward (1, 0, 0) to (0, 0, -1). Forward is an object's
 * own +X; width, height and length are its extents along X, Y and Z; a cylinder's axis is its own Y.
 *
 * <h2>Touching is colliding</h2>
 *
 * Every object is a closed set. Boxes, cylinders, spheres and capsules are solid, a mesh is a surface unless it was made
 * {@linkplain robosim.geometry.model.MeshObject#solid() solid}, and a group is the union of its members. Sizes of zero
 * and degenerate faces are legal: such a shape counts as the flat set, segment or point that it degenerates to.
 *
 * <pre>{@code
 * CylinderObject robot = new CylinderObject(new Point(1, 0, 0), 0.3, 1).moveable("robot");
 * BoxObject plank = new BoxObject(new Point(0, 0, 0), 2, 0.1, 0.3).turned(0, 90); // by 90 about the vertical
 * plank.heading();                                                               // 90
 * plank.movedTo(new Point(0, 2, 0)).center().y();                                // 2
 * ObjectGroup table = new ObjectGroup(List.of(
 *         new BoxObject(new Point(0, 0.7, 0), 1.6, 0.05, 0.8),
 *         new CylinderObject(new Point(0, 0.35, 0), 0.1, 0.7))).named("table");
 * }</pre>
 *
 * <p>Boxes, cylinders, spheres and capsules are given by their {@linkplain
 * robosim.geometry.model.GeometryObject#sizes() sizes} alone and have one form in common, the {@link
 * robosim.geometry.model.GeometryObject.RoundedBox}. Code that draws, measures or writes objects can use these, the triangles of a mesh, the
 * members of a group and the cells of a grid, and need not distinguish the kinds of shapes.
 *
 * <h2>Values</h2>
 *
 * All types here are immutable, compare by value and may be shared between threads. Coordinates and sizes are at most
 * 2<sup>100</sup> in magnitude; larger, infinite and NaN values are refused with a message that names the argument. A
 * coordinate of -0.0 becomes +0.0.
 */
@NullMarked
package robosim.geometry.model;

import org.jspecify.annotations.NullMarked;
