/**
 * The hard cases, as data: questions that engines have answered wrongly, each with its source, in files that a person can
 * read and extend, and what runs them.
 */
@NullMarked
package robosim.geometry.cases;

import org.jspecify.annotations.NullMarked;
