/** The lines of a file of results: their names, check sums and digests. */
@NullMarked
package robosim.geometry.sweep.lines;

import org.jspecify.annotations.NullMarked;
