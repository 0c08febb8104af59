/**
 * The module as a party of a RoboSim simulation: {@link robosim.geometry.net.GeometryClient} dials the environment,
 * {@link robosim.geometry.net.GeometryServer} waits for environments that dial in, and both hold the same
 * {@link robosim.geometry.net.Session}. Sockets live here.
 *
 * <p>Requests carry radians; this is the one place that turns them into the module's degrees.
 */
@NullMarked
package robosim.geometry.net;

import org.jspecify.annotations.NullMarked;
