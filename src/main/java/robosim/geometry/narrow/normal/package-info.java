/** The normals of the faces that rays enter, of all kinds of leaves. */
@NullMarked
package robosim.geometry.narrow.normal;

import org.jspecify.annotations.NullMarked;
