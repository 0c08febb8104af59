package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.narrow.distance.PlanarDistance;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.ray.PlanarRay;

class PlanarAllocationTest {
    /** Random rows are never in doubt, so that the exact path (which allocates) stays out of it. */
    @Test
    void planarQuestionsAllocateNothing() {
        int rounds = 200;
        double[][] rows = new double[7 * rounds][];
        PlanarRows make = new PlanarRows(71);
        for (int k = 0; k < rows.length; k++) {
            rows[k] = make.row(Leaves.KINDS[k % 7], 1, 1);
            if (Leaves.KINDS[k % 7] == LeafKind.TRIANGLE) {
                rows[k][3] += 1; // none that is a segment
            }
        }
        Scratch scratch = new Scratch();
        assertThat(ask(rows, scratch)).isGreaterThan(0);
        long bytes = Allocated.everyTime(() -> ask(rows, scratch));
        assertThat(bytes / (4.0 * rows.length)).isLessThan(1);
    }

    private final Leaf one = new Leaf();
    private final Leaf two = new Leaf();

    private double ask(double[][] rows, Scratch scratch) {
        double sum = 0;
        BeamAxis beam = new BeamAxis();
        for (int k = 0; k < rows.length; k++) {
            LeafKind kind = Leaves.KINDS[k % 7];
            int m = (k * 31 + 5) % rows.length;
            LeafKind other = Leaves.KINDS[m % 7];
            one.set(kind, rows[k], 0);
            two.set(other, rows[m], 0);
            sum += PlanarOverlap.test(one, two, scratch.overlap) ? 1 : 0;
            sum += PlanarDistance.between(one, two, scratch.distance);
            sum += Math.min(9, PlanarRay.distance(beam.line(-3, 0, 0.1, 1, 0, 0), kind, rows[k], 0, scratch.ray));
            sum += Math.min(
                    9,
                    PlanarCone.distance(
                            beam.line(-3, 0, 0.1, 1, 0, 0).widen(0.96, 0.28),
                            kind,
                            rows[k],
                            0,
                            Double.POSITIVE_INFINITY,
                            scratch.cone));
        }
        return sum;
    }
}
