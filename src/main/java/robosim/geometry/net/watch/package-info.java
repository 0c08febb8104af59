/** A second port of a server, on which anyone may watch its sessions, and the other end of it. */
@NullMarked
package robosim.geometry.net.watch;

import org.jspecify.annotations.NullMarked;
