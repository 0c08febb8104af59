/** Regions of the plane as a tree, queried nearest first. */
@NullMarked
package robosim.geometry.index.quadtree;

import org.jspecify.annotations.NullMarked;
