/** The bundles as lines of JSON, for environments in any language; needs Jackson. */
@NullMarked
package robosim.geometry.protocol.json;

import org.jspecify.annotations.NullMarked;
