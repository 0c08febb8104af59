/** The demo. */
@NullMarked
package robosim.geometry.cli.demo;

import org.jspecify.annotations.NullMarked;
