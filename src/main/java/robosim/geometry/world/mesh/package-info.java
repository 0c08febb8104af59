/** The surfaces of OBJ and STL files. */
@NullMarked
package robosim.geometry.world.mesh;

import org.jspecify.annotations.NullMarked;
