/**
 * Convex sets by their support functions: distance (Gilbert, Johnson and Keerthi 1988), penetration, and certain
 * overlap.
 */
@NullMarked
package robosim.geometry.narrow.gjk;

import org.jspecify.annotations.NullMarked;
