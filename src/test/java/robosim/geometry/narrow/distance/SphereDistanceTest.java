package robosim.geometry.narrow.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static robosim.geometry.reference.Decimals.minus;
import static robosim.geometry.reference.Decimals.plus;
import static robosim.geometry.reference.Decimals.times;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.narrow.CylinderTwin;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Decimals;

/** Distances of spheres against decimals of 60 digits. */
class SphereDistanceTest {
    private static final MathContext DIGITS = new MathContext(60);
    private final Scratch scratch = new Scratch();

    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "UPRIGHT_BOX", "UPRIGHT_CYLINDER", "BOX", "CYLINDER", "TRIANGLE"})
    void isAFewUlpBelowTheTruthHoweverClose(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(71 + kind.ordinal());
        double worst = 0;
        int apart = 0;
        int count = 400;
        for (int n = 0; n < count; n++) {
            double scale = Math.scalb(1.0, n % 4 == 0 ? random.nextInt(-40, 41) : 0);
            double off = n % 5 == 0 ? 1e6 * scale : 0;
            double[] row = moved(kind, Rows.random(kind, random, 1), scale, off);
            double[] ball = moved(LeafKind.SPHERE, Rows.random(LeafKind.SPHERE, random, 2.5), scale, off);
            ball[3] = n % 7 == 0 ? 0 : ball[3];
            BigDecimal core = core(kind, row, ball);
            if (n % 2 == 0) { // nearly or just touching
                double close = core.doubleValue() * (1 - Math.pow(10, -random.nextDouble(1, 17)));
                ball[3] = close;
            }
            BigDecimal truth = core.subtract(new BigDecimal(ball[3]));
            String pair = Arrays.toString(ball) + " with " + kind + " " + Arrays.toString(row) + " truth " + truth;
            double answer = SpatialDistance.between(
                    new Leaf(kind, row, 0), new Leaf(LeafKind.SPHERE, ball, 0), scratch.distance);
            assertThat(SpatialDistance.between(
                            new Leaf(LeafKind.SPHERE, ball, 0), new Leaf(kind, row, 0), scratch.distance))
                    .as(pair)
                    .isEqualTo(answer);
            if (truth.signum() <= 0) {
                assertThat(answer).as(pair).isZero();
                continue;
            }
            apart++;
            assertThat(new BigDecimal(answer)).as(pair).isLessThanOrEqualTo(truth);
            BigDecimal missing = truth.subtract(new BigDecimal(answer));
            double allowed = 4 * Math.ulp(truth.doubleValue()) + 0x1p-60 * 8 * scale;
            assertThat(missing.doubleValue()).as(pair).isLessThanOrEqualTo(allowed);
            worst = Math.max(worst, missing.doubleValue() / Math.ulp(truth.doubleValue()));
        }
        assertThat(apart).isBetween(count * 4 / 10, count - 1);
        assertThat(worst).isGreaterThan(1);
    }

    private static double[] moved(LeafKind kind, double[] row, double scale, double off) {
        double[] out = row.clone();
        int lengths = kind == LeafKind.TRIANGLE ? 9 : 6;
        for (int k = 0; k < lengths; k++) {
            out[k] = row[k] * scale + (k < 3 || kind == LeafKind.TRIANGLE ? off : 0);
        }
        return out;
    }

    /** The distance of the sphere's centre. */
    private static BigDecimal core(LeafKind kind, double[] row, double[] ball) {
        BigDecimal[] p = CylinderTwin.decimals(ball);
        return switch (kind) {
            case SPHERE ->
                root(square(minus(p, CylinderTwin.decimals(row))))
                        .subtract(new BigDecimal(row[3]))
                        .max(BigDecimal.ZERO);
            case UPRIGHT_CYLINDER, CYLINDER -> cylinder(kind, row, p);
            case TRIANGLE -> root(triangle(corner(row, 0), corner(row, 3), corner(row, 6), p));
            case UPRIGHT_BOX, BOX, PRISM -> box(row, p);
            case UPRIGHT_CAPSULE, CAPSULE, MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private static BigDecimal cylinder(LeafKind kind, double[] row, BigDecimal[] p) {
        BigDecimal[] a = kind == LeafKind.CYLINDER
                ? CylinderTwin.decimals(row[7], row[10], row[13])
                : CylinderTwin.decimals(0, 1, 0);
        BigDecimal[] w = minus(p, CylinderTwin.decimals(row));
        BigDecimal length = root(square(a));
        BigDecimal along = Decimals.dot(w, a).abs().divide(length, DIGITS);
        BigDecimal across = root(square(Decimals.cross(w, a))).divide(length, DIGITS);
        BigDecimal above =
                along.subtract(new BigDecimal(row[4]).multiply(length)).max(BigDecimal.ZERO);
        BigDecimal beside = across.subtract(new BigDecimal(row[3])).max(BigDecimal.ZERO);
        return root(above.multiply(above).add(beside.multiply(beside)));
    }

    /** The least of the twelve triangles of its sides, or 0 inside. */
    private static BigDecimal box(double[] row, BigDecimal[] p) {
        BigDecimal[][] halves = new BigDecimal[3][];
        for (int k = 0; k < 3; k++) {
            halves[k] = times(CylinderTwin.decimals(row[6 + k], row[9 + k], row[12 + k]), new BigDecimal(row[3 + k]));
        }
        BigDecimal[] centre = CylinderTwin.decimals(row);
        BigDecimal[] w = minus(p, centre);
        boolean inside = true;
        BigDecimal least = null;
        for (int k = 0; k < 3; k++) {
            BigDecimal[] u = halves[(k + 1) % 3];
            BigDecimal[] v = halves[(k + 2) % 3];
            BigDecimal[] normal = Decimals.cross(u, v);
            inside &= Decimals.dot(w, normal)
                            .abs()
                            .compareTo(Decimals.dot(halves[k], normal).abs())
                    <= 0;
            for (int side = -1; side <= 1; side += 2) {
                BigDecimal[] middle = plus(centre, times(halves[k], BigDecimal.valueOf(side)));
                BigDecimal[] first = minus(minus(middle, u), v);
                BigDecimal[] last = plus(plus(middle, u), v);
                BigDecimal[] one = plus(minus(middle, u), v);
                BigDecimal[] other = minus(plus(middle, u), v);
                BigDecimal square = triangle(first, last, one, p).min(triangle(first, last, other, p));
                least = least == null ? square : least.min(square);
            }
        }
        return inside ? BigDecimal.ZERO : root(least);
    }

    /** The squared distance: of the edges, and of the plane where the foot is within. */
    private static BigDecimal triangle(BigDecimal[] a, BigDecimal[] b, BigDecimal[] c, BigDecimal[] p) {
        BigDecimal least = segment(a, b, p).min(segment(b, c, p)).min(segment(c, a, p));
        BigDecimal[] normal = Decimals.cross(minus(b, a), minus(c, a));
        if (square(normal).signum() == 0) {
            return least;
        }
        boolean within = side(a, b, p, normal) && side(b, c, p, normal) && side(c, a, p, normal);
        BigDecimal height = Decimals.dot(minus(p, a), normal);
        return within ? least.min(height.multiply(height).divide(square(normal), DIGITS)) : least;
    }

    private static boolean side(BigDecimal[] a, BigDecimal[] b, BigDecimal[] p, BigDecimal[] normal) {
        return Decimals.dot(Decimals.cross(minus(b, a), minus(p, a)), normal).signum() >= 0;
    }

    private static BigDecimal segment(BigDecimal[] a, BigDecimal[] b, BigDecimal[] p) {
        BigDecimal[] e = minus(b, a);
        BigDecimal length = square(e);
        BigDecimal along = length.signum() == 0
                ? BigDecimal.ZERO
                : Decimals.dot(minus(p, a), e).divide(length, DIGITS);
        along = along.max(BigDecimal.ZERO).min(BigDecimal.ONE);
        return square(minus(minus(p, a), times(e, along)));
    }

    private static BigDecimal[] corner(double[] row, int at) {
        return CylinderTwin.decimals(row[at], row[at + 1], row[at + 2]);
    }

    private static BigDecimal root(BigDecimal square) {
        return CylinderTwin.root(square);
    }

    private static BigDecimal square(BigDecimal[] v) {
        return Decimals.dot(v, v);
    }
}
