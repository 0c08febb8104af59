/** What world files say about how objects move and what they are like to touch: bodies, surfaces and drives. */
@NullMarked
package robosim.geometry.world.body;

import org.jspecify.annotations.NullMarked;
