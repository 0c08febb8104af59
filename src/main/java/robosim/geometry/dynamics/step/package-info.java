/**
 * One step of many bodies: what is going to meet, when, what velocities come of it, and how all are carried there. Numbers by
 * index; names and values are above.
 */
@NullMarked
package robosim.geometry.dynamics.step;

import org.jspecify.annotations.NullMarked;
