/** A conversation as states that are played, stepped and drawn. */
@NullMarked
package robosim.geometry.viewer.playback;

import org.jspecify.annotations.NullMarked;
