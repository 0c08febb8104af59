/** The nearest point of a leaf within a cone, or within a sector in the plane. */
@NullMarked
package robosim.geometry.narrow.cone;

import org.jspecify.annotations.NullMarked;
