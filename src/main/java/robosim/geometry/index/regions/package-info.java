/** Regions of the plane, nearest first. */
@NullMarked
package robosim.geometry.index.regions;

import org.jspecify.annotations.NullMarked;
