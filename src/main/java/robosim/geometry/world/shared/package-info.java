/** What the formats share: files opened with care, numbers of a text, frames within frames, limits, and what is wrong where. */
@NullMarked
package robosim.geometry.world.shared;

import org.jspecify.annotations.NullMarked;
