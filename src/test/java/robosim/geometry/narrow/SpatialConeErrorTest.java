package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.reference.Decimals.minus;
import static robosim.geometry.reference.Decimals.plus;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.narrow.ray.SpatialRayTest;
import robosim.geometry.reference.DecimalRoot;
import robosim.geometry.reference.Decimals;

/** Verdicts and distances of cones in space against decimals of 60 digits, in which the cosine is the stored one. */
class SpatialConeErrorTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal NEVER = BigDecimal.TEN.pow(40);

    private final Scratch scratch = new Scratch();

    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_BOX", "SPHERE", "BOX", "TRIANGLE"})
    void agreesWithDecimals(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(211 + kind.ordinal());
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
            double[] row = place(kind, random, o, border(d, across, angle), far, scale);
            BigDecimal[] u = unit(d);
            if (n % 2 == 0) {
                approach(kind, row, o, u, new BigDecimal(cos), border(d, across, half + 1.5707963), random, scale);
            }
            BigDecimal truth =
                    kind == LeafKind.SPHERE ? sphere(o, row, u, cos) : polytope(kind, o, row, u, new BigDecimal(cos));
            String name = "half %s, %s %s ".formatted(half, Arrays.toString(o) + Arrays.toString(d), kind)
                    + Arrays.toString(row);
            double answer = SpatialCone.distance(
                    new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)),
                    kind,
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
            for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 6); k++) {
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
        BigDecimal truth = polytope(LeafKind.BOX, o, row, unit(d), new BigDecimal(cos));
        double answer = SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)),
                LeafKind.BOX,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
        assertThat(truth.subtract(new BigDecimal(answer)).abs().doubleValue())
                .isLessThanOrEqualTo(8 * Math.ulp(truth.doubleValue()));
    }

    /**
     * A cylinder in a cone is told by the lower end of a bracket: against the least of all rays along the border, led to
     * their minimum, where the cylinder's own nearest point is outside the cone.
     */
    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_CYLINDER", "CYLINDER"})
    void cylindersAreHardlyBelowTheTruth(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(221 + kind.ordinal());
        double worst = 0;
        int heard = 0;
        int silent = 0;
        for (int n = 0; n < 300; n++) {
            double half = Math.pow(10, -random.nextDouble(0, 2)) * 1.5;
            double cos = StrictMath.cos(half);
            double[] d = SpatialRayTest.unit(Leaves.vector(random, 1));
            double[] o = Leaves.vector(random, 1);
            double far = Math.pow(10, random.nextDouble(0.3, 2));
            double[] across = SpatialRayTest.unit(Leaves.vector(random, 1));
            double[] row = place(kind, random, o, border(d, across, random.nextDouble(0.5, 1.5) * half), far, 1);
            double answer = SpatialCone.distance(
                    new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, StrictMath.sin(half)),
                    kind,
                    row,
                    0,
                    Double.POSITIVE_INFINITY,
                    scratch.cone);
            double[] near = nearest(kind, o, row);
            double length = VectorMath.length(near[0], near[1], near[2]);
            double[] other = border(d, across, 1.5707963267948966);
            double truth = near[0] * d[0] + near[1] * d[1] + near[2] * d[2] >= cos * length
                    ? length
                    : least(o, d, other, cos, kind, row);
            String name = "half %s, %s %s ".formatted(half, Arrays.toString(o) + Arrays.toString(d), kind)
                    + Arrays.toString(row);
            if (truth == Double.POSITIVE_INFINITY) {
                silent++; // or between all rays that were tried
                continue;
            }
            heard++;
            assertThat(answer).as(name + truth).isLessThanOrEqualTo(truth * (1 + 0x1p-48));
            worst = Math.max(worst, (truth - answer) / truth);
            assertThat(answer).as(name + truth).isGreaterThanOrEqualTo(truth * (1 - 0x1p-40));
        }
        assertThat(heard).isGreaterThan(100);
        assertThat(silent).isGreaterThan(30);
        assertThat(worst).isGreaterThan(0x1p-54);
    }

    /** From the apex to the cylinder's nearest point. */
    private static double[] nearest(LeafKind kind, double[] o, double[] row) {
        double[] a = kind == LeafKind.CYLINDER ? new double[] {row[7], row[10], row[13]} : new double[] {0, 1, 0};
        double[] w = {o[0] - row[0], o[1] - row[1], o[2] - row[2]};
        double along = w[0] * a[0] + w[1] * a[1] + w[2] * a[2];
        double[] side = {w[0] - along * a[0], w[1] - along * a[1], w[2] - along * a[2]};
        double away = VectorMath.length(side[0], side[1], side[2]);
        double kept = Math.max(-row[4], Math.min(row[4], along));
        double share = away > row[3] ? row[3] / away : 1;
        double[] out = new double[3];
        for (int k = 0; k < 3; k++) {
            out[k] = row[k] + kept * a[k] + share * side[k] - o[k];
        }
        return out;
    }

    /** The least of the rays along the border: of many, the best led on by thirds. */
    private double least(double[] o, double[] d, double[] other, double cos, LeafKind kind, double[] row) {
        double[] third = {
            d[1] * other[2] - d[2] * other[1], d[2] * other[0] - d[0] * other[2], d[0] * other[1] - d[1] * other[0]
        };
        int rays = 4000;
        double best = Double.POSITIVE_INFINITY;
        double at = 0;
        for (int k = 0; k < rays; k++) {
            double angle = 2 * Math.PI * k / rays;
            double there = along(o, d, other, third, cos, angle, kind, row);
            if (there < best) {
                best = there;
                at = angle;
            }
        }
        double low = at - 2 * Math.PI / rays;
        double high = at + 2 * Math.PI / rays;
        for (int k = 0; k < 80; k++) {
            double p = low + (high - low) / 3;
            double q = high - (high - low) / 3;
            double atP = along(o, d, other, third, cos, p, kind, row);
            double atQ = along(o, d, other, third, cos, q, kind, row);
            best = Math.min(best, Math.min(atP, atQ));
            // A miss is on the side where the rays pass by.
            if (atP < atQ || (Double.isInfinite(atQ) && p >= at)) {
                high = q;
            } else {
                low = p;
            }
        }
        return best;
    }

    private double along(
            double[] o, double[] d, double[] e, double[] f, double cos, double angle, LeafKind kind, double[] row) {
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        double c = sin * StrictMath.cos(angle);
        double s = sin * StrictMath.sin(angle);
        return SpatialRay.distance(
                new BeamAxis()
                        .line(
                                o[0],
                                o[1],
                                o[2],
                                cos * d[0] + c * e[0] + s * f[0],
                                cos * d[1] + c * e[1] + s * f[1],
                                cos * d[2] + c * e[2] + s * f[2]),
                kind,
                row,
                0,
                scratch.ray);
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

    private static double[] place(
            LeafKind kind, SplittableRandom random, double[] o, double[] direction, double far, double scale) {
        double[] row = Rows.random(kind, random, 0.001);
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 6); k++) {
            row[k] *= scale;
        }
        move(kind, row, direction, far * scale);
        move(kind, row, o, 1);
        return row;
    }

    private static void move(LeafKind kind, double[] row, double[] direction, double way) {
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k++) {
            row[k] += way * direction[k % 3];
        }
    }

    /** Moves the leaf along a direction until its deepest corner is on the border, or nearly. */
    private static void approach(
            LeafKind kind,
            double[] row,
            double[] o,
            BigDecimal[] u,
            BigDecimal cos,
            double[] outward,
            SplittableRandom random,
            double scale) {
        double off = scale * Math.pow(10, -random.nextDouble(1, 17)) * (random.nextBoolean() ? 1 : -1);
        for (int step = 0; step < 5; step++) {
            double deepest = Double.NEGATIVE_INFINITY;
            for (BigDecimal[] p : corners(kind, o, row)) {
                BigDecimal ahead = dot(p, u);
                double depth = ahead.subtract(cos.multiply(root(dot(p, p)))).doubleValue();
                double sine = Math.sqrt(1 - cos.doubleValue() * cos.doubleValue());
                deepest = Math.max(deepest, depth / sine);
            }
            move(kind, row, outward, deepest + (kind == LeafKind.SPHERE ? row[3] : 0) + off);
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

    private static BigDecimal polytope(LeafKind kind, double[] o, double[] row, BigDecimal[] u, BigDecimal cos) {
        List<BigDecimal[]> p = corners(kind, o, row);
        int[][] faces = kind == LeafKind.TRIANGLE
                ? new int[][] {{0, 1, 2}}
                : new int[][] {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
        BigDecimal least = NEVER;
        boolean inside = kind != LeafKind.TRIANGLE;
        for (int[] face : faces) {
            for (int k = 0; k < face.length; k++) {
                BigDecimal[] from = p.get(face[k]);
                BigDecimal[] along = minus(p.get(face[(k + 1) % face.length]), from);
                least = least.min(edge(from, along, u, cos));
            }
            BigDecimal[] normal =
                    Decimals.cross(minus(p.get(face[1]), p.get(face[0])), minus(p.get(face[2]), p.get(face[0])));
            BigDecimal height = dot(normal, p.get(face[0]));
            if (inside) {
                int middle = dot(normal, minus(centre(p), p.get(face[0]))).signum();
                inside = height.negate().signum() * middle >= 0;
            }
            least = least.min(face(face, p, normal, height, u, cos));
        }
        return inside ? BigDecimal.ZERO : least.compareTo(NEVER) == 0 ? NEVER : least;
    }

    private static BigDecimal[] centre(List<BigDecimal[]> p) {
        BigDecimal[] sum = {BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO};
        for (BigDecimal[] q : p) {
            sum = plus(sum, q);
        }
        return times(sum, BigDecimal.ONE.divide(new BigDecimal(p.size()), DIGITS));
    }

    /** Ends, the foot, and both places where the line crosses the cone. */
    private static BigDecimal edge(BigDecimal[] p, BigDecimal[] e, BigDecimal[] u, BigDecimal cos) {
        BigDecimal square = dot(e, e);
        BigDecimal limit = cos.multiply(cos);
        BigDecimal least = at(p, u, limit).min(at(plus(p, e), u, limit));
        BigDecimal foot = dot(p, e).negate().divide(square, DIGITS);
        if (foot.signum() > 0 && foot.compareTo(BigDecimal.ONE) < 0) {
            least = least.min(at(plus(p, times(e, foot)), u, limit));
        }
        BigDecimal pu = dot(p, u);
        BigDecimal eu = dot(e, u);
        BigDecimal a = eu.multiply(eu).subtract(limit.multiply(square));
        BigDecimal b = pu.multiply(eu).subtract(limit.multiply(dot(p, e)));
        BigDecimal c = pu.multiply(pu).subtract(limit.multiply(dot(p, p)));
        BigDecimal under = b.multiply(b).subtract(a.multiply(c));
        if (under.signum() < 0 || a.signum() == 0) {
            return least;
        }
        BigDecimal root = DecimalRoot.of(under, DIGITS);
        for (BigDecimal top : List.of(b.negate().add(root), b.negate().subtract(root))) {
            BigDecimal share = top.divide(a, DIGITS);
            if (share.signum() >= 0 && share.compareTo(BigDecimal.ONE) <= 0) {
                BigDecimal[] x = plus(p, times(e, share));
                least = dot(x, u).signum() >= 0 ? least.min(root(dot(x, x))) : least;
            }
        }
        return least;
    }

    private static BigDecimal at(BigDecimal[] x, BigDecimal[] u, BigDecimal limit) {
        BigDecimal ahead = dot(x, u);
        BigDecimal square = dot(x, x);
        return ahead.signum() >= 0 && ahead.multiply(ahead).compareTo(limit.multiply(square)) >= 0
                ? root(square)
                : NEVER;
    }

    /** The nearest point of the plane in the cone, where the face holds it. */
    private static BigDecimal face(
            int[] face, List<BigDecimal[]> p, BigDecimal[] normal, BigDecimal height, BigDecimal[] u, BigDecimal cos) {
        if (height.signum() == 0) {
            return NEVER;
        }
        BigDecimal length = root(dot(normal, normal));
        BigDecimal sign = BigDecimal.valueOf(height.signum());
        BigDecimal[] n = times(normal, sign.divide(length, DIGITS));
        BigDecimal away = height.abs().divide(length, DIGITS);
        BigDecimal ahead = dot(n, u);
        BigDecimal[] way = n;
        if (ahead.compareTo(cos) < 0) {
            BigDecimal[] side = minus(n, times(u, ahead));
            BigDecimal sine = root(BigDecimal.ONE.subtract(cos.multiply(cos)));
            way = plus(times(u, cos), times(side, sine.divide(root(dot(side, side)), DIGITS)));
        }
        BigDecimal rate = dot(n, way);
        if (rate.signum() <= 0) {
            return NEVER;
        }
        BigDecimal t = away.divide(rate, DIGITS);
        BigDecimal[] x = times(way, t);
        int sides = 0;
        for (int k = 0; k < face.length; k++) {
            BigDecimal[] from = p.get(face[k]);
            BigDecimal[] along = minus(p.get(face[(k + 1) % face.length]), from);
            sides += dot(Decimals.cross(along, minus(x, from)), normal).signum() >= 0 ? 1 : 0;
        }
        return sides == face.length ? t : NEVER;
    }

    private static List<BigDecimal[]> corners(LeafKind kind, double[] o, double[] row) {
        List<BigDecimal[]> corners = new ArrayList<>();
        BigDecimal[] apex = CylinderTwin.decimals(o);
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                corners.add(minus(CylinderTwin.decimals(row[k], row[k + 1], row[k + 2]), apex));
            }
            return corners;
        }
        corners.add(minus(CylinderTwin.decimals(row), apex));
        for (int k = 0; k < 3 && kind != LeafKind.SPHERE; k++) {
            BigDecimal[] half =
                    times(CylinderTwin.decimals(row[6 + k], row[9 + k], row[12 + k]), new BigDecimal(row[3 + k]));
            List<BigDecimal[]> more = new ArrayList<>();
            for (BigDecimal[] c : corners) {
                more.add(minus(c, half));
                more.add(plus(c, half));
            }
            corners = more;
        }
        return corners;
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
}
