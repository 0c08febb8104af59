/** Trees of boxes in space: of a mesh's triangles, and of what is stacked. */
@NullMarked
package robosim.geometry.index.boxes;

import org.jspecify.annotations.NullMarked;
