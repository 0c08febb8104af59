/** x */
@NullMarked
package robosim.geometry.model;

import org.jspecify.annotations.NullMarked;
