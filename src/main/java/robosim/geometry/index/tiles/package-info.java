/** Tiles of the plane with lists of what is in them, asked for boxes, rays and what is near. */
@NullMarked
package robosim.geometry.index.tiles;

import org.jspecify.annotations.NullMarked;
