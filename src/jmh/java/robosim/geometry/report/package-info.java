/** What the module answers, held against truth and other engines, as tables that are written by one command each. */
@NullMarked
package robosim.geometry.report;

import org.jspecify.annotations.NullMarked;
