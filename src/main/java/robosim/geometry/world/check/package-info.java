/**
 * What to know about a world before robots run in it: contacts (Overlaps), which robots are shut in (RobotReachability, by a
 * GridSearch of each) and which accuracy is sufficient (SampleQueries).
 */
@NullMarked
package robosim.geometry.world.check;

import org.jspecify.annotations.NullMarked;
