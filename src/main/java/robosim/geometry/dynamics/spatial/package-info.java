/** Rigid bodies in space: contacts, impulses, and ways that are decided exactly. Not exported. */
@NullMarked
package robosim.geometry.dynamics.spatial;

import org.jspecify.annotations.NullMarked;
