package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static robosim.geometry.reference.Decimals.minus;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.cone.Cone;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRayTest;
import robosim.geometry.reference.Decimals;

/**
 * Verdicts and distances of spheres in cones against decimals of 60 digits, in which the cosine is the stored one: also where the
 * border but grazes. The census has boxes, triangles, meshes and cylinders.
 */
class SpatialConeErrorTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal NEVER = BigDecimal.TEN.pow(40);

    private final Scratch scratch = new Scratch();

    @Test
    void agreesWithDecimals() {
        SplittableRandom random = new SplittableRandom(211 + LeafKind.SPHERE.ordinal());
        double worst = 0;
        int heard = 0;
        int silent = 0;
        int count = Effort.cases(200);
        for (int n = 0; n < count; n++) {
            double scale = Math.scalb(1.0, n % 5 == 0 ? random.nextInt(-40, 41) : 0);
            double far = Math.pow(10, random.nextDouble(0, n % 4 == 0 ? 6 : 1));
            double half = Math.pow(10, -random.nextDouble(0, 3)) * 1.5;
            double cos = StrictMath.cos(half);
            double[] d = SpatialRayTest.unit(Leaves.vector(random, 1));
            double[] o = Leaves.vector(random, scale);
            double[] across = SpatialRayTest.unit(Leaves.vector(random, 1));
            double angle = (n % 2 == 0 ? 1 : random.nextDouble(0, 2)) * half;
            double[] row = place(random, o, border(d, across, angle), far, scale);
            BigDecimal[] u = unit(d);
            if (n % 2 == 0) {
                approach(row, o, u, new BigDecimal(cos), border(d, across, half + 1.5707963), random, scale);
            }
            BigDecimal truth = sphere(o, row, u, cos);
            String name =
                    "half %s, %s %s".formatted(half, Arrays.toString(o) + Arrays.toString(d), Arrays.toString(row));
            double answer = SpatialCone.distance(
                    new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)),
                    LeafKind.SPHERE,
                    row,
                    0,
                    Double.POSITIVE_INFINITY,
                    scratch.cone);
            assertThat(Double.isInfinite(answer)).as(name + " truth " + truth).isEqualTo(truth == NEVER);
            if (truth == NEVER) {
                silent++;
                continue;
            }
            heard++;
            double largest = VectorMath.largest(o[0], o[1], o[2]);
            for (int k = 0; k < 4; k++) {
                largest = Math.max(largest, Math.abs(row[k]));
            }
            double unit = Math.ulp(Math.max(largest, truth.doubleValue()));
            worst = Math.max(worst, truth.subtract(new BigDecimal(answer)).abs().doubleValue() / unit);
            assertThat(worst).as(name + " answer " + answer + " truth " + truth).isLessThanOrEqualTo(8);
        }
        assertThat(heard).isGreaterThan(count * 2 / 10);
        assertThat(silent).isGreaterThan(count / 10);
        assertThat(worst).isGreaterThan(0.4);
    }

    /** A corner that is outside a narrow cone by less than doubles can tell, from far away: it was taken for the answer. */
    @Test
    void aCornerJustOutside() {
        double half = 0.00940222659701042;
        double cos = StrictMath.cos(half);
        double[] o = {-0.08858403382790758, 0.6562928414357991, -0.10743696353701959};
        double[] d = {0.7264859966100254, 0.5455858120499344, 0.4177968626250702};
        double[] row = {
            3022.509537708392,
            2317.620893367133,
            1768.0845808395336,
            0.973378766474174,
            0.965453908001624,
            0.6332664088039879,
            0.4890644332740438,
            -0.17868971754672985,
            0.8537481859128067,
            0.7593857474259293,
            0.5687696031004763,
            -0.31596586080665323,
            -0.42912616642742846,
            0.8028518689222791,
            0.4138594083203889,
            0
        };
        // Of decimals of 60 digits.
        double truth = 4198.22926068670526;
        double answer = SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)),
                LeafKind.BOX,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
        assertThat(answer).isCloseTo(truth, within(8 * Math.ulp(truth)));
    }

    /** The unit direction that is turned away from d by an angle, towards another. */
    private static double[] border(double[] d, double[] other, double angle) {
        double along = d[0] * other[0] + d[1] * other[1] + d[2] * other[2];
        double[] side = SpatialRayTest.unit(
                new double[] {other[0] - along * d[0], other[1] - along * d[1], other[2] - along * d[2]});
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        return new double[] {c * d[0] + s * side[0], c * d[1] + s * side[1], c * d[2] + s * side[2]};
    }

    private static double[] place(SplittableRandom random, double[] o, double[] direction, double far, double scale) {
        double[] row = Rows.random(LeafKind.SPHERE, random, 0.001);
        for (int k = 0; k < 4; k++) {
            row[k] *= scale;
        }
        move(row, direction, far * scale);
        move(row, o, 1);
        return row;
    }

    private static void move(double[] row, double[] direction, double way) {
        for (int k = 0; k < 3; k++) {
            row[k] += way * direction[k];
        }
    }

    /** Moves the sphere along a direction until it is on the border, or nearly. */
    private static void approach(
            double[] row,
            double[] o,
            BigDecimal[] u,
            BigDecimal cos,
            double[] outward,
            SplittableRandom random,
            double scale) {
        double off = scale * Math.pow(10, -random.nextDouble(1, 17)) * (random.nextBoolean() ? 1 : -1);
        for (int step = 0; step < 5; step++) {
            BigDecimal[] p = minus(CylinderTwin.decimals(row), CylinderTwin.decimals(o));
            double depth = dot(p, u).subtract(cos.multiply(root(dot(p, p)))).doubleValue();
            double sine = Math.sqrt(1 - cos.doubleValue() * cos.doubleValue());
            move(row, outward, depth / sine + row[3] + off);
        }
    }

    private static BigDecimal sphere(double[] o, double[] row, BigDecimal[] u, double cos) {
        BigDecimal[] m = minus(CylinderTwin.decimals(row), CylinderTwin.decimals(o));
        BigDecimal r = new BigDecimal(row[3]);
        BigDecimal c = new BigDecimal(cos);
        BigDecimal s = root(BigDecimal.ONE.subtract(c.multiply(c)));
        BigDecimal[] cross = Decimals.cross(m, u);
        BigDecimal ahead = dot(m, u);
        BigDecimal aside = root(dot(cross, cross));
        BigDecimal past = aside.multiply(c).subtract(ahead.multiply(s));
        BigDecimal whole = root(dot(m, m)).subtract(r).max(BigDecimal.ZERO);
        if (past.signum() <= 0 || whole.signum() == 0) {
            return whole;
        }
        BigDecimal along = ahead.multiply(c).add(aside.multiply(s));
        BigDecimal square = r.multiply(r).subtract(past.multiply(past));
        return along.signum() < 0 || square.signum() < 0 ? NEVER : along.subtract(root(square));
    }

    private static BigDecimal[] unit(double[] d) {
        BigDecimal[] v = CylinderTwin.decimals(d);
        return times(v, BigDecimal.ONE.divide(root(dot(v, v)), DIGITS));
    }

    private static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return Decimals.dot(p, q).round(new MathContext(120));
    }

    private static BigDecimal root(BigDecimal square) {
        return CylinderTwin.root(square);
    }

    private static BigDecimal[] times(BigDecimal[] p, BigDecimal f) {
        return new BigDecimal[] {p[0].multiply(f, DIGITS), p[1].multiply(f, DIGITS), p[2].multiply(f, DIGITS)};
    }

    /** The bound of an edge's depth is not idle: that of a corner alone comes to more than a tenth of it. */
    @Test
    void theDepthOfACornerIsOffByATenthOfItsBound() {
        double[] d = {0.3477021455478506, -0.158260573066916, 0.4709351827179953};
        double[] p = {-0.2767906702525891, 0.14481970208000639, -0.0940296332316426};
        double cos = 0.9365061410686879;
        Cone cone = new Cone();
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        cone.set(new BeamAxis().line(0.1, 0.2, 0.3, d[0], d[1], d[2]).widen(cos, sin), 0.2);
        BigDecimal[] q = Decimals.minus(CylinderTwin.decimals(p), CylinderTwin.decimals(0.1, 0.2, 0.3));
        BigDecimal[] axis = CylinderTwin.decimals(d);
        BigDecimal length = root(Decimals.dot(q, q));
        BigDecimal depth = Decimals.dot(q, axis)
                .divide(root(Decimals.dot(axis, axis)), DIGITS)
                .subtract(new BigDecimal(cos).multiply(length));
        BigDecimal off = new BigDecimal(cone.depth(p[0] - 0.1, p[1] - 0.2, p[2] - 0.3)).subtract(depth);
        assertThat(off.abs().doubleValue() / length.doubleValue()).isBetween(4.8 * 0x1p-53, 48 * 0x1p-53);
    }
}
