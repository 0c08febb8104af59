/** One attempt to move an object: its legs, what blocks them, and how far they are free. */
@NullMarked
package robosim.geometry.engine.motion;

import org.jspecify.annotations.NullMarked;
