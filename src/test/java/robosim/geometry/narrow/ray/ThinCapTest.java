package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Rays in the plane that enter a tipped cylinder by a cap seen almost edge on, a thin ellipse, against decimals: never later than
 * the truth, and no touch is missed.
 */
@Tag("slow")
class ThinCapTest {
    private static final MathContext DIGITS = new MathContext(60);

    /** How much shorter an answer may be than where the ray enters a cylinder larger by this share of the coordinates. */
    private static final double SHORT = 0x1p-46;

    private final Scratch scratch = new Scratch();

    @Test
    void neverLaterThanTheTruth() {
        SplittableRandom random = new SplittableRandom(36062);
        int[] counts = new int[3];
        int cases = Effort.cases(4_000, 800);
        for (int k = 0; k < cases; k++) {
            double[] row = row(random);
            double heading = random.nextDouble(-3.2, 3.2);
            // Towards a cap, at a slant of 1 down to 10^-6 of its plane.
            double slant = StrictMath.pow(10, random.nextDouble(-6, 0));
            double ax = row[Leaf.ROTATION + 1];
            double az = row[Leaf.ROTATION + 7];
            double ux = k % 4 == 0 ? StrictMath.cos(heading) : -az + slant * ax;
            double uz = k % 4 == 0 ? StrictMath.sin(heading) : ax + slant * az;
            double aside = random.nextDouble(-1.2, 1.2) * row[3];
            double end = random.nextBoolean() ? row[4] : -row[4];
            double length = Math.sqrt(ax * ax + az * az);
            double back = random.nextDouble(0, 2);
            double ox = row[0] + end * ax - aside * az / length - back * ux;
            double oz = row[2] + end * az + aside * ax / length - back * uz;
            double answer = PlanarRay.distance(
                    new BeamAxis().line(ox, 0, oz, ux, 0, uz), LeafKind.CYLINDER, row, 0, scratch.ray);
            double truth = truth(row, ox, oz, ux, uz, 0);
            double size = Math.abs(row[0]) + Math.abs(row[2]) + 2 * row[3] + row[4] + Math.abs(ox) + Math.abs(oz);
            String what = PlanarRayTest.text(ox, oz, ux, uz, LeafKind.CYLINDER, row) + ": " + answer + " for " + truth;
            assertThat(answer).as(what).isLessThanOrEqualTo(truth);
            assertThat(answer).as(what).isGreaterThanOrEqualTo(truth(row, ox, oz, ux, uz, SHORT * size));
            counts[truth == 0 ? 0 : truth < Double.POSITIVE_INFINITY ? 1 : 2]++;
        }
        assertThat(counts[0]).isGreaterThan(cases / 100);
        assertThat(counts[1]).isGreaterThan(cases / 4);
        assertThat(counts[2]).isGreaterThan(cases / 20);
    }

    /** A cylinder that lies, but for an angle of 10^-9 to 10^-1. */
    private static double[] row(SplittableRandom random) {
        double up = StrictMath.pow(10, random.nextDouble(-9, -1));
        double heading = random.nextDouble(-3.2, 3.2);
        double level = Math.sqrt((1 - up) * (1 + up));
        double[] row = new double[Leaf.STRIDE];
        row[0] = random.nextDouble(-1, 1);
        row[2] = random.nextDouble(-1, 1);
        row[3] = StrictMath.pow(10, random.nextDouble(-3, 0));
        row[4] = random.nextDouble(0, 0.5);
        row[Leaf.ROTATION] = -StrictMath.sin(heading);
        row[Leaf.ROTATION + 6] = StrictMath.cos(heading);
        row[Leaf.ROTATION + 1] = level * StrictMath.cos(heading);
        row[Leaf.ROTATION + 4] = up;
        row[Leaf.ROTATION + 7] = level * StrictMath.sin(heading);
        return row;
    }

    /** Where the ray first is within {@code more} of the projection, moved aside and back by it; 0 if it starts there. */
    private static double truth(double[] row, double ox, double oz, double ux, double uz, double more) {
        double best = Double.POSITIVE_INFINITY;
        for (int shift = more == 0 ? 0 : -2; shift <= (more == 0 ? 0 : 2); shift++) {
            double length = Math.sqrt(ux * ux + uz * uz);
            BigDecimal by = of(more).multiply(of(shift / 2.0));
            BigDecimal x = of(ox).add(by.multiply(of(-uz / length)));
            BigDecimal z = of(oz).add(by.multiply(of(ux / length)));
            best = Math.min(best, enter(row, x, z, ux, uz, more));
        }
        return Math.max(0, best - more);
    }

    private static double enter(double[] row, BigDecimal ox, BigDecimal oz, double ux, double uz, double more) {
        BigDecimal ax = of(row[Leaf.ROTATION + 1]);
        BigDecimal ay = of(row[Leaf.ROTATION + 4]);
        BigDecimal az = of(row[Leaf.ROTATION + 7]);
        BigDecimal flat = ax.multiply(ax).add(az.multiply(az));
        BigDecimal level = flat.sqrt(DIGITS);
        BigDecimal ex = ax.divide(level, DIGITS);
        BigDecimal ez = az.divide(level, DIGITS);
        BigDecimal radius = of(row[3]);
        BigDecimal minor =
                radius.multiply(ay.abs()).divide(flat.add(ay.multiply(ay)).sqrt(DIGITS), DIGITS);
        BigDecimal reach = of(row[4]).multiply(level);
        BigDecimal mx = ox.subtract(of(row[0]));
        BigDecimal mz = oz.subtract(of(row[2]));
        BigDecimal u = of(ux).pow(2).add(of(uz).pow(2)).sqrt(DIGITS);
        BigDecimal along = mx.multiply(ex).add(mz.multiply(ez));
        BigDecimal across = mz.multiply(ex).subtract(mx.multiply(ez));
        BigDecimal wayAlong = of(ux).multiply(ex).add(of(uz).multiply(ez)).divide(u, DIGITS);
        BigDecimal wayAcross = of(uz).multiply(ex).subtract(of(ux).multiply(ez)).divide(u, DIGITS);
        double first = Double.POSITIVE_INFINITY;
        double last = Double.NEGATIVE_INFINITY;
        for (int end = -1; end <= 1; end += 2) {
            BigDecimal x = along.add(reach.multiply(of(end)));
            BigDecimal a = minor;
            BigDecimal b = radius;
            // b^2 (x + t wx)^2 + a^2 (z + t wz)^2 = a^2 b^2
            BigDecimal aa = a.multiply(a);
            BigDecimal bb = b.multiply(b);
            BigDecimal square = bb.multiply(wayAlong.pow(2)).add(aa.multiply(wayAcross.pow(2)));
            BigDecimal half =
                    bb.multiply(x).multiply(wayAlong).add(aa.multiply(across).multiply(wayAcross));
            BigDecimal rest =
                    bb.multiply(x.pow(2)).add(aa.multiply(across.pow(2))).subtract(aa.multiply(bb));
            BigDecimal under = half.pow(2).subtract(square.multiply(rest));
            if (under.signum() >= 0) {
                BigDecimal root = under.sqrt(DIGITS);
                first = Math.min(
                        first,
                        half.negate().subtract(root).divide(square, DIGITS).doubleValue());
                last = Math.max(
                        last, half.negate().add(root).divide(square, DIGITS).doubleValue());
            }
        }
        BigDecimal[] strip1 = strip(along, wayAlong, reach.add(of(more)));
        BigDecimal[] strip2 = strip(across, wayAcross, radius.add(of(more)));
        BigDecimal in = strip1[0].max(strip2[0]);
        BigDecimal out = strip1[1].min(strip2[1]);
        if (in.compareTo(out) <= 0) {
            first = Math.min(first, in.doubleValue());
            last = Math.max(last, out.doubleValue());
        }
        return first <= last && last >= -more ? Math.max(first, 0) : Double.POSITIVE_INFINITY;
    }

    private static BigDecimal[] strip(BigDecimal at, BigDecimal way, BigDecimal half) {
        BigDecimal one = half.subtract(at).divide(way, DIGITS);
        BigDecimal other = half.negate().subtract(at).divide(way, DIGITS);
        return new BigDecimal[] {one.min(other), one.max(other)};
    }

    private static BigDecimal of(double number) {
        return new BigDecimal(number);
    }

    /** A ray that was answered 29 * 2^-48 late. */
    @Test
    void aCapThatIsAlmostEdgeOn() {
        Geometry world = new Geometry(1e9, 1e9, 1e9, Dimension.PLANAR, Accuracy.EXACT);
        world.addObjectUnchecked(new CylinderObject(
                        new Point(0.9628200441111677, 0.29476719573121113, -0.14891185513619692),
                        0.001764790271488459,
                        0.13236681996993663)
                .oriented(new double[] {
                    0.9999989103016593,
                    0.0014762775801866546,
                    7.2649637436056E-9,
                    4.1359030627150577E-25,
                    4.9211366757998705E-6,
                    -0.9999999999878912,
                    -0.0014762775802045305,
                    0.9999989102895506,
                    4.921131313245401E-6
                }));
        Ray ray =
                new Ray(new Point(-0.09748459680831878, 0.29476719573121113, -0.08272591193719532), new Point(1, 0, 0));
        double truth = 1.0586375674486062687;
        double distance = world.getRayDistance(ray, 0, Double.POSITIVE_INFINITY, 0);
        assertThat(distance).isLessThanOrEqualTo(truth).isGreaterThan(truth - 1e-9);
    }
}
