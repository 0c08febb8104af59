/** Whether two convex leaves have a point in common. */
@NullMarked
package robosim.geometry.narrow.overlap;

import org.jspecify.annotations.NullMarked;
