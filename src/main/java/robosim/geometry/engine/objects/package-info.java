/** Who is in a world: names, numbers, places, and the world's bounds. */
@NullMarked
package robosim.geometry.engine.objects;

import org.jspecify.annotations.NullMarked;
