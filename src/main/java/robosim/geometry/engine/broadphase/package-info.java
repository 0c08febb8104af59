/** The broad phase, which tells candidates: the leaves of a world's objects at each accuracy, and the tiles and trees over them. */
@NullMarked
package robosim.geometry.engine.broadphase;

import org.jspecify.annotations.NullMarked;
