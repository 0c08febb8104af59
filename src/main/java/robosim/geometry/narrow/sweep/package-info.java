/** How far a leaf that moves straight on or turns may go next to another at rest, and the bounds of moving leaves. */
@NullMarked
package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.NullMarked;
