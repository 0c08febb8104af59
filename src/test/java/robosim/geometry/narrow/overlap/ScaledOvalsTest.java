package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Kernels ask about overlaps of leaves that are scaled up already, but may still be small beside the rest of the query. */
class ScaledOvalsTest {
    @Test
    void anOverlapLeavesWhatIsScaledUpAsItIs() {
        double unit = 0x1p-500;
        double[] row = {unit, 0, 0, unit, 2 * unit, 0, 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1, 0};
        OverlapScratch s = new Scratch().overlap;
        assertThat(s.leaf.scaling.take(
                        Dimension.PLANAR,
                        0x1p-300,
                        new Leaf(LeafKind.CYLINDER, row, 0),
                        new Leaf(LeafKind.CYLINDER, row, 0)))
                .isTrue();
        double[] before = s.leaf.scaling.a.clone();
        double length = s.leaf.scaling.up(0x1p-300);
        assertThat(PlanarOverlap.test(s.leaf.scaling.first, s.leaf.scaling.second, s))
                .isTrue();
        assertThat(s.leaf.scaling.a).isEqualTo(before);
        assertThat(s.leaf.scaling.up(0x1p-300)).isEqualTo(length);
    }
}
