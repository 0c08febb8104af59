/**
 * A world of objects, and the answers to three questions: may this be here, how far may it move, how far away is the
 * nearest surface? This page is a tour. A test runs all its code and compares the values in the comments.
 *
 * <ul>
 *   <li>{@link Geometry}: a world: adds, moves and removes objects, and answers queries; for one thread at a time
 *   <li>{@link Snapshot}: an immutable copy of a world, which any number of threads may query
 *   <li>{@link WorldQueries}: the queries that both answer
 *   <li>{@link MoveResult}: how far a move is free, and what blocks it
 *   <li>{@link SlideOptions} and {@link SlideResult}: how a move continues along what blocks it, and what it touched
 *   <li>{@link RayHit} and {@link NearObject}: the nearest surface along a ray, and the nearest object
 *   <li>{@link SenseBuffer}: the readings of all beams of a pattern, in arrays that are used again
 *   <li>{@link ObjectSearch}: which objects are where
 *   <li>{@link Avoidance}: a margin, and objects that do not count
 *   <li>{@link WorldProver}: the answers of a world with proofs
 *   <li>{@link WorkLimit} and {@link WorkLimitException}: how much work a call may take
 * </ul>
 *
 * <h2>A world</h2>
 *
 * A {@link robosim.geometry.Geometry} is a box around the origin with objects in it. Y is up, X and Z span the floor,
 * angles are degrees, forward is an object's own +X ({@link robosim.geometry.model} says it in full). Objects that move
 * have a name.
 *
 * <pre>{@code
 * Geometry geometry = new Geometry(20, 5, 20);
 * BoxObject wall = new BoxObject(new Point(4, 0, 0), 0.5, 2, 6).named("wall");
 * geometry.addObject(wall);                                                             // true
 * geometry.addObject(new CylinderObject(new Point(0, 0, 0), 0.3, 1).moveable("robot")); // true
 * geometry.testObject(new SphereObject(new Point(2.75, 0, 0), 1));                      // true: it would touch at x = 3.75
 * geometry.addObject(new SphereObject(new Point(2.75, 0, 0), 1));                       // false: it was not added
 * }</pre>
 *
 * <h2>Moves</h2>
 *
 * A move is swept from its beginning to its end: it is made if nothing is touched anywhere on the way, however long it
 * is, or else not made at all. {@link robosim.geometry.MoveResult} reports what blocks it, where, and how much of it is
 * free.
 *
 * <!-- java: continues -->
 * <pre>{@code
 * geometry.simpleMove("robot", 2, 0, 0);  // true
 * geometry.simpleMove("robot", 50, 0, 0); // false: the wall is in the way, and the robot stays
 * MoveResult result = geometry.move("robot", new Move(2.9, 0, 0, 0, 0));
 * result.fraction();                      // 0.5: half the way is free
 * result.obstacle().name();               // "wall"
 * geometry.moveToContact("robot", new Move(50, 0, 0, 0, 0), 0.1);
 * geometry.getProximity("robot", 10);     // 0.1
 * geometry.simpleTurn("robot", 90);       // true
 * geometry.getObject("robot").heading();  // 90
 * }</pre>
 *
 * <h2>Sensors</h2>
 *
 * A beam has a range and an opening angle: 0 is a line, more is a cone, whose result is the distance of the nearest
 * point within it. If there is no echo the result is {@code +Infinity}. No robot detects itself.
 *
 * <!-- java: continues -->
 * <pre>{@code
 * geometry.placeObject("robot", new Point(0, 0, 0), 0);
 * geometry.getSonarDistance("robot", 1, 0, 0, 10, 15); // 3.75: straight ahead, in a cone of 15 degrees
 * geometry.getSonarDistance("robot", -1, 0, 0, 10, 0); // Infinity: nothing is behind it within 10
 * double[] ring = geometry.scan("robot", 0, 1, 360, 0, 10);
 * double ahead = ring[0];                              // 3.75
 * RayHit hit = geometry.castRay(new Ray(new Point(0, 0, 2), new Point(1, 0, 0)), 10);
 * hit.object().equals(wall);                           // true
 * hit.normal().x();                                    // -1
 * }</pre>
 *
 * <h2>Many worlds</h2>
 *
 * A {@link robosim.geometry.Snapshot} is an immutable copy of a world. Worlds made from it share all static objects, so
 * thousands of them cost little, and each may be used by a thread of its own; {@code robosim.geometry.sweep} runs
 * scenarios over them.
 *
 * <!-- java: continues -->
 * <pre>{@code
 * Snapshot snapshot = geometry.snapshot();
 * Geometry copy = snapshot.toGeometry();
 * copy.removeObject("robot");            // true
 * geometry.hasObject("robot");           // true: it is another world
 * }</pre>
 *
 * <h2>Exactness</h2>
 *
 * Answers are those of real-number geometry for the stored numbers, without a tolerance; where that is out of reach, at
 * least "free" is proven. A coarser {@link robosim.geometry.model.Accuracy}, for a world or one query, may report
 * collisions where there are none but never misses one. In {@link robosim.geometry.model.Dimension#PLANAR} only the
 * floor plan counts.
 *
 * <!-- java: continues -->
 * <pre>{@code
 * SphereObject ball = new SphereObject(new Point(-5, 0, 0), 1);
 * geometry.addObject(ball);                         // true
 * BoxObject post = new BoxObject(new Point(-4.1, 0, 0.9), 0.1, 1, 0.1);
 * geometry.testObject(post);                        // false: it stands beside the ball
 * geometry.testObject(post, Accuracy.AABB);         // true: it stands in the ball's box
 * CollisionDetection.intersects(ball, post);        // false: the same question without a world
 * }</pre>
 *
 * <h2>Where to go on</h2>
 *
 * <ul>
 *   <li>{@link robosim.geometry.model}: the objects, and what their numbers mean
 *   <li>{@link robosim.geometry.collision}: two objects, or a ray and an object, without a world; contacts and distances
 *   <li>{@link robosim.geometry.world}: worlds, meshes and maps from files
 *   <li>{@link robosim.geometry.net} and {@link robosim.geometry.protocol}: the module in use by a simulator, over TCP
 *   <li>{@link robosim.geometry.scenario}: recorded conversations and their replay
 *   <li>{@link robosim.geometry.junit}: tests of robots
 *   <li>{@link robosim.geometry.sweep}: scenarios over worlds, parameters and seeds, on threads and on many machines
 * </ul>
 */
@NullMarked
package robosim.geometry;

import org.jspecify.annotations.NullMarked;
