/**
 * Tries motions and carries none out: the segments of a motion, what blocks them, and how far they are free. {@code Geometry} moves
 * the object to the place that Motion tells.
 */
@NullMarked
package robosim.geometry.engine.motion;

import org.jspecify.annotations.NullMarked;
