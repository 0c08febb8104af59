/** The bytes of one connection among many: turns, room for large messages and worlds, and who lets others wait too long. */
@NullMarked
package robosim.geometry.net.pace;

import org.jspecify.annotations.NullMarked;
