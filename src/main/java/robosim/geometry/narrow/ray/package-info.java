/** Where a ray meets a leaf, and the face that it meets. */
@NullMarked
package robosim.geometry.narrow.ray;

import org.jspecify.annotations.NullMarked;
