/**
 * Polytopes and cylinders by separating axes, at rest and moving, in doubles, in pairs of doubles and in exact
 * arithmetic; and the exact features, extents and planes that other packages decide with.
 */
@NullMarked
package robosim.geometry.narrow.sat;

import org.jspecify.annotations.NullMarked;
