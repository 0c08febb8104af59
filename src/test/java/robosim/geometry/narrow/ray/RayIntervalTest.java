package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.RayOracle;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

class RayIntervalTest {
    private final Scratch scratch = new Scratch();

    /** Three sides are entered at 1 but for rounding: the last of them by 20 ulp. */
    @Test
    void ofSidesThatAreAllButTiedTheLastCounts() {
        double[] row = Rows.box(
                2.4103244485661182E11,
                6.307007919528931E11,
                5.509630389234287E11,
                4.1811368363431055E11,
                8.398721280197705E11,
                2.348327322602965E11,
                new double[] {
                    0.8518428244476453, 0, 0.5237974822744553, 0, 1, 0, -0.5237974822744553, 0, 0.8518428244476453
                });
        double[] o = {-1.9954872246176206E12, -2.2379826858134766E12, 1.6386325936302646E12};
        double[] d = {1.7573477343533975E12, 2.028811349746599E12, -1.0687032378360546E12};
        assertThat(ulps(o, d, LeafKind.UPRIGHT_BOX, row)).isLessThanOrEqualTo(4);
    }

    /** Rays at a corner of a box, so that sides tie. */
    @Test
    void raysAtCornersAreAsGoodAsAny() {
        SplittableRandom random = new SplittableRandom(5);
        double worst = 0;
        int met = 0;
        for (int n = 0; n < 700; n++) {
            boolean upright = random.nextBoolean();
            double[] r = upright ? Rows.yaw(random.nextDouble(7)) : Rows.rotation(random);
            double[] row = Rows.box(
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(),
                    random.nextDouble(),
                    random.nextDouble(),
                    r);
            double[] o = {random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9)};
            double[] d = new double[3];
            int sides = random.nextInt(8);
            for (int axis = 0; axis < 3; axis++) {
                double corner = row[axis];
                for (int k = 0; k < 3; k++) {
                    corner += (sides >> k & 1) == 0 ? row[3 + k] * r[3 * axis + k] : -row[3 + k] * r[3 * axis + k];
                }
                d[axis] = corner - o[axis];
            }
            double off = ulps(o, d, upright ? LeafKind.UPRIGHT_BOX : LeafKind.BOX, row);
            met += Double.isNaN(off) ? 0 : 1;
            worst = Math.max(worst, Double.isNaN(off) ? 0 : off);
        }
        assertThat(worst).isLessThanOrEqualTo(4);
        assertThat(met).isBetween(200, 690);
    }

    // How far the distance is off, in ulp of the largest of it and the coordinates; NaN where both miss.
    private double ulps(double[] o, double[] d, LeafKind kind, double[] row) {
        double distance =
                SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
        BigDecimal truth = RayOracle.distance(o, d, kind, row);
        assertThat(distance < Double.POSITIVE_INFINITY).isEqualTo(truth != null);
        if (truth == null) {
            return Double.NaN;
        }
        double largest = distance;
        for (int k = 0; k < 3; k++) {
            largest = Math.max(largest, Math.max(Math.abs(o[k]), Math.max(Math.abs(row[k]), row[3 + k])));
        }
        return new BigDecimal(distance).subtract(truth).abs().doubleValue() / Math.ulp(largest);
    }
}
