/** Where a ray hits a leaf, and the face that it hits. */
@NullMarked
package robosim.geometry.narrow.ray;

import org.jspecify.annotations.NullMarked;
