/** What the formats share: safe opening of files, numbers in text, nested frames, limits, and located problems. */
@NullMarked
package robosim.geometry.world.shared;

import org.jspecify.annotations.NullMarked;
