/** The bytes of recordings: files that can be cut back, and checksums of their lines. */
@NullMarked
package robosim.geometry.scenario.recording;

import org.jspecify.annotations.NullMarked;
