/** Meshes: rays, cones and pairs over their trees. */
@NullMarked
package robosim.geometry.narrow.mesh;

import org.jspecify.annotations.NullMarked;
