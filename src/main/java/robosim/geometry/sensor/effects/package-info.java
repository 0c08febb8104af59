/** What noise does to distances, and where its random numbers come from. */
@NullMarked
package robosim.geometry.sensor.effects;

import org.jspecify.annotations.NullMarked;
