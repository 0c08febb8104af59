/** Trees of boxes in space for the triangles of a mesh, and the keys by which queries order boxes. */
@NullMarked
package robosim.geometry.index.boxes;

import org.jspecify.annotations.NullMarked;
