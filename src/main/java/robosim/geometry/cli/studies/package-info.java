/** Commands that replay conversations and sweep over parameters. */
@NullMarked
package robosim.geometry.cli.studies;

import org.jspecify.annotations.NullMarked;
