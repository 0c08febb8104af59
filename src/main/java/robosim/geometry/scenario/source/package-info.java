/** Where conversations come from, step by step: a file of a scenario, a live session, and the bytes of a connection. */
@NullMarked
package robosim.geometry.scenario.source;

import org.jspecify.annotations.NullMarked;
