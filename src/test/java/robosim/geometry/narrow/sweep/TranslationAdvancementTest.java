package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.reference.Decimals.dot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;

/** Tipped cylinders with parallel axes that move against each other, against decimals: two discs and two intervals. */
class TranslationAdvancementTest {
    private static final MathContext DIGITS = new MathContext(50);
    private static final int CASES = Effort.cases(10_000);

    private final SplittableRandom random = new SplittableRandom(2405);

    // By their squares all that is asked is rational in the axis as stored, but for one root.
    private final BigDecimal[] centre = new BigDecimal[3];
    private final BigDecimal[] way = new BigDecimal[3];
    private final BigDecimal[] axis = new BigDecimal[3];

    @Test
    void parallelTippedCylindersStopWhereTheyMeet() {
        Scratch scratch = new Scratch();
        int hits = 0;
        double widest = 0;
        for (int k = 0; k < CASES; k++) {
            double[] a = SweepRows.random(LeafKind.CYLINDER, 1.5, random);
            double[] b = SweepRows.random(LeafKind.CYLINDER, 1.5, random);
            System.arraycopy(a, Leaf.ROTATION, b, Leaf.ROTATION, 9);
            for (double[] row : new double[][] {a, b}) {
                row[3] = StrictMath.pow(10, random.nextDouble(-6, 1));
                row[4] = StrictMath.pow(10, random.nextDouble(-6, 1));
            }
            double aside = k % 3 == 0 ? 0 : a[3] + b[3];
            double length = k % 2 == 0 ? 1 : random.nextDouble(0.2, 3);
            double[] d = new double[3];
            for (int m = 0; m < 3; m++) {
                d[m] = length * (b[m] - a[m] + aside * random.nextDouble(-1, 1));
            }
            double time = SpatialSweep.translation(
                    new Leaf(LeafKind.CYLINDER, a, 0),
                    d[0],
                    d[1],
                    d[2],
                    new Leaf(LeafKind.CYLINDER, b, 0),
                    scratch.sweep);
            load(a, d, b);
            BigDecimal truth = meet(a, b);
            if (truth == null) {
                continue;
            }
            hits++;
            String what = "%s by %s, %s".formatted(Arrays.toString(a), Arrays.toString(d), Arrays.toString(b));
            assertThat(time).as(what).isBetween(0.0, 1.0);
            assertThat(new BigDecimal(time)).as(what).isLessThanOrEqualTo(truth);
            double sum = 0;
            for (int m = 0; m < 3; m++) {
                sum += Math.abs(a[m] - b[m]) + Math.abs(d[m]);
            }
            sum += a[3] + a[4] + b[3] + b[4];
            double share = gap(new BigDecimal(time), a, b) / sum;
            assertThat(share).as(what).isLessThan(TranslationAdvancement.EARLY);
            widest = Math.max(widest, share);
        }
        assertThat(hits).isGreaterThan(CASES / 4);
        // A bound that is never approached would say nothing.
        assertThat(widest).isGreaterThan(TranslationAdvancement.EARLY / 100);
    }

    private void load(double[] a, double[] d, double[] b) {
        for (int m = 0; m < 3; m++) {
            centre[m] = new BigDecimal(a[m]).subtract(new BigDecimal(b[m]));
            way[m] = new BigDecimal(d[m]);
            axis[m] = new BigDecimal(a[7 + 3 * m]);
        }
    }

    /** The time from 0 to 1 at which the two first touch, null where they touch at the start or never. */
    private @Nullable BigDecimal meet(double[] a, double[] b) {
        BigDecimal uu = dot(axis, axis);
        BigDecimal cu = dot(centre, axis);
        BigDecimal wu = dot(way, axis);
        BigDecimal radii = new BigDecimal(a[3]).add(new BigDecimal(b[3]));
        BigDecimal halves = new BigDecimal(a[4]).add(new BigDecimal(b[4])).multiply(uu);
        BigDecimal p = dot(way, way).subtract(wu.multiply(wu).divide(uu, DIGITS));
        BigDecimal q = dot(centre, way).subtract(wu.multiply(cu).divide(uu, DIGITS));
        BigDecimal r =
                dot(centre, centre).subtract(cu.multiply(cu).divide(uu, DIGITS)).subtract(radii.multiply(radii));
        BigDecimal square = q.multiply(q).subtract(p.multiply(r));
        if (square.signum() < 0 || p.signum() == 0 || wu.signum() == 0) {
            return null;
        }
        BigDecimal root = DecimalRoot.of(square, DIGITS);
        BigDecimal one = halves.subtract(cu).divide(wu, DIGITS);
        BigDecimal other = halves.negate().subtract(cu).divide(wu, DIGITS);
        BigDecimal in = q.negate().subtract(root).divide(p, DIGITS).max(one.min(other));
        BigDecimal out = q.negate().add(root).divide(p, DIGITS).min(one.max(other));
        return in.compareTo(out) < 0 && in.signum() > 0 && in.compareTo(BigDecimal.ONE) < 0 ? in : null;
    }

    /** How far apart the two are at a time. */
    private double gap(BigDecimal time, double[] a, double[] b) {
        BigDecimal[] c = new BigDecimal[3];
        for (int m = 0; m < 3; m++) {
            c[m] = centre[m].add(time.multiply(way[m]));
        }
        BigDecimal uu = dot(axis, axis);
        BigDecimal cu = dot(c, axis);
        double aside = DecimalRoot.of(
                        dot(c, c).subtract(cu.multiply(cu).divide(uu, DIGITS)).max(BigDecimal.ZERO), DIGITS)
                .subtract(new BigDecimal(a[3]).add(new BigDecimal(b[3])))
                .doubleValue();
        double along = cu.abs()
                .divide(DecimalRoot.of(uu, DIGITS), DIGITS)
                .subtract(new BigDecimal(a[4]).add(new BigDecimal(b[4])))
                .doubleValue();
        return Math.hypot(Math.max(0, aside), Math.max(0, along));
    }
}
