/**
 * Polytopes and cylinders by separating axes, at rest and moving, in doubles, in pairs of doubles and in exact numbers.
 */
@NullMarked
package robosim.geometry.narrow.sat;

import org.jspecify.annotations.NullMarked;
