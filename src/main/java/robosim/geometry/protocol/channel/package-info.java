/** Both directions of one connection, in the encoding that its peer speaks; no sockets. */
@NullMarked
package robosim.geometry.protocol.channel;

import org.jspecify.annotations.NullMarked;
