/** Trees over boxes: which items may matter for a region, a ray or a point. Knows no shapes. */
@NullMarked
package robosim.geometry.index;

import org.jspecify.annotations.NullMarked;
