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
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.RayOracle;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;
import robosim.geometry.narrow.ray.SpatialRayTest;
import robosim.geometry.reference.DecimalRoot;

@Tag("slow")
class SpatialConeTest {
    private static final int SAMPLES = 400;
    private final Scratch scratch = new Scratch();

    /** No ray inside the cone is shorter, and one that is led towards the answer attains it. */
    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void isTheShortestOfAllRaysInTheCone(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(kind.ordinal());
        int heard = 0;
        int silent = 0;
        int attained = 0;
        int thin = 0;
        int beyondAxis = 0;
        int cases = Effort.cases(400, 160);
        for (int i = 0; i < cases; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double[] o = Leaves.vector(random, 4);
            double[] d = SpatialRayTest.unit(Leaves.vector(random, 1));
            if (random.nextInt(4) > 0) {
                double[] near = Leaves.vector(random, 2);
                d = SpatialRayTest.unit(new double[] {near[0] - o[0], near[1] - o[1], near[2] - o[2]});
            }
            double half = random.nextBoolean() ? random.nextDouble(0.001, 0.3) : random.nextDouble(0.001, 1.57);
            double cos = StrictMath.cos(half);
            double answer = cone(o, d, cos, kind, row);
            Search search = new Search(o, d, cos, kind, row, random);
            double found = search.shortest();
            String name = "half %s, %s".formatted(half, SpatialRayTest.name(o, d, kind, row));
            assertThat(answer).as(name).isNotNegative();
            if (answer == 0) {
                assertThat(found).as(name).isZero();
                continue;
            }
            assertThat(found).as(name).isGreaterThanOrEqualTo(answer * (1 - 1e-13));
            if (Double.isInfinite(answer)) {
                silent++;
                continue;
            }
            heard++;
            beyondAxis += Double.isInfinite(ray(o, d, kind, row)) ? 1 : 0;
            if (Double.isInfinite(found)) {
                thin++;
            } else if (found <= answer * (1 + 1e-5)) {
                attained++;
            }
        }
        assertThat(heard).isBetween(cases / 4, cases * 39 / 40);
        assertThat(silent).isBetween(cases / 40, cases * 3 / 4);
        assertThat(beyondAxis).as("the axis misses").isGreaterThan(cases / 20);
        assertThat(thin).as("heard, but by no sampled ray").isLessThan(heard / 20 + 1);
        assertThat(attained).as("%d heard, %d thin", heard, thin).isGreaterThanOrEqualTo((heard - thin) * 97 / 100);
    }

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

    /** Where the cone's axis is level and the cylinder tall and upright, the nearest place is on the level: 60 digits. */
    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_CYLINDER", "SPHERE", "CYLINDER"})
    void aTallCylinderOnTheLevelIsADisc(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(70 + kind.ordinal());
        int heard = 0;
        int silent = 0;
        for (int i = 0; i < 2000; i++) {
            double half = random.nextDouble(0.05, 1.4);
            double cos = StrictMath.cos(half);
            double sin = StrictMath.sin(half);
            double along = random.nextDouble(2, 20);
            double radius = random.nextDouble(0.1, 1.9);
            double[] row = new double[Leaf.STRIDE];
            Rotations.identity(row, Leaf.ROTATION);
            double aside = radius * (1 - StrictMath.pow(10, -random.nextDouble(0.1, 13)) * (i % 4 == 0 ? -1 : 1));
            row[0] = along * cos - aside * sin;
            row[2] = along * sin + aside * cos;
            row[3] = radius;
            row[4] = 3;
            BigDecimal truth = disc(row[0], row[2], radius, cos);
            double answer = cone(new double[3], new double[] {2, 0, 0}, cos, kind, row);
            if (truth == null) {
                silent++;
                // A cylinder is apart only where that is proved, which rounding hides in the last bits.
                if (kind == LeafKind.SPHERE || aside > radius * (1 + 2e-12)) {
                    assertThat(answer).isInfinite();
                }
                continue;
            }
            heard++;
            assertThat(new BigDecimal(answer)).isLessThanOrEqualTo(truth.multiply(new BigDecimal(1 + 0x1p-50)));
            assertThat(new BigDecimal(answer)).isGreaterThanOrEqualTo(truth.multiply(new BigDecimal(1 - 0x1p-40)));
        }
        assertThat(heard).isBetween(1000, 1900);
        assertThat(silent).isBetween(100, 1000);
    }

    // Along the border's direction in the plane, which is the nearest to the centre's; null where it passes.
    private static BigDecimal disc(double x, double z, double r, double cos) {
        MathContext digits = RayOracle.DIGITS;
        BigDecimal c = new BigDecimal(cos);
        BigDecimal s = DecimalRoot.of(BigDecimal.ONE.subtract(c.pow(2)), digits);
        BigDecimal bx = new BigDecimal(x);
        BigDecimal bz = new BigDecimal(z);
        BigDecimal ahead = bx.multiply(c).add(bz.multiply(s));
        BigDecimal aside = bz.multiply(c).subtract(bx.multiply(s));
        BigDecimal square = new BigDecimal(r).pow(2).subtract(aside.pow(2));
        return square.signum() < 0 ? null : ahead.subtract(DecimalRoot.of(square, digits));
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

    /** Random rays in the cone, the best of them led on by ever smaller steps. */
    private final class Search {
        private final double[] o;
        private final double[] d;
        private final double half;
        private final LeafKind kind;
        private final double[] row;
        private final SplittableRandom random;
        private double[] best;
        private double least = Double.POSITIVE_INFINITY;

        Search(double[] o, double[] d, double cos, LeafKind kind, double[] row, SplittableRandom random) {
            this.o = o;
            this.d = d;
            this.half = Math.acos(cos) * (1 - 1e-9);
            this.kind = kind;
            this.row = row;
            this.random = random;
            this.best = d;
        }

        double shortest() {
            look(d);
            for (int i = 0; i < SAMPLES; i++) {
                double[] any = SpatialRayTest.unit(Leaves.vector(random, 1));
                double angle = half * (i % 3 == 0 ? 1 : Math.sqrt(random.nextDouble()));
                look(turned(d, any, angle));
                // Towards a point of the leaf, or as near to it as the cone goes.
                look(point());
            }
            double step = 0.3;
            for (int i = 0; i < 1500 && Double.isFinite(least); i++) {
                double before = least;
                double[] any = Leaves.vector(random, step);
                look(new double[] {best[0] + any[0], best[1] + any[1], best[2] + any[2]});
                step *= least < before ? 1.6 : 0.98;
            }
            // Points of the leaf, led on likewise in the leaf's own coordinates, where faces and edges are limits.
            double[] at = {0.3, 0.3, 0.3};
            double shortest = Double.POSITIVE_INFINITY;
            step = 2;
            for (int i = 0; i < 4000; i++) {
                double[] next = new double[3];
                int only = random.nextInt(6);
                for (int k = 0; k < 3; k++) {
                    double by = only < 3 && only != k ? 0 : random.nextDouble(-step, step);
                    next[k] = Math.max(-1, Math.min(1, at[k] + by));
                }
                double[] p = own(next);
                double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                double ahead = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
                boolean inside = ahead >= Math.cos(half) * length;
                if (inside && length < shortest) {
                    shortest = length;
                    at = next;
                    step = Math.min(2, step * 1.6);
                } else {
                    step = Double.isInfinite(shortest) ? 2 : Math.max(1e-9, step * 0.98);
                }
            }
            least = Math.min(least, shortest);
            return least;
        }

        // From three numbers in [-1, 1] to a point of the leaf seen from the apex.
        private double[] own(double[] p) {
            double[] v = new double[3];
            double round = (p[0] + 1) / 2;
            double x = round * StrictMath.cos(Math.PI * p[2]);
            double z = round * StrictMath.sin(Math.PI * p[2]);
            double along = p[1] * (row[4] + row[3]); // of a capsule: to its segment's share, and up from there
            double share = Math.max(-1, Math.min(1, along / row[4]));
            double up = along - share * row[4];
            double aside = Math.sqrt(Math.max(0, (row[3] - up) * (row[3] + up)));
            double first = (p[0] + 1) / 2;
            double second = Math.min((p[1] + 1) / 2, 1 - first);
            double px = (row[0] + row[1]) / 2 + p[0] * (row[1] - row[0]) / 2;
            double low = Math.max(row[2], Math.max(row[4] - px, px - row[7]));
            double high = Math.min(row[3], Math.min(row[5] - px, px - row[6]));
            for (int i = 0; i < 3; i++) {
                v[i] = switch (kind) {
                    case TRIANGLE -> row[i] + first * (row[3 + i] - row[i]) + second * (row[6 + i] - row[i]);
                    case PRISM ->
                        i == 0
                                ? px
                                : i == 1
                                        ? (row[8] + row[9]) / 2 + p[1] * (row[9] - row[8]) / 2
                                        : (low + high) / 2 + p[2] * (high - low) / 2;
                    case BOX, UPRIGHT_BOX ->
                        row[i]
                                + p[0] * row[3] * row[6 + 3 * i]
                                + p[1] * row[4] * row[7 + 3 * i]
                                + p[2] * row[5] * row[8 + 3 * i];
                    case CYLINDER ->
                        row[i]
                                + x * row[3] * row[6 + 3 * i]
                                + p[1] * row[4] * row[7 + 3 * i]
                                + z * row[3] * row[8 + 3 * i];
                    case UPRIGHT_CAPSULE -> row[i] + (i == 1 ? up + share * row[4] : (i == 0 ? x : z) * aside);
                    case CAPSULE ->
                        row[i]
                                + x * aside * row[6 + 3 * i]
                                + (up + share * row[4]) * row[7 + 3 * i]
                                + z * aside * row[8 + 3 * i];
                    case UPRIGHT_CYLINDER -> row[i] + (i == 1 ? p[1] * row[4] : (i == 0 ? x : z) * row[3]);
                    case SPHERE -> row[i];
                    case MESH, SOLID_MESH, GRID -> throw kind.refused();
                };
                v[i] -= o[i];
            }
            return v;
        }

        private double[] point() {
            double[] p = Leaves.vector(random, 1);
            double[] v = new double[3];
            for (int i = 0; i < 3; i++) {
                v[i] = switch (kind) {
                    case TRIANGLE ->
                        row[i]
                                + Math.abs(p[0] + p[1]) / 2 * (row[3 + i] - row[i])
                                + (1 - Math.abs(p[0] + p[1]) / 2) * Math.abs(p[2]) * (row[6 + i] - row[i]);
                    case PRISM ->
                        (row[i == 0 ? 0 : i == 1 ? 8 : 2] + row[i == 0 ? 1 : i == 1 ? 9 : 3]) / 2
                                + p[i] * (row[i == 0 ? 1 : i == 1 ? 9 : 3] - row[i == 0 ? 0 : i == 1 ? 8 : 2]) / 2;
                    case BOX, UPRIGHT_BOX ->
                        row[i]
                                + p[0] * row[3] * row[6 + 3 * i]
                                + p[1] * row[4] * row[7 + 3 * i]
                                + p[2] * row[5] * row[8 + 3 * i];
                    case CYLINDER ->
                        row[i]
                                + 0.7 * p[0] * row[3] * row[6 + 3 * i]
                                + p[1] * row[4] * row[7 + 3 * i]
                                + 0.7 * p[2] * row[3] * row[8 + 3 * i];
                    case UPRIGHT_CYLINDER, SPHERE ->
                        row[i] + 0.7 * p[i] * row[i == 1 && kind == LeafKind.UPRIGHT_CYLINDER ? 4 : 3];
                    case UPRIGHT_CAPSULE -> row[i] + 0.7 * p[i] * row[3] + (i == 1 ? p[1] * row[4] : 0);
                    case CAPSULE -> row[i] + 0.7 * p[i] * row[3] + p[1] * row[4] * row[7 + 3 * i];
                    case MESH, SOLID_MESH, GRID -> throw kind.refused();
                };
                v[i] -= o[i];
            }
            return v;
        }

        // Turned into the cone where it is outside.
        private void look(double[] direction) {
            double[] v = SpatialRayTest.unit(direction);
            double c = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
            double angle = Math.acos(Math.max(-1, Math.min(1, c)));
            double[] inside = angle <= half ? v : turned(d, v, half);
            double distance = ray(o, inside, kind, row);
            if (distance < least) {
                least = distance;
                best = inside;
            }
        }

        // From a unit vector by an angle towards another.
        private double[] turned(double[] from, double[] to, double angle) {
            double c = from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
            double[] side =
                    SpatialRayTest.unit(new double[] {to[0] - c * from[0], to[1] - c * from[1], to[2] - c * from[2]});
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            return new double[] {
                cos * from[0] + sin * side[0], cos * from[1] + sin * side[1], cos * from[2] + sin * side[2]
            };
        }
    }
}
