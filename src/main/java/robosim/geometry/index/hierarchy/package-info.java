/** The bounding-volume hierarchy over the objects of a world in space, and the queries that descend it. */
@NullMarked
package robosim.geometry.index.hierarchy;

import org.jspecify.annotations.NullMarked;
