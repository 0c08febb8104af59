/**
 * What goes over the wire: the bundles under the report's names, their encoding and how much a peer may ask. No sockets.
 *
 * <p>Lengths are world units. <b>Angles are radians here</b>, as RoboSim speaks them, while the rest of the module's API
 * is in degrees; {@code robosim.geometry.net.Session} converts, in one place. Objects carry rotations, not angles.
 *
 * <p>The bundles are immutable records: none can exist that its constructor would refuse, however it was made.
 *
 * <pre>{@code
 * ByteArrayOutputStream wire = new ByteArrayOutputStream();
 * MoveBundle asked = new MoveBundle(List.of(new MoveRequest("robot", 1, 0, 0, 0, Math.PI / 2)));
 * new MessageWriter(wire).write(asked);
 * new MessageReader(new ByteArrayInputStream(wire.toByteArray())).read().equals(asked); // true
 * }</pre>
 *
 * <p>{@code docs/protocol.md} tells what they mean, byte by byte, and how they look in JSON.
 */
@NullMarked
package robosim.geometry.protocol;

import org.jspecify.annotations.NullMarked;
