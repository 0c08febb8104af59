/** How far a leaf may turn next to another at rest, and the bounds of moving leaves. */
@NullMarked
package robosim.geometry.narrow.turn;

import org.jspecify.annotations.NullMarked;
