/**
 * The module as part of a RoboSim simulation: {@link robosim.geometry.net.GeometryClient} dials the environment, {@link
 * robosim.geometry.net.GeometryServer} serves environments that dial in, and both use the same {@link
 * robosim.geometry.net.Session}. All code that uses sockets is in this package.
 *
 * <ul>
 *   <li>{@link GeometryServer}: serves environments that dial in
 *   <li>{@link GeometryClient}: dials an environment and serves it
 *   <li>{@link NetOptions}: the options of both ends: who may connect, times, sizes
 *   <li>{@link Tls}: keys and certificates
 *   <li>{@link Session}: turns requests into answers; knows no sockets
 *   <li>{@link SessionOptions}: the world that a session makes where a request leaves it open
 *   <li>{@link SessionListener}: observes the requests and answers of a session
 *   <li>{@link FiguresMXBean}: what a server has done, over JMX
 * </ul>
 *
 * <p>Requests carry angles in radians; this package is the only place where they are converted to the module's degrees.
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
 * <p>{@code docs/guide-robosim.md} is the guide; {@code docs/server.md} says how to operate a server for days.
 */
@NullMarked
package robosim.geometry.net;

import org.jspecify.annotations.NullMarked;
