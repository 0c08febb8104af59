package robosim.geometry.narrow.distance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlapTest;
import robosim.geometry.reference.PlanarTwin;

class PlanarContactTest {
    private final Scratch scratch = new Scratch();

    private double[] between(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        double[] out = new double[6];
        PlanarContact.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), out, scratch.distance);
        return out;
    }

    @Test
    void normalsAreOfUnitLengthAndTurnRoundWithTheOrder() {
        PlanarRows rows = new PlanarRows(61);
        int apart = 0;
        int count = Effort.cases(2100);
        for (int k = 0; k < count; k++) {
            LeafKind kindA = Leaves.KINDS[k % 7];
            LeafKind kindB = Leaves.KINDS[k / 7 % 7];
            double[] a = rows.row(kindA, 1, 1);
            double[] b = rows.row(kindB, 1, 1);
            double[] out = between(kindA, a, kindB, b);
            double[] back = between(kindB, b, kindA, a);
            String text = PlanarOverlapTest.pair(kindA, a, kindB, b);
            assertThat(StrictMath.hypot(out[3], out[5])).as(text).isBetween(1 - 1e-15, 1 + 1e-15);
            assertThat(out[4]).isZero();
            assertThat(new double[] {back[0], back[1], back[2], 0 - back[3], back[4], 0 - back[5]})
                    .as(text)
                    .containsExactly(out);
            // Along the normal they are as far apart, or as shallow, as along any other.
            PlanarTwin p = PlanarRows.twin(kindA, a);
            PlanarTwin q = PlanarRows.twin(kindB, b);
            double gap = q.lines(p, out[3], out[5]);
            double best = p.partedRoughly(q);
            assertThat(gap).as(text).isGreaterThanOrEqualTo(best - 1e-4);
            apart += gap > 0 ? 1 : 0;
            // The point is between the two, or in both, to within what parts them.
            double near = Math.abs(gap) / 2 + 1e-4;
            assertThat(outside(p, out)).as(text).isLessThanOrEqualTo(near);
            assertThat(outside(q, out)).as(text).isLessThanOrEqualTo(near);
        }
        assertThat(apart).isBetween(count * 3 / 10, count * 7 / 10);
    }

    @Test
    void sideOnSideTouchesInTheMiddleOfWhatTheyShare() {
        double[] wall = {0, 0, 0, 5, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        PlanarRows.upright(wall, 0);
        double[] robot = {4.5, 1, 2, 1, 0.5, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        PlanarRows.upright(robot, 90);
        // x: 3.5 to 5 is shared; y: 0.5 to 1.5; z: the wall's side
        assertThat(between(LeafKind.UPRIGHT_BOX, robot, LeafKind.UPRIGHT_BOX, wall))
                .containsExactly(4.25, 1, 1, 0, 0, 1);
        double[] disc = {-2, 0, -1.5, 0.5, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        assertThat(between(LeafKind.UPRIGHT_CYLINDER, disc, LeafKind.UPRIGHT_BOX, wall))
                .containsExactly(-2, 0, -1, 0, 0, -1);
    }

    private static double outside(PlanarTwin twin, double[] out) {
        return Math.max(0, PlanarRows.point(out[0], out[2]).partedRoughly(twin));
    }
}
