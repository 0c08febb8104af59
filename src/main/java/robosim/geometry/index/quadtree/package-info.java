/** Regions of the plane as a tree, searched nearest first. */
@NullMarked
package robosim.geometry.index.quadtree;

import org.jspecify.annotations.NullMarked;
