/** Files that show a world in three dimensions without this module: a page for browsers that plays a recording, and glTF. */
@NullMarked
package robosim.geometry.export;

import org.jspecify.annotations.NullMarked;
