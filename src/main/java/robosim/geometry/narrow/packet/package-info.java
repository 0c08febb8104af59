/** Many rays from one place against one leaf: which of them it may be the nearest for, in loops over plain arrays. */
@NullMarked
package robosim.geometry.narrow.packet;

import org.jspecify.annotations.NullMarked;
