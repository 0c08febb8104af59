/**
 * The narrow phase: one switch for each question about two placed leaves, which descends meshes and hands pairs of convex
 * leaves to the kernels in the rooms below; and what a mover stands on.
 */
@NullMarked
package robosim.geometry.narrow;

import org.jspecify.annotations.NullMarked;
