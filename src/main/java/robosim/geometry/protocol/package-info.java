/**
 * What goes over the wire: the bundles under the report's names, their encoding and how much a peer may ask. No sockets.
 *
 * <p>Lengths are world units. <b>Angles are radians here</b>, as RoboSim speaks them, while the rest of the module's API
 * is in degrees; {@code robosim.geometry.net.Session} converts, in one place. Objects carry rotations, not angles.
 *
 * <p>The bundles are immutable records: none can exist that its constructor would refuse, however it was made.
 */
@NullMarked
package robosim.geometry.protocol;

import org.jspecify.annotations.NullMarked;
