/** Both directions of one connection, in the encoding of its peer; no sockets. */
@NullMarked
package robosim.geometry.protocol.channel;

import org.jspecify.annotations.NullMarked;
