package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** A box in a cone, of which only the features near a plain solution are computed, has the distance of all features, to the bit. */
@Tag("slow")
class PlainConeBoxTest {
    private static final int CASES = Effort.cases(30_000);

    private final Scratch scratch = new Scratch();
    private final PlainConeBox plain = new PlainConeBox();
    private final Cone cone = new Cone();

    /** By how many of its faces the solution lies on. */
    private final int[] found = new int[7];

    private int beyond;
    private int unsure;
    private int cut;

    @ParameterizedTest
    @EnumSource(names = {"BOX", "UPRIGHT_BOX"})
    void saysTheSameOfRandomCones(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(61);
        for (int i = 0; i < CASES; i++) {
            double size = Math.scalb(1, random.nextInt(-30, 31));
            double[] row = Leaves.random(kind, random, size);
            row[3 + random.nextInt(3)] *= random.nextInt(3) == 0 ? 0.05 : 1;
            double[] o = Leaves.vector(random, random.nextInt(1, 5) * size);
            double half = random.nextInt(3) > 0 ? random.nextDouble(0.02, 0.3) : random.nextDouble(0.001, 1.57);
            double[] d = Leaves.vector(random, 1);
            if (random.nextInt(3) > 0) {
                d = toward(o, placed(row, Leaves.vector(random, random.nextDouble(0.5, 3))));
            }
            compare(kind, row, o, d, StrictMath.cos(half), random);
        }
        assertThat(found[1]).as("faces").isGreaterThan(CASES / 15);
        assertThat(found[2]).as("edges").isGreaterThan(CASES / 15);
        assertThat(found[3]).as("corners").isGreaterThan(CASES / 150);
        assertThat(beyond).isGreaterThan(CASES * 2 / 15);
        assertThat(unsure).isBetween(CASES / 300, CASES / 3);
        assertThat(cut).as("beyond a limit").isGreaterThan(CASES / 30);
    }

    /** Borders through corners and edges, tangent to edges, axes along faces, thin boxes, from the surface: off by some ulps. */
    @ParameterizedTest
    @EnumSource(names = {"BOX", "UPRIGHT_BOX"})
    void saysTheSameWhereFeaturesTie(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(62);
        for (int i = 0; i < CASES; i++) {
            double[] row = random.nextBoolean() ? Leaves.grid(kind, random) : Leaves.random(kind, random, 2);
            if (random.nextInt(4) == 0) {
                row[3 + random.nextInt(3)] *= Math.scalb(1, -random.nextInt(60));
            }
            double[] o = random.nextInt(5) == 0 ? placed(row, tie(random)) : Leaves.gridVector(random, 6);
            double[] d = toward(o, placed(row, tie(random)));
            if (random.nextInt(3) == 0) {
                Arrays.fill(d, 0);
                d[random.nextInt(3)] = random.nextBoolean() ? 1 : -1;
            }
            if (random.nextInt(3) == 0) { // along a face
                int axis = random.nextInt(3);
                for (int k = 0; k < 3; k++) {
                    d[k] = row[6 + 3 * k + axis];
                }
            }
            double[] border = toward(o, placed(row, tie(random)));
            double cos = dot(d, border) / Math.sqrt(dot(d, d) * dot(border, border));
            if (!(cos > 0 && cos < 1)) {
                cos = StrictMath.cos(random.nextDouble(0.01, 1.5));
            }
            for (int k = random.nextInt(4); k > 0; k--) {
                cos = random.nextBoolean() ? Math.nextUp(cos) : Math.nextDown(cos);
            }
            for (int axis = 0; axis < 3; axis++) {
                o[axis] += random.nextInt(-2, 3) * Math.ulp(o[axis]);
            }
            if (dot(d, d) > 0 && cos < 1) {
                compare(kind, row, o, d, cos, random);
            }
        }
        assertThat(found[1]).isGreaterThan(CASES / 30);
        assertThat(found[2] + found[3]).isGreaterThan(CASES / 30);
        assertThat(beyond).isGreaterThan(CASES / 30);
        assertThat(unsure).isGreaterThan(CASES / 30);
    }

    private void compare(LeafKind kind, double[] row, double[] o, double[] d, double cos, SplittableRandom random) {
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        double all = SpatialCone.all(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, sin),
                kind,
                row,
                0,
                Double.POSITIVE_INFINITY,
                scratch.cone);
        double near = near(o, d, cos, sin, kind, row, Double.POSITIVE_INFINITY);
        if (Double.doubleToLongBits(near) != Double.doubleToLongBits(all)) {
            assertThat(near).as(name(kind, row, o, d, cos)).isEqualTo(all);
        }
        count(o, d, cos, row);
        double limit = random.nextInt(3) == 0 ? all : all * random.nextDouble(0.5, 1.5);
        double limited = near(o, d, cos, sin, kind, row, limit);
        if (limited != all) {
            cut++;
            assertThat(limited == Double.POSITIVE_INFINITY && all > limit)
                    .as("%s: %s of %s within %s", name(kind, row, o, d, cos), limited, all, limit)
                    .isTrue();
        }
    }

    private static String name(LeafKind kind, double[] row, double[] o, double[] d, double cos) {
        return "%s %s from %s along %s, cosine %s"
                .formatted(kind, Arrays.toString(row), Arrays.toString(o), Arrays.toString(d), cos);
    }

    private double near(double[] o, double[] d, double cos, double sin, LeafKind kind, double[] row, double limit) {
        return SpatialCone.distance(
                new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, sin),
                kind,
                row,
                0,
                limit,
                scratch.cone);
    }

    private void count(double[] o, double[] d, double cos, double[] row) {
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        cone.set(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]).widen(cos, sin), o[1]);
        int known = plain.look(cone, row, 0, Double.POSITIVE_INFINITY);
        beyond += known == PlainConeBox.BEYOND ? 1 : 0;
        unsure += known == PlainConeBox.UNSURE ? 1 : 0;
        if (known == PlainConeBox.FOUND) {
            int near = 0;
            for (int k = 0; k < 6; k++) {
                near += plain.isNear(k / 2, k % 2) ? 1 : 0;
            }
            found[near]++;
        }
    }

    /** Corners, middles of edges and of faces, and points beside them. */
    private static double[] tie(SplittableRandom random) {
        return new double[] {random.nextInt(-2, 3) / 2.0 * (random.nextInt(5) == 0 ? 3 : 1), one(random), one(random)};
    }

    private static double one(SplittableRandom random) {
        return random.nextInt(-1, 2);
    }

    private static double[] placed(double[] row, double[] own) {
        double[] at = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = row[axis]
                    + row[6 + 3 * axis] * own[0] * row[3]
                    + row[7 + 3 * axis] * own[1] * row[4]
                    + row[8 + 3 * axis] * own[2] * row[5];
        }
        return at;
    }

    private static double[] toward(double[] from, double[] to) {
        return new double[] {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
