/**
 * The module as a party of a RoboSim simulation: {@link robosim.geometry.net.GeometryClient} dials the environment,
 * {@link robosim.geometry.net.GeometryServer} waits for environments that dial in, and both hold the same
 * {@link robosim.geometry.net.Session}. Sockets live here.
 *
 * <p>Requests carry radians; this is the one place that turns them into the module's degrees.
 *
 * <pre>{@code
 * try (GeometryServer server = new GeometryServer(0);
 *         Socket socket = new Socket("localhost", server.port())) {
 *     MessageWriter out = new MessageWriter(socket.getOutputStream());
 *     MessageReader in = new MessageReader(socket.getInputStream());
 *     out.write(new InitBundle(List.of(
 *             new BoxObject(new Point(3, 0, 0), 0.2, 2, 4),
 *             new CylinderObject(new Point(0, 0, 0), 0.25, 1).moveable("robot"))));
 *     out.write(new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0))));
 *     ((DistanceBundle) in.read()).distances().get(0).doubleValue(); // 2.9
 * }
 * }</pre>
 *
 * <p>{@code docs/guide-robosim.md} is the guide, {@code docs/server.md} tells how to operate a server for days.
 */
@NullMarked
package robosim.geometry.net;

import org.jspecify.annotations.NullMarked;
