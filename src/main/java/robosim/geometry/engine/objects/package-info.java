/** The objects of a world: names, ids and places; and the world's bounds. */
@NullMarked
package robosim.geometry.engine.objects;

import org.jspecify.annotations.NullMarked;
