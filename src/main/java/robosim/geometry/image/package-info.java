/** Pictures as files: PNG of 8 and 16 bits, written and read with nothing but java.base. */
@NullMarked
package robosim.geometry.image;

import org.jspecify.annotations.NullMarked;
