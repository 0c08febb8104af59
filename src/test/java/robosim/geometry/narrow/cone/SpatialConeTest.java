package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.RayOracle;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.reference.DecimalRoot;

@Tag("slow")
class SpatialConeTest {
    private final Scratch scratch = new Scratch();

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void aNarrowConeTendsToTheRay(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(50 + kind.ordinal());
        int hits = 0;
        for (int i = 0; i < 400; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double[] o = Leaves.vector(random, 4);
            double[] d = {row[0] - o[0], row[1] - o[1], row[2] - o[2]};
            double ray = ray(o, d, kind, row);
            double cone = cone(o, d, Math.cos(1e-6), kind, row);
            assertThat(cone).isLessThanOrEqualTo(ray);
            if (Double.isFinite(ray)) {
                hits++;
                assertThat(cone).isGreaterThan(ray - 0.05);
            }
        }
        assertThat(hits).isGreaterThan(60);
    }

    /** Segments in a plane with the axis: ends, foot, and where the two borders cross them, to 120 digits. */
    @Test
    void segmentsInThePlaneOfTheAxis() {
        SplittableRandom random = new SplittableRandom(8);
        int heard = 0;
        int silent = 0;
        for (int i = 0; i < 3000; i++) {
            double cos = StrictMath.cos(random.nextDouble(0.01, 1.5));
            double size = i % 2 == 0 ? 1 : 8;
            double[] o = {random.nextInt(-8, 9) / size, 0, random.nextInt(-8, 9) / size};
            double[] p = {o[0] + random.nextDouble(-1, 9), 0, o[2] + random.nextDouble(-9, 9)};
            double[] q = {o[0] + random.nextDouble(-1, 9), 0, o[2] + random.nextDouble(-9, 9)};
            double[] row = {p[0], 0, p[2], q[0], 0, q[2], q[0], 0, q[2], 0, 0, 0, 0, 0, 0, 0};
            BigDecimal truth = segment(o, p, q, cos);
            double answer = cone(o, new double[] {3, 0, 0}, cos, LeafKind.TRIANGLE, row);
            if (truth == null) {
                silent++;
                assertThat(answer).isInfinite();
                continue;
            }
            heard++;
            double scale = Math.max(Leaves.extent(LeafKind.TRIANGLE, row), truth.doubleValue());
            double error = truth.subtract(new BigDecimal(answer)).abs().doubleValue();
            assertThat(error / Math.ulp(scale)).isLessThanOrEqualTo(8);
        }
        assertThat(heard).isBetween(1000, 2900);
        assertThat(silent).isBetween(100, 2000);
    }

    private static BigDecimal segment(double[] o, double[] p, double[] q, double cos) {
        MathContext digits = RayOracle.DIGITS;
        BigDecimal c = new BigDecimal(cos);
        BigDecimal s = DecimalRoot.of(BigDecimal.ONE.subtract(c.pow(2)), digits);
        BigDecimal px = new BigDecimal(p[0]).subtract(new BigDecimal(o[0]));
        BigDecimal pz = new BigDecimal(p[2]).subtract(new BigDecimal(o[2]));
        BigDecimal ex = new BigDecimal(q[0]).subtract(new BigDecimal(p[0]));
        BigDecimal ez = new BigDecimal(q[2]).subtract(new BigDecimal(p[2]));
        BigDecimal foot =
                px.multiply(ex).add(pz.multiply(ez)).negate().divide(ex.pow(2).add(ez.pow(2)), digits);
        BigDecimal[] shares = {
            BigDecimal.ZERO,
            BigDecimal.ONE,
            foot,
            crossing(px, pz, ex, ez, c, s),
            crossing(px, pz, ex, ez, c, s.negate())
        };
        BigDecimal least = null;
        for (BigDecimal share : shares) {
            if (share == null || share.signum() < 0 || share.compareTo(BigDecimal.ONE) > 0) {
                continue;
            }
            BigDecimal x = px.add(share.multiply(ex));
            BigDecimal z = pz.add(share.multiply(ez));
            BigDecimal length = DecimalRoot.of(x.pow(2).add(z.pow(2)), digits);
            boolean isInside = x.subtract(c.multiply(length)).compareTo(new BigDecimal("-1e-80")) >= 0;
            if (isInside && (least == null || length.compareTo(least) < 0)) {
                least = length;
            }
        }
        return least;
    }

    // Where p + t e is across the direction (c, s).
    private static BigDecimal crossing(
            BigDecimal px, BigDecimal pz, BigDecimal ex, BigDecimal ez, BigDecimal c, BigDecimal s) {
        BigDecimal slope = ez.multiply(c).subtract(ex.multiply(s));
        return slope.signum() == 0
                ? null
                : px.multiply(s).subtract(pz.multiply(c)).divide(slope, RayOracle.DIGITS);
    }

    /** U4: a pole of a thousandth, between the rays of any fan. */
    @Test
    void aThinPoleIsHeard() {
        double[] pole = {10, 0, 0.123, 0.001, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        double[] d = {1, 0, 0};
        double answer = cone(new double[3], d, StrictMath.cos(0.1), LeafKind.UPRIGHT_CYLINDER, pole);
        assertThat(answer).isBetween(Math.hypot(10, 0.123) - 0.0011, Math.hypot(10, 0.123) - 0.0009);
        assertThat(ray(new double[3], d, LeafKind.UPRIGHT_CYLINDER, pole)).isInfinite();
        assertThat(cone(new double[3], d, StrictMath.cos(0.01), LeafKind.UPRIGHT_CYLINDER, pole))
                .isInfinite();
    }

    /** U1: a sphere wholly inside the cone, on its axis and off it. */
    @Test
    void aSphereInsideTheConeIsHeard() {
        double[] sphere = {3, 4, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        assertThat(cone(new double[3], new double[] {3, 4, 0}, 0.5, LeafKind.SPHERE, sphere))
                .isEqualTo(4);
        assertThat(cone(new double[3], new double[] {1, 0, 0}, 0.5, LeafKind.SPHERE, sphere))
                .isEqualTo(4);
    }

    /** (1, 1, 0) and (1, 0, 1) are 60 degrees apart, and its cosine is a double. */
    @Test
    void theBorderBelongsToTheCone() {
        double[] d = {1, 1, 0};
        double[] origin = new double[3];
        double[] touching = {1, 0, 1, 1, -1, 2, 1, -2, 3, 0, 0, 0, 0, 0, 0, 0};
        assertThat(cone(origin, d, 0.5, LeafKind.TRIANGLE, touching)).isEqualTo(Math.sqrt(2));
        assertThat(cone(origin, d, Math.nextUp(0.5), LeafKind.TRIANGLE, touching))
                .isInfinite();
        double[] box = {1.5, -0.5, 1.5, 0.5, 0.5, 0.5, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
        double[] far = {1025.5, -1024.5, 1025.5, 0.5, 0.5, 0.5, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
        double[] apex = {1024, -1024, 1024};
        // The corner (1, 0, 1) is where the box comes nearest; it leaves the cone at once.
        double[] lower = {1.5, -0.5, 2.5, 0.5, 0.5, 1.5, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
        for (LeafKind kind : new LeafKind[] {LeafKind.UPRIGHT_BOX, LeafKind.BOX}) {
            assertThat(cone(origin, d, 0.5, kind, box)).isCloseTo(Math.sqrt(2), within(1e-15));
            assertThat(cone(apex, d, 0.5, kind, far)).isCloseTo(Math.sqrt(2), within(1e-15));
            assertThat(cone(origin, d, 0.5, kind, lower)).isCloseTo(Math.sqrt(2), within(1e-15));
        }
    }

    /** An edge that touches the cone's border from outside, between its ends. */
    @Test
    void aTangentEdgeBelongsToTheCone() {
        double[] d = {1, 1, 0};
        // Through (1, 0, 1) across the axis and the border's direction: (1, 1, 0) x (1, 0, 1) = (1, -1, -1).
        double[] edge = {2, -1, 0, 0, 1, 2, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0};
        assertThat(cone(new double[3], d, 0.5, LeafKind.TRIANGLE, edge)).isCloseTo(Math.sqrt(2), within(1e-15));
        assertThat(cone(new double[3], d, Math.nextUp(0.5), LeafKind.TRIANGLE, edge))
                .isInfinite();
    }

    @Test
    void allocatesNothing() {
        double[][] rows = new double[Leaves.KINDS.length][];
        SplittableRandom random = new SplittableRandom(3);
        for (LeafKind kind : Leaves.KINDS) {
            rows[kind.ordinal()] = Leaves.random(kind, random, 1);
        }
        double cos = StrictMath.cos(0.7);
        double sin = StrictMath.sin(0.7);
        BeamAxis beam = new BeamAxis();
        long bytes = Allocated.everyTime(() -> {
            double sum = 0;
            for (int i = 0; i < 10_000; i++) {
                sum += SpatialCone.distance(
                        beam.line(10 + i * 1e-6, 3, 4, -1, -0.31, -0.42).widen(cos, sin),
                        Leaves.KINDS[i % 9],
                        rows[i % 9],
                        0,
                        Double.POSITIVE_INFINITY,
                        scratch.cone);
            }
            assertThat(sum).isBetween(10_000.0, 200_000.0);
        });
        assertThat(bytes).isLessThan(10_000);
    }

    private double ray(double[] o, double[] d, LeafKind kind, double[] row) {
        return SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
    }

    private double cone(double[] o, double[] d, double cos, LeafKind kind, double[] row) {
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        return SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, sin),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
    }
}
