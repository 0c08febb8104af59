/** What to know about a world before robots run in it: contacts, rooms, and which accuracy is sufficient. */
@NullMarked
package robosim.geometry.world.check;

import org.jspecify.annotations.NullMarked;
