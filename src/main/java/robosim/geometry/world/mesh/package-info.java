/** The surfaces of OBJ, STL and COLLADA files. */
@NullMarked
package robosim.geometry.world.mesh;

import org.jspecify.annotations.NullMarked;
