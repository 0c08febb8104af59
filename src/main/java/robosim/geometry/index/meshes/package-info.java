/** Trees over the boxes of a mesh's triangles, and how boxes are split. */
@NullMarked
package robosim.geometry.index.meshes;

import org.jspecify.annotations.NullMarked;
