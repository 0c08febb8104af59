/**
 * The protocol: the bundles, under the names of RoboSim's report, their encodings, and limits on what a peer may send.
 * Without sockets.
 *
 * <ul>
 *   <li>{@link Bundle}: a message: a request or an answer
 *   <li>{@link InitBundle}: a new world, with {@link WorldSettings}
 *   <li>{@link MoveBundle}: moves, each a {@link MoveRequest}; answered by those that were made
 *   <li>{@link SonarRequestBundle}: sonars, each a {@link SonarRequest} with a {@link Beam}; answered by a {@link
 *       DistanceBundle}
 *   <li>{@link StepBundle}: lets time pass, as {@code docs/protocol.md} describes it
 *   <li>{@link BatchRequestBundle}: several requests in one message, as {@code docs/protocol.md} describes them;
 *       answered by a {@link BatchAnswerBundle}
 *   <li>{@link Reply}: an answer, and each {@link Problem} of its request
 *   <li>{@link MessageReader} and {@link MessageWriter}: messages from and to streams, in Java serialization
 *   <li>{@link MessageLimits}: how much a message may contain
 *   <li>{@link MessageTranslator}: messages in classes of your own
 *   <li>{@link ProtocolException}: bytes that are no message
 * </ul>
 *
 * <p>Lengths are world units. <b>Angles are in radians here</b>, as in RoboSim, while the rest of the module's API uses
 * degrees; {@code robosim.geometry.net.Session} is the one place that converts them. Objects carry rotations, not
 * angles.
 *
 * <p>The bundles are immutable records, and none can be created, not even by deserialization, that its constructor
 * would refuse.
 *
 * <pre>{@code
 * ByteArrayOutputStream wire = new ByteArrayOutputStream();
 * MoveBundle asked = new MoveBundle(List.of(new MoveRequest("robot", 1, 0, 0, 0, Math.PI / 2)));
 * new MessageWriter(wire).write(asked);
 * new MessageReader(new ByteArrayInputStream(wire.toByteArray())).read().equals(asked); // true
 * }</pre>
 *
 * <p>{@code docs/protocol.md} describes them byte by byte, and in JSON.
 */
@NullMarked
package robosim.geometry.protocol;

import org.jspecify.annotations.NullMarked;
