package robosim.geometry.narrow.planar;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.exact.StageCounters;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.PlanarOverlapTest;

/** Boxes and discs that all but touch, as big decimals see them. */
class DoubleDoubleOverlapTest {
    private static final double U2 = 0x1p-106;

    private final Scratch scratch = new Scratch();
    private final PlanarRows rows = new PlanarRows(31);

    private static BigDecimal cross(BigDecimal ax, BigDecimal az, double bx, double bz) {
        return ax.multiply(new BigDecimal(bz)).subtract(az.multiply(new BigDecimal(bx)));
    }

    private static BigDecimal difference(double p, double q) {
        return new BigDecimal(p).subtract(new BigDecimal(q));
    }

    private static BigDecimal gapAlong(double gx, double gz, double[] a, double[] b) {
        BigDecimal gap =
                cross(difference(a[0], b[0]), difference(a[2], b[2]), gx, gz).abs();
        for (double[] row : new double[][] {a, b}) {
            for (int k = 0; k < 3; k++) {
                BigDecimal side = cross(new BigDecimal(row[6 + k]), new BigDecimal(row[12 + k]), gx, gz);
                gap = gap.subtract(side.abs().multiply(new BigDecimal(row[3 + k])));
            }
        }
        return gap;
    }

    private static BigDecimal squaresOfDisc(double[] disc, double[] box) {
        BigDecimal dx = difference(disc[0], box[0]);
        BigDecimal dz = difference(disc[2], box[2]);
        BigDecimal square = cross(new BigDecimal(box[6]), new BigDecimal(-box[8]), box[8], box[6]);
        BigDecimal x = cross(dx, dz, box[8], box[6]).abs().subtract(square.multiply(new BigDecimal(box[3])));
        BigDecimal z = cross(dx, dz, -box[6], box[8]).abs().subtract(square.multiply(new BigDecimal(box[5])));
        x = x.max(BigDecimal.ZERO);
        z = z.max(BigDecimal.ZERO);
        BigDecimal radius = new BigDecimal(disc[3]);
        return x.multiply(x).add(z.multiply(z)).subtract(radius.multiply(radius).multiply(square));
    }

    // The axes are of unit length to rounding.
    private static double boundOfSquares(double[] disc, double[] box, double gap) {
        double near = disc[3] * disc[3];
        double beyond = Math.max(0, gap + near);
        double error = 12 * U2 * (offset(disc, box) + box[3] + box[5]);
        return 2 * error * (Math.sqrt(2 * beyond) + error) + 20 * U2 * (beyond + near) + Double.MIN_NORMAL;
    }

    private BigDecimal value() {
        return new BigDecimal(scratch.planar.fine.value.hi).add(new BigDecimal(scratch.planar.fine.value.lo));
    }

    private static double offset(double[] a, double[] b) {
        return Math.abs(a[0] - b[0]) + Math.abs(a[2] - b[2]);
    }

    /** What is beyond the bound has the right sign, and the bound is no more than twenty times what rounding does. */
    @Test
    void theGapOfTwoBoxesIsWithinItsBound() {
        double worst = 0;
        for (int k = 0; k < Effort.cases(20_000); k++) {
            double[] a = rows.row(k % 2 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.BOX, 1, 1);
            double[] b = rows.row(k % 3 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.BOX, k % 5 == 0 ? 1e6 : 1, 1);
            double gx = a[6];
            double gz = a[12];
            int side = scratch.planar.fine.along(gx, gz, a, 0, b, 0);
            BigDecimal truth = gapAlong(gx, gz, a, b);
            double sizes = offset(a, b) + a[3] + a[4] + a[5] + b[3] + b[4] + b[5];
            double error = value().subtract(truth).doubleValue();
            worst = Math.max(worst, Math.abs(error) / (32 * U2 * sizes * (Math.abs(gx) + Math.abs(gz))));
            assertThat(side * truth.signum()).isGreaterThanOrEqualTo(0);
        }
        assertThat(worst).isBetween(0.05, 1.0);
    }

    @Test
    void theSquaresOfADiscAndABoxAreWithinTheirBound() {
        double worst = 0;
        for (int k = 0; k < Effort.cases(20_000); k++) {
            double[] disc = rows.row(LeafKind.SPHERE, k % 5 == 0 ? 1e6 : 1, 1);
            double[] box = rows.row(LeafKind.UPRIGHT_BOX, 1, 1);
            int side = scratch.planar.fine.discRectangle(disc[0], disc[2], disc[3], box, 0);
            BigDecimal truth = squaresOfDisc(disc, box);
            double error = value().subtract(truth).doubleValue();
            worst = Math.max(worst, Math.abs(error) / boundOfSquares(disc, box, truth.doubleValue()));
            assertThat(side * truth.signum()).isGreaterThanOrEqualTo(0);
        }
        assertThat(worst).isBetween(0.05, 1.0);
    }

    /** Brought to the last step before contact: the filters doubt, pairs of doubles tell, and what is a tie is exact. */
    @Test
    void neighboursAcrossTheContactAreToldInPairsOrExactly() {
        StageCounters.Counter[] fine = counters(" fine");
        StageCounters.Counter[] exact = counters("");
        LeafKind[] kinds = {LeafKind.UPRIGHT_BOX, LeafKind.SPHERE, LeafKind.BOX};
        long fineBefore = total(fine);
        long exactBefore = total(exact);
        int asked = 0;
        int hits = 0;
        for (int k = 0; k < Effort.cases(3000); k++) {
            LeafKind kindA = kinds[k % 3];
            LeafKind kindB = kinds[k / 3 % 3];
            double factor = Math.scalb(1.0, 20 * rows.random().nextInt(-2, 3));
            double[] a = PlanarRows.scaled(kindA, rows.row(kindA, k % 4 == 0 ? 1e6 : 1, 1), factor);
            double[] b = PlanarRows.scaled(kindB, rows.row(kindB, 0, 1), factor);
            b[0] = a[0];
            b[2] = a[2];
            double in = b[0];
            double out = b[0] + 8 * factor;
            while (Math.nextUp(in) < out) {
                b[0] = in + (out - in) / 2;
                if (PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap)) {
                    in = b[0];
                } else {
                    out = b[0];
                }
            }
            for (int step = -1; step <= 2; step++) {
                b[0] = in + step * Math.ulp(in);
                boolean touches = PlanarOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
                boolean truth = PlanarRows.touch(kindA, a, kindB, b);
                assertThat(touches)
                        .as(() -> PlanarOverlapTest.pair(kindA, a, kindB, b))
                        .isEqualTo(truth);
                hits += truth ? 1 : 0;
                asked++;
            }
        }
        assertThat(hits).isBetween(asked * 3 / 10, asked * 7 / 10);
        assertThat(total(fine) - fineBefore).isGreaterThan(asked);
        assertThat(total(exact) - exactBefore).isBetween(10L, asked / 10L);
    }

    private static StageCounters.Counter[] counters(String end) {
        String[] kernels = {"RectangleRectangle", "ZonogonZonogon", "DiscRectangle", "DiscDisc"};
        StageCounters.Counter[] counters = new StageCounters.Counter[kernels.length];
        for (int k = 0; k < kernels.length; k++) {
            counters[k] = StageCounters.counter(kernels[k] + end);
        }
        return counters;
    }

    private static long total(StageCounters.Counter[] counters) {
        long total = 0;
        for (StageCounters.Counter counter : counters) {
            total += counter.total();
        }
        return total;
    }
}
