/** Beams, scans and proximity. */
@NullMarked
package robosim.geometry.engine.sensing;

import org.jspecify.annotations.NullMarked;
