/** Checks of arguments, and numbers and names as messages print them. Internal. */
@NullMarked
package robosim.geometry.check;

import org.jspecify.annotations.NullMarked;
