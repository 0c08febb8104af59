/** Discs and polygons in the plane: exact and certified decisions about projections, and about moving discs. */
@NullMarked
package robosim.geometry.narrow.planar;

import org.jspecify.annotations.NullMarked;
