/** A world of objects, and the answers to where an object may be, how far it may move and what is next. */
@NullMarked
package robosim.geometry;

import org.jspecify.annotations.NullMarked;
