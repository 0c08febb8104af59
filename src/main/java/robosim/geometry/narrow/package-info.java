/**
 * The narrow phase: one switch over leaf kinds for each kind of query about two placed leaves, which descends into
 * meshes and passes pairs of convex leaves to the kernels in the packages below; and the contacts of a mover at its
 * start.
 */
@NullMarked
package robosim.geometry.narrow;

import org.jspecify.annotations.NullMarked;
