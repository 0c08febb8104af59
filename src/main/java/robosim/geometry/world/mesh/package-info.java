/** The surfaces of OBJ, STL, COLLADA, PLY and glTF files. */
@NullMarked
package robosim.geometry.world.mesh;

import org.jspecify.annotations.NullMarked;
