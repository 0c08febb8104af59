/**
 * Queries about two objects, or a ray and an object, without a world: {@link
 * robosim.geometry.collision.CollisionDetection} answers whether objects collide and how far away they are along a ray;
 * {@link robosim.geometry.collision.ContactQuery} names the faces that meet and measures gaps, within a budget of work.
 *
 * <ul>
 *   <li>{@link CollisionDetection}: whether two objects collide, and how far away an object is along a ray
 *   <li>{@link ContactQuery}: a query about two objects: collision, distance, contacts
 *   <li>{@link Verdict}: the answer, and how certain it is
 *   <li>{@link Contact} and {@link ContactPart}: where two objects touch, and the face or member of each that does
 *   <li>{@link SignedDistance}: how far apart two objects are, or how deep in each other, with points and direction
 *   <li>{@link Budget}: how much work a query may take
 *   <li>{@link Certainty}: how sure a verdict is
 * </ul>
 *
 * <pre>{@code
 * BoxObject table = new BoxObject(new Point(0, 0, 0), 2, 1, 1);
 * SphereObject ball = new SphereObject(new Point(0, 0.75, 0), 0.25);
 * CollisionDetection.intersects(table, ball);                           // true: it lies on the table
 * CollisionDetection.rayDistance(
 *         new Ray(new Point(0, 5, 0), new Point(0, -1, 0)), ball);      // 4.0
 * }</pre>
 */
@NullMarked
package robosim.geometry.collision;

import org.jspecify.annotations.NullMarked;
