/** The bodies of world files as requests, and robots that are driven through a world for a time, as a recorded conversation. */
@NullMarked
package robosim.geometry.scenario.drive;

import org.jspecify.annotations.NullMarked;
