/** Discs and polygons in the plane: exact and certified decisions about projections, and discs that move. */
@NullMarked
package robosim.geometry.narrow.planar;

import org.jspecify.annotations.NullMarked;
