/** Worlds of the simulator Stage. */
@NullMarked
package robosim.geometry.world.stage;

import org.jspecify.annotations.NullMarked;
