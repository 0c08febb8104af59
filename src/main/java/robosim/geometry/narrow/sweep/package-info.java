/** When a leaf that moves straight on meets another at rest. */
@NullMarked
package robosim.geometry.narrow.sweep;

import org.jspecify.annotations.NullMarked;
