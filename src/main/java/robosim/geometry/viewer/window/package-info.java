/** The window; all Swing is here. */
@NullMarked
package robosim.geometry.viewer.window;

import org.jspecify.annotations.NullMarked;
