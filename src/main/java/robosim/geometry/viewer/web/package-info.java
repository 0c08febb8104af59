/**
 * The viewer: the page of {@code export}, served on a port of its own, which follows what happens and, where that is permitted,
 * controls it. The only room beside the command line that uses the JDK's HTTP server.
 */
@NullMarked
package robosim.geometry.viewer.web;

import org.jspecify.annotations.NullMarked;
