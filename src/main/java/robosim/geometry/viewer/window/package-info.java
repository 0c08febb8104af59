/** The viewer's window; all code that uses Swing is here. */
@NullMarked
package robosim.geometry.viewer.window;

import org.jspecify.annotations.NullMarked;
