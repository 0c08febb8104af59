/** Plots as SVG that needs nothing else: axes with round marks, markers of several shapes, labels that keep apart. */
@NullMarked
package robosim.geometry.chart;

import org.jspecify.annotations.NullMarked;
