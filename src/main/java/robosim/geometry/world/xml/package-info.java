/** Parsing of untrusted XML, within limits. */
@NullMarked
package robosim.geometry.world.xml;

import org.jspecify.annotations.NullMarked;
