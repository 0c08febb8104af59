/** The world that {@link robosim.geometry.Geometry} wraps: its objects, and what moves and senses them. */
@NullMarked
package robosim.geometry.engine;

import org.jspecify.annotations.NullMarked;
