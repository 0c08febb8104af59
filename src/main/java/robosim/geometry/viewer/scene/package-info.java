/** What is to be seen from above: shapes and a map's frame. */
@NullMarked
package robosim.geometry.viewer.scene;

import org.jspecify.annotations.NullMarked;
