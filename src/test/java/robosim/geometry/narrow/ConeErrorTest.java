package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.cone.Cone;
import robosim.geometry.narrow.cone.PlanarCone;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.DecimalRoot;
import robosim.geometry.reference.Decimals;

/** Verdicts and distances of cones against decimals of 60 digits, in which the cosine is the stored one. */
class ConeErrorTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal NEVER = BigDecimal.TEN.pow(40);

    private final Scratch scratch = new Scratch();

    /** Shapes beside the border of the sector by 1e-1 to 1e-16 of their size, on both sides. */
    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_BOX", "UPRIGHT_CYLINDER", "SPHERE", "BOX", "TRIANGLE"})
    void sectors(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(201 + kind.ordinal());
        double worst = 0;
        int heard = 0;
        int silent = 0;
        int close = 0;
        int count = 300;
        for (int n = 0; n < count; n++) {
            double scale = Math.scalb(1.0, n % 5 == 0 ? random.nextInt(-40, 41) : 0);
            double far = Math.pow(10, random.nextDouble(0, n % 4 == 0 ? 6 : 1));
            double half = Math.pow(10, -random.nextDouble(0, 3)) * 1.5;
            double aim = random.nextDouble(-3.1, 3.1);
            double cos = StrictMath.cos(half);
            double[] d = {StrictMath.cos(aim), 0, StrictMath.sin(aim)};
            double[] o = {random.nextDouble(-1, 1) * scale, 0, random.nextDouble(-1, 1) * scale};
            double[] row =
                    place(kind, random, o, aim + (n % 2 == 0 ? half : random.nextDouble(-2, 2) * half), far, scale);
            BigDecimal truth = sector(o, d, cos, kind, row, n % 2 == 0, random, scale);
            String name = "half %s, %s %s".formatted(half, Arrays.toString(o) + Arrays.toString(d), kind)
                    + Arrays.toString(row);
            double answer = PlanarCone.distance(
                    new BeamAxis().line(o[0], 0, o[2], d[0], 0, d[2]).widen(cos, StrictMath.sin(half)),
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
            close += truth.doubleValue() > 0 ? 1 : 0;
            worst = Math.max(worst, ulps(truth, answer, largest(o, kind, row)));
            assertThat(worst).as(name + " answer " + answer + " truth " + truth).isLessThanOrEqualTo(8);
        }
        assertThat(worst).isGreaterThan(0.3);
        assertThat(heard).isGreaterThan(count * 2 / 10);
        assertThat(silent).isGreaterThan(count / 10);
        assertThat(close).isGreaterThan(count / 10);
    }

    private static double ulps(BigDecimal truth, double answer, double largest) {
        double unit = Math.ulp(Math.max(largest, truth.doubleValue()));
        return truth.subtract(new BigDecimal(answer)).abs().doubleValue() / unit;
    }

    private static double largest(double[] o, LeafKind kind, double[] row) {
        double largest = VectorMath.largest(o[0], o[1], o[2]);
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 6); k++) {
            largest = Math.max(largest, Math.abs(row[k]));
        }
        return largest;
    }

    /** A random leaf at a distance along a direction of the plane. */
    private static double[] place(
            LeafKind kind, SplittableRandom random, double[] o, double at, double far, double scale) {
        double[] row = Rows.random(kind, random, 0.001);
        double x = o[0] + far * scale * StrictMath.cos(at);
        double z = o[2] + far * scale * StrictMath.sin(at);
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 6); k++) {
            row[k] *= scale;
        }
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k += 3) {
            row[k] += x;
            row[k + 2] += z;
        }
        return row;
    }

    /**
     * The distance in the sector; where asked, the leaf is first moved across the border until it is just or nearly
     * touched, to rounding.
     */
    private static BigDecimal sector(
            double[] o,
            double[] d,
            double cos,
            LeafKind kind,
            double[] row,
            boolean nearly,
            SplittableRandom random,
            double scale) {
        BigDecimal c = new BigDecimal(cos);
        BigDecimal s = DecimalRoot.of(BigDecimal.ONE.subtract(c.multiply(c)), DIGITS);
        BigDecimal ux = new BigDecimal(d[0]);
        BigDecimal uz = new BigDecimal(d[2]);
        BigDecimal length = DecimalRoot.of(ux.multiply(ux).add(uz.multiply(uz)), DIGITS);
        BigDecimal[] left = {
            ux.multiply(c).subtract(uz.multiply(s)).divide(length, DIGITS),
            ux.multiply(s).add(uz.multiply(c)).divide(length, DIGITS)
        };
        BigDecimal[] right = {
            ux.multiply(c).add(uz.multiply(s)).divide(length, DIGITS),
            uz.multiply(c).subtract(ux.multiply(s)).divide(length, DIGITS)
        };
        if (nearly) {
            // How far the leaf reaches back over the left edge, and so much less or more.
            BigDecimal most = null;
            for (BigDecimal[] corner : corners(o, kind, row)) {
                BigDecimal inward = cross(corner, left);
                most = most == null ? inward : most.max(inward);
            }
            double reach = most.doubleValue() + (isDisc(kind) ? row[3] : 0);
            double off = reach + scale * Math.pow(10, -random.nextDouble(1, 17)) * (random.nextBoolean() ? 1 : -1);
            for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k += 3) {
                row[k] -= off * left[1].doubleValue();
                row[k + 2] += off * left[0].doubleValue();
            }
        }
        return isDisc(kind) ? disc(o, row, left, right) : polygon(corners(o, kind, row), left, right);
    }

    private static boolean isDisc(LeafKind kind) {
        return kind == LeafKind.SPHERE || kind == LeafKind.UPRIGHT_CYLINDER;
    }

    private static BigDecimal disc(double[] o, double[] row, BigDecimal[] left, BigDecimal[] right) {
        BigDecimal[] m = {
            new BigDecimal(row[0]).subtract(new BigDecimal(o[0])), new BigDecimal(row[2]).subtract(new BigDecimal(o[2]))
        };
        BigDecimal r = new BigDecimal(row[3]);
        BigDecimal whole = root(dot(m, m)).subtract(r);
        if (whole.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        if (holds(m, left, right)) {
            return whole;
        }
        BigDecimal least = NEVER;
        for (BigDecimal[] edge : List.of(left, right)) {
            BigDecimal aside = cross(m, edge);
            BigDecimal square = r.multiply(r).subtract(aside.multiply(aside));
            BigDecimal ahead = dot(m, edge);
            if (square.signum() >= 0 && ahead.signum() > 0) {
                least = least.min(ahead.subtract(root(square)));
            }
        }
        return least.compareTo(NEVER) == 0 ? NEVER : least;
    }

    /** The least of the corners within, the feet on the sides, and the places where the edges cross sides. */
    private static BigDecimal polygon(List<BigDecimal[]> points, BigDecimal[] left, BigDecimal[] right) {
        List<BigDecimal[]> hull = hull(points);
        if (holdsApex(hull)) {
            return BigDecimal.ZERO;
        }
        BigDecimal least = NEVER;
        for (int k = 0; k < hull.size(); k++) {
            BigDecimal[] p = hull.get(k);
            BigDecimal[] q = hull.get((k + 1) % hull.size());
            BigDecimal[] e = {q[0].subtract(p[0]), q[1].subtract(p[1])};
            if (holds(p, left, right)) {
                least = least.min(root(dot(p, p)));
            }
            BigDecimal square = dot(e, e);
            if (square.signum() == 0) {
                continue;
            }
            BigDecimal share = dot(p, e).negate().divide(square, DIGITS);
            least = least.min(at(p, e, share, left, right));
            for (BigDecimal[] edge : List.of(left, right)) {
                BigDecimal across = cross(e, edge);
                if (across.signum() != 0) {
                    share = cross(p, edge).negate().divide(across, DIGITS);
                    BigDecimal[] x = {p[0].add(e[0].multiply(share)), p[1].add(e[1].multiply(share))};
                    boolean on = share.signum() >= 0 && share.compareTo(BigDecimal.ONE) <= 0;
                    if (on && dot(x, edge).signum() >= 0) {
                        least = least.min(root(dot(x, x)));
                    }
                }
            }
        }
        return least.compareTo(NEVER) == 0 ? NEVER : least;
    }

    private static BigDecimal at(
            BigDecimal[] p, BigDecimal[] e, BigDecimal share, BigDecimal[] left, BigDecimal[] right) {
        if (share.signum() < 0 || share.compareTo(BigDecimal.ONE) > 0) {
            return NEVER;
        }
        BigDecimal[] x = {p[0].add(e[0].multiply(share)), p[1].add(e[1].multiply(share))};
        return holds(x, left, right) ? root(dot(x, x)) : NEVER;
    }

    private static boolean holds(BigDecimal[] w, BigDecimal[] left, BigDecimal[] right) {
        return cross(w, left).signum() >= 0
                && cross(right, w).signum() >= 0
                && dot(w, left).add(dot(w, right)).signum() >= 0;
    }

    /** The corners of the projection, and some more within it, seen from the apex. */
    private static List<BigDecimal[]> corners(double[] o, LeafKind kind, double[] row) {
        List<BigDecimal[]> corners = new ArrayList<>();
        BigDecimal ox = new BigDecimal(o[0]);
        BigDecimal oz = new BigDecimal(o[2]);
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 9; k += 3) {
                corners.add(
                        new BigDecimal[] {new BigDecimal(row[k]).subtract(ox), new BigDecimal(row[k + 2]).subtract(oz)
                        });
            }
            return corners;
        }
        corners.add(new BigDecimal[] {new BigDecimal(row[0]).subtract(ox), new BigDecimal(row[2]).subtract(oz)});
        for (int k = 0; k < 3 && !isDisc(kind); k++) {
            BigDecimal half = new BigDecimal(row[3 + k]);
            BigDecimal x = half.multiply(new BigDecimal(row[6 + k]));
            BigDecimal z = half.multiply(new BigDecimal(row[12 + k]));
            List<BigDecimal[]> more = new ArrayList<>();
            for (BigDecimal[] c : corners) {
                more.add(new BigDecimal[] {c[0].add(x), c[1].add(z)});
                more.add(new BigDecimal[] {c[0].subtract(x), c[1].subtract(z)});
            }
            corners = more;
        }
        return corners;
    }

    /** The convex hull in order, by sorting and turning one way. */
    private static List<BigDecimal[]> hull(List<BigDecimal[]> points) {
        List<BigDecimal[]> sorted = new ArrayList<>(points);
        sorted.sort((p, q) -> p[0].compareTo(q[0]) != 0 ? p[0].compareTo(q[0]) : p[1].compareTo(q[1]));
        List<BigDecimal[]> hull = new ArrayList<>();
        for (int pass = 0; pass < 2; pass++) {
            int base = hull.size();
            for (BigDecimal[] p : sorted) {
                while (hull.size() >= base + 2 && turn(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p) <= 0) {
                    hull.remove(hull.size() - 1);
                }
                hull.add(p);
            }
            hull.remove(hull.size() - 1);
            java.util.Collections.reverse(sorted);
        }
        return hull;
    }

    private static int turn(BigDecimal[] p, BigDecimal[] q, BigDecimal[] r) {
        return cross(
                        new BigDecimal[] {q[0].subtract(p[0]), q[1].subtract(p[1])},
                        new BigDecimal[] {r[0].subtract(p[0]), r[1].subtract(p[1])})
                .signum();
    }

    private static boolean holdsApex(List<BigDecimal[]> hull) {
        boolean inside = hull.size() > 2;
        for (int k = 0; k < hull.size(); k++) {
            inside &= cross(hull.get(k), hull.get((k + 1) % hull.size())).signum() >= 0;
        }
        return inside;
    }

    private static BigDecimal cross(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[1]).subtract(p[1].multiply(q[0]));
    }

    private static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[0]).add(p[1].multiply(q[1]));
    }

    private static BigDecimal root(BigDecimal square) {
        return square.signum() <= 0 ? BigDecimal.ZERO : DecimalRoot.of(square, DIGITS);
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
