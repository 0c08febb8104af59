/** Millions of steps of small adversarial worlds, judged by other means than those of the step. */
@NullMarked
package robosim.geometry.dynamics.proof;

import org.jspecify.annotations.NullMarked;
