package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** A corner of the plane's straight sweeps; the census has their random cases, in every regime. */
class PlanarSweepTest {
    private final Scratch scratch = new Scratch();

    /** Of the many directions of least depth at a corner, the one along the disc is free. */
    @Test
    void aCornerLeavesTheEndOfADiscSeenEdgeOn() {
        double[] triangle = {-1, 1, 0, -2, 0.75, -1.25, 0.25, -0.5, 1.5, 0, 0, 0, 0, 0, 0, 0};
        double[] disc = {-2.75, -2, -1.25, 0.75, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0
        }; // from x = -3.5 to -2, at z = -1.25
        for (double[] free : new double[][] {{-1.25, 0.5}, {-1, 0}, {1, 0}, {0, 1}, {1, -1}, {4, -4.5}}) {
            double time = PlanarSweep.translation(
                    new Leaf(LeafKind.TRIANGLE, triangle, 0),
                    free[0],
                    0,
                    free[1],
                    new Leaf(LeafKind.CYLINDER, disc, 0),
                    scratch.sweep);
            assertThat(time).as(Arrays.toString(free)).isInfinite();
        }
        for (double[] into : new double[][] {{-1, -0.1}, {-2, -1}}) {
            double time = PlanarSweep.translation(
                    new Leaf(LeafKind.TRIANGLE, triangle, 0),
                    into[0],
                    0,
                    into[1],
                    new Leaf(LeafKind.CYLINDER, disc, 0),
                    scratch.sweep);
            assertThat(time).as(Arrays.toString(into)).isZero();
        }
    }
}
