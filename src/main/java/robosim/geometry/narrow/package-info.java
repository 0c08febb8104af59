/** The narrow phase: questions about two convex leaves, answered by one kernel for each family of pairs. */
@NullMarked
package robosim.geometry.narrow;

import org.jspecify.annotations.NullMarked;
