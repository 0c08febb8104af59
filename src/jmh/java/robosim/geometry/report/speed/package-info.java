/** Speed against error: what is measured, the figures as lines, and the pages that are written from them alone. */
@NullMarked
package robosim.geometry.report.speed;

import org.jspecify.annotations.NullMarked;
