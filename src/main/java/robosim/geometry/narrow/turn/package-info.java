/** How far a leaf may turn beside another at rest, and the bounds of what moves. */
@NullMarked
package robosim.geometry.narrow.turn;

import org.jspecify.annotations.NullMarked;
