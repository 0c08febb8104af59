/**
 * Trees over boxes: {@link robosim.geometry.index.QuadTree} for what is in a world, over tiles and regions of the plane;
 * {@link robosim.geometry.index.boxes.OctTree} for what is stacked in space, and
 * {@link robosim.geometry.index.boxes.BoxTree} for the triangles of a mesh.
 *
 * <p>They know numbers and boxes, no shapes. Boxes are closed and given as already rounded outward, so a query never loses
 * what it touches. A tree is never changed by a query; a query's state is in a cursor that its owner keeps and reuses.
 */
@NullMarked
package robosim.geometry.index;

import org.jspecify.annotations.NullMarked;
