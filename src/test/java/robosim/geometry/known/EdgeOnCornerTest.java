package robosim.geometry.known;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sweep.PlanarSweep;

/**
 * A known fault, kept so that whoever mends it notices: this asserts the wrong answer. In PLANAR a triangle touches a cylinder
 * of no height, seen edge on, corner on end, and leaves it: a line through the corner is between the two, and the motion leads
 * away from it. Of the directions of least depth, which are many at a corner, not this one is looked at, and it is refused.
 */
class EdgeOnCornerTest {
    @Test
    void aCornerThatLeavesTheEndOfADiscSeenEdgeOnIsRefused() {
        double[] triangle = {-1, 1, 0, -2, 0.75, -1.25, 0.25, -0.5, 1.5, 0, 0, 0, 0, 0, 0, 0};
        double[] disc = {-2.75, -2, -1.25, 0.75, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0
        }; // from x = -3.5 to -2, at z = -1.25
        double time = PlanarSweep.translation(
                LeafKind.TRIANGLE, triangle, 0, -1.25, 0, 0.5, LeafKind.CYLINDER, disc, 0, new Scratch());
        assertThat(time).isZero(); // right is infinite
    }
}
