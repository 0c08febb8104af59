/** Commands that serve and connect. */
@NullMarked
package robosim.geometry.cli.network;

import org.jspecify.annotations.NullMarked;
