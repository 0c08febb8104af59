/** The view from above: shapes, labels, bounds, and a map's frame. */
@NullMarked
package robosim.geometry.viewer.scene;

import org.jspecify.annotations.NullMarked;
