/**
 * One step of many bodies: what is going to meet, when, what velocities come of it, and how all are carried there. Numbers by
 * index; names and values are above.
 */
@NullMarked
package robosim.geometry.dynamics.planar;

import org.jspecify.annotations.NullMarked;
