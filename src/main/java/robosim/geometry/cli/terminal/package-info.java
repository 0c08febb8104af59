/** What all commands share: exit codes, inputs, progress and words. */
@NullMarked
package robosim.geometry.cli.terminal;

import org.jspecify.annotations.NullMarked;
