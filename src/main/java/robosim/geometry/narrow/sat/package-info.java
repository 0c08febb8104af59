/**
 * Polytopes and cylinders by separating axes, at rest and moving, in doubles, in pairs of doubles and in exact numbers; and
 * the exact features, extents and planes that other rooms decide by.
 */
@NullMarked
package robosim.geometry.narrow.sat;

import org.jspecify.annotations.NullMarked;
