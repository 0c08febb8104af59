/** The cells of a grid: how far each is from an occupied one, and walks over those that a query may meet. */
@NullMarked
package robosim.geometry.index.cells;

import org.jspecify.annotations.NullMarked;
