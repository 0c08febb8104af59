/** Commands about world files: check, convert, render, view. */
@NullMarked
package robosim.geometry.cli.worlds;

import org.jspecify.annotations.NullMarked;
