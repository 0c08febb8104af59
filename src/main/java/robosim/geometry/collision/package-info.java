/** Questions about two objects, or a ray and an object, outside any world. */
@NullMarked
package robosim.geometry.collision;

import org.jspecify.annotations.NullMarked;
