/**
 * Indexes over boxes: {@link robosim.geometry.index.QuadTree} for the objects of a world, with tiles and regions of the
 * plane; {@link robosim.geometry.index.hierarchy.Hierarchy} for the objects of a world in space; and {@link
 * robosim.geometry.index.meshes.BoxTree} for the triangles of a mesh.
 *
 * <p>They handle numbers and boxes, not shapes. Boxes are closed and given rounded outward, so a query never misses
 * what it touches. A query's state is in a cursor that its owner keeps and reuses.
 */
@NullMarked
package robosim.geometry.index;

import org.jspecify.annotations.NullMarked;
