/** Occupancy maps of ROS: settings, images, and walls made of their cells. */
@NullMarked
package robosim.geometry.world.rosmap;

import org.jspecify.annotations.NullMarked;
