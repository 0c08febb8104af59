/**
 * Pictures of a world from above: one painter that draws to SVG text and to an image, the same both times.
 *
 * <p>The world's X runs to the right and its Z down the page, as seen looking down along Y: nothing is mirrored, and a
 * positive turn is counter-clockwise on the page too. The same scene gives the same SVG, byte for byte.
 */
@NullMarked
package robosim.geometry.viewer.draw;

import org.jspecify.annotations.NullMarked;
