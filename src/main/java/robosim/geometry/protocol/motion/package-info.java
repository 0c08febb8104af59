/**
 * What a {@link robosim.geometry.protocol.StepBundle} consists of: bodies, drives and their commands, and what comes back:
 * where each body is, how fast it moves, and what it met. Units are SI; angles are in radians.
 */
@NullMarked
package robosim.geometry.protocol.motion;

import org.jspecify.annotations.NullMarked;
