/**
 * Requests whose numbers and answers are packed: all beams of a sensor, and batches of poses and edges of a planner; and the
 * answers to them. Angles are in radians.
 */
@NullMarked
package robosim.geometry.protocol.batch;

import org.jspecify.annotations.NullMarked;
