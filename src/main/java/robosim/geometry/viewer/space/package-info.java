/**
 * The world of a viewer in three dimensions, without a window: cameras, in which order a picture becomes fine, what is
 * drawn over it, and who renders it. Nothing here uses Swing.
 */
@NullMarked
package robosim.geometry.viewer.space;

import org.jspecify.annotations.NullMarked;
