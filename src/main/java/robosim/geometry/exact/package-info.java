/** Numbers: exact signs and sums, angles in degrees, rotations. Knows no shapes. */
@NullMarked
package robosim.geometry.exact;

import org.jspecify.annotations.NullMarked;
