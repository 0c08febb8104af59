/** Rigid bodies in space: contacts, impulses, and ways that are decided exactly. Not exported. */
@NullMarked
package robosim.geometry.dynamics.space;

import org.jspecify.annotations.NullMarked;
