/**
 * Numbers: exact signs, compensated sums, angles in degrees, rotations.
 *
 * <p>Every finite double is a whole number times a power of two, so sums, differences and products of doubles have
 * exact values. {@link robosim.geometry.exact.Expansion} holds such a value as a sum of doubles and is fast while the
 * exponents allow it; {@link robosim.geometry.exact.Dyadic} holds it as a big integer and always works.
 */
@NullMarked
package robosim.geometry.exact;

import org.jspecify.annotations.NullMarked;
