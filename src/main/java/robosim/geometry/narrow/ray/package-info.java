/** Where a ray hits a leaf. */
@NullMarked
package robosim.geometry.narrow.ray;

import org.jspecify.annotations.NullMarked;
