/** What a connection learns from its reader: whether a pause would be between two messages or inside one. */
@NullMarked
package robosim.geometry.protocol.pace;

import org.jspecify.annotations.NullMarked;
