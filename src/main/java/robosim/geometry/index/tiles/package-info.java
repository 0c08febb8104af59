/** Tiles of the plane with lists of the objects on them, for box, ray and proximity queries. */
@NullMarked
package robosim.geometry.index.tiles;

import org.jspecify.annotations.NullMarked;
