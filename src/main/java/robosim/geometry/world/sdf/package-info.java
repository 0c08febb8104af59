/** SDFormat: its files, frames and collisions, and the objects made of them. */
@NullMarked
package robosim.geometry.world.sdf;

import org.jspecify.annotations.NullMarked;
