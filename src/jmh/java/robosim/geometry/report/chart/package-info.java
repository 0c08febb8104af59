/** Axes of the report beside those of {@code robosim.geometry.chart}: powers of ten, to both sides of zero, and shares. */
@NullMarked
package robosim.geometry.report.chart;

import org.jspecify.annotations.NullMarked;
