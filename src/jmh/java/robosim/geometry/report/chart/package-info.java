/** Plots as SVG that needs nothing else: axes at powers of ten, markers of several shapes, labels that keep apart. */
@NullMarked
package robosim.geometry.report.chart;

import org.jspecify.annotations.NullMarked;
