/** Trees of boxes in space: for the triangles of a mesh, and for stacked objects. */
@NullMarked
package robosim.geometry.index.boxes;

import org.jspecify.annotations.NullMarked;
