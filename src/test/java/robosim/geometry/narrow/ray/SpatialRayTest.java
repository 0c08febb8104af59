package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Allocated;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.RayOracle;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

public class SpatialRayTest {
    private static final int[] PRISM_FROM = {0, 8, 2};

    private final Scratch scratch = new Scratch();
    private int hits;
    private int misses;
    private int starts;
    private double worst;

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void agreesWithDecimalsOnRandomRays(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(kind.ordinal());
        for (int i = 0; i < Effort.cases(1500); i++) {
            double size = Math.scalb(1, random.nextInt(-30, 31));
            double[] row = Leaves.random(kind, random, size);
            double[] o = Leaves.vector(random, 3 * size);
            check(o, aimed(o, kind, row, random), kind, row);
        }
        assertMix();
    }

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void agreesWithDecimalsWhereEverythingTies(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(100 + kind.ordinal());
        for (int i = 0; i < Effort.cases(3000); i++) {
            double[] row = Leaves.grid(kind, random);
            double[] o = Leaves.gridVector(random, 5);
            double[] d = Leaves.gridVector(random, 2);
            if (random.nextBoolean()) {
                for (int k = 0; k < 3; k++) {
                    d[k] += (kind == LeafKind.PRISM ? (row[PRISM_FROM[k]] + row[PRISM_FROM[k] + 1]) / 2 : row[k])
                            - o[k];
                }
            }
            if (d[0] == 0 && d[1] == 0 && d[2] == 0) {
                continue;
            }
            int signed = random.nextInt(3);
            d[signed] = d[signed] == 0 ? -0.0 : d[signed];
            if (i % 3 == 0) {
                // Seen from far away, still exactly.
                double[] far = {o[0] - d[0] * 4096, o[1] - d[1] * 4096, o[2] - d[2] * 4096};
                check(far, d, kind, row);
            } else {
                check(o, d, kind, row);
            }
        }
        assertMix();
    }

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void agreesWithDecimalsFromAMillionAway(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(200 + kind.ordinal());
        for (int i = 0; i < Effort.cases(800); i++) {
            double[] row = Leaves.random(kind, random, 1);
            double[] way = Leaves.vector(random, 1);
            double[] o = {way[0] * 1e6, way[1] * 1e6, way[2] * 1e6};
            check(o, aimed(o, kind, row, random), kind, row);
        }
        assertMix();
    }

    /** Tangents missed or hit by some 1e-1 to 1e-17 of the radius. */
    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_CYLINDER", "SPHERE", "CYLINDER", "UPRIGHT_CAPSULE", "CAPSULE"})
    void agreesWithDecimalsOnGrazingRays(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(300 + kind.ordinal());
        for (int i = 0; i < Effort.cases(2000); i++) {
            double[] row = Leaves.random(kind, random, 1);
            double far = i % 2 == 0 ? 1e6 : 3;
            // A point at about the radius from the axis, and a direction across both.
            double[] axis = kind == LeafKind.CYLINDER || kind == LeafKind.CAPSULE
                    ? new double[] {row[7], row[10], row[13]}
                    : kind != LeafKind.SPHERE ? new double[] {0, 1, 0} : unit(Leaves.vector(random, 1));
            double[] out = unit(cross(axis, Leaves.vector(random, 1)));
            double[] d = unit(cross(out, Leaves.vector(random, 1)));
            double gap = StrictMath.pow(10, -random.nextDouble(1, 17)) * (random.nextBoolean() ? 1 : -1);
            double[] o = new double[3];
            for (int k = 0; k < 3; k++) {
                o[k] = row[k] + out[k] * row[3] * (1 + gap) - d[k] * far;
            }
            check(o, d, kind, row);
        }
        assertMix();
    }

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void powersOfTwoScaleTheBits(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(400 + kind.ordinal());
        int hit = 0;
        for (int i = 0; i < 400; i++) {
            boolean isTied = i % 2 == 0;
            double[] row = isTied ? Leaves.grid(kind, random) : Leaves.random(kind, random, 1);
            double[] o = isTied ? Leaves.gridVector(random, 4) : Leaves.vector(random, 3);
            double[] d = aimed(o, kind, row, random);
            double distance = ray(o, d, kind, row);
            hit += distance > 0 && Double.isFinite(distance) ? 1 : 0;
            for (int power : new int[] {-900, -300, -40, 40, 97}) {
                double[] far = {Math.scalb(o[0], power), Math.scalb(o[1], power), Math.scalb(o[2], power)};
                double[] same = Leaves.scaled(kind, row, power);
                assertThat(ray(far, d, kind, same))
                        .as(name(o, d, kind, row) + " times 2^" + power)
                        .isCloseTo(
                                Math.scalb(distance, power),
                                org.assertj.core.data.Offset.offset(
                                        Double.isFinite(distance)
                                                ? 8
                                                        * Math.ulp(Math.scalb(
                                                                Math.max(distance, Leaves.extent(kind, row)), power))
                                                : 0));
            }
            double[] longer = {d[0] * 0x1p500, d[1] * 0x1p500, d[2] * 0x1p500};
            assertThat(ray(o, longer, kind, row)).isEqualTo(distance);
        }
        assertThat(hit).isGreaterThan(50);
    }

    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void subnormalsAreDecidedToo(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(500 + kind.ordinal());
        for (int i = 0; i < 100; i++) {
            double[] row = Leaves.scaled(kind, Leaves.grid(kind, random), -1073);
            double[] o = Leaves.gridVector(random, 5);
            double[] tiny = {o[0] * 0x1p-1073, o[1] * 0x1p-1073, o[2] * 0x1p-1073};
            double[] d = {random.nextInt(1, 3), random.nextInt(-2, 3), random.nextInt(-2, 3)};
            check(tiny, d, kind, row);
        }
        assertThat(hits).isPositive();
        assertThat(misses).isPositive();
    }

    /** Shooting again from the hit answers next to nothing. */
    @ParameterizedTest
    @EnumSource(
            names = {"TRIANGLE", "MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void startsInsideSolidsAnswerZero(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(600 + kind.ordinal());
        for (int i = 0; i < 300; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double[] center = kind == LeafKind.PRISM
                    ? new double[] {(row[0] + row[1]) / 2, (row[8] + row[9]) / 2, (row[2] + row[3]) / 2}
                    : new double[] {row[0], row[1], row[2]};
            assertThat(ray(center, Leaves.vector(random, 1), kind, row)).isZero();
        }
    }

    @Test
    void allocatesNothingWhileDoublesAreEnough() {
        SplittableRandom random = new SplittableRandom(7);
        double[][] rows = new double[Leaves.KINDS.length][];
        for (LeafKind kind : Leaves.KINDS) {
            rows[kind.ordinal()] = Leaves.random(kind, random, 1);
        }
        BeamAxis beam = new BeamAxis();
        long bytes = Allocated.everyTime(() -> {
            double sum = 0;
            for (int i = 0; i < 20_000; i++) {
                // Past everything: no verdict is close.
                beam.line(10 + i * 1e-6, 20, 30, 1, 0.3, 0.2);
                sum += Math.min(1, SpatialRay.distance(beam, Leaves.KINDS[i % 9], rows[i % 9], 0, scratch.ray));
            }
            assertThat(sum).isEqualTo(20_000);
        });
        assertThat(bytes).isLessThan(20_000);
    }

    private void check(double[] o, double[] d, LeafKind kind, double[] row) {
        String name = name(o, d, kind, row);
        double distance = ray(o, d, kind, row);
        BigDecimal truth = RayOracle.distance(o, d, kind, row);
        if (truth == null) {
            misses++;
            assertThat(distance).as(name).isEqualTo(Double.POSITIVE_INFINITY);
            return;
        }
        assertThat(distance).as(name).isFinite().isNotNegative();
        if (truth.signum() == 0) {
            starts++;
            assertThat(distance).as(name).isZero();
            return;
        }
        hits++;
        double largest = Math.max(truth.doubleValue(), Leaves.extent(kind, row));
        for (double x : o) {
            largest = Math.max(largest, Math.abs(x));
        }
        double error = truth.subtract(new BigDecimal(distance)).abs().doubleValue() / Math.ulp(largest);
        assertThat(error).as(name + " off by ulp").isLessThanOrEqualTo(4);
        worst = Math.max(worst, error);
    }

    private void assertMix() {
        int all = hits + misses + starts;
        assertThat(hits)
                .as("%d hits, %d misses, %d starts inside", hits, misses, starts)
                .isBetween(all / 15, all);
        assertThat(misses).isBetween(all / 20, all * 19 / 20);
        assertThat(worst).isBetween(0.1, 4.0);
    }

    private double ray(double[] o, double[] d, LeafKind kind, double[] row) {
        return SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
    }

    // Half of the rays go at about the leaf, the others anywhere near.
    private static double[] aimed(double[] o, LeafKind kind, double[] row, SplittableRandom random) {
        double[] aim = {row[0], row[1], row[2]};
        double spread = row[3];
        if (kind == LeafKind.PRISM) {
            aim = new double[] {(row[0] + row[1]) / 2, (row[8] + row[9]) / 2, (row[2] + row[3]) / 2};
            spread = row[1] - row[0];
        } else if (kind == LeafKind.TRIANGLE) {
            double v = random.nextDouble(-0.2, 1);
            double w = random.nextDouble(-0.2, 1 - v);
            for (int i = 0; i < 3; i++) {
                aim[i] += v * (row[3 + i] - row[i]) + w * (row[6 + i] - row[i]);
            }
            spread = 0;
        }
        if (kind.isCapsule()) {
            double along = random.nextDouble(-1.2, 1.2) * row[4];
            for (int i = 0; i < 3; i++) {
                aim[i] += along * (kind == LeafKind.CAPSULE ? row[7 + 3 * i] : i == 1 ? 1 : 0);
            }
        }
        double[] d = new double[3];
        double length = random.nextDouble(0.1, 10);
        for (int i = 0; i < 3; i++) {
            d[i] = (aim[i] + random.nextDouble(-1.3, 1.3) * spread - o[i]) * length;
        }
        if (d[0] == 0 && d[1] == 0 && d[2] == 0) {
            d[0] = 1;
        }
        return d;
    }

    public static double[] unit(double[] v) {
        double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    public static String name(double[] o, double[] d, LeafKind kind, double[] row) {
        return "ray %s %s, kind %s %s".formatted(Arrays.toString(o), Arrays.toString(d), kind, Arrays.toString(row));
    }
}
