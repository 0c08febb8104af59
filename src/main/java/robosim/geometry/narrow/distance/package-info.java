/** How far two convex leaves are apart, and where they are nearest or in contact. */
@NullMarked
package robosim.geometry.narrow.distance;

import org.jspecify.annotations.NullMarked;
