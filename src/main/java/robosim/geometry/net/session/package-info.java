/** What a session keeps and says: its world, reasons, and a log of bearable length. */
@NullMarked
package robosim.geometry.net.session;

import org.jspecify.annotations.NullMarked;
