/**
 * The convex leaves of which all objects consist: their rows in flat columns, their bounds, outlines and enclosures,
 * and a walk over the triangles of a placed mesh.
 */
@NullMarked
package robosim.geometry.narrow.leaf;

import org.jspecify.annotations.NullMarked;
