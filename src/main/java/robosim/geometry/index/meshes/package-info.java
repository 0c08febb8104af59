/** Trees over the boxes of a mesh's triangles, how boxes are split, and the keys by which queries in the plane order them. */
@NullMarked
package robosim.geometry.index.meshes;

import org.jspecify.annotations.NullMarked;
