/** What there is to know of a world before robots are let loose in it: contacts, rooms, and which accuracy is enough. */
@NullMarked
package robosim.geometry.world.check;

import org.jspecify.annotations.NullMarked;
