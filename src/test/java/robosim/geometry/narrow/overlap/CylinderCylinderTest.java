package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.CylinderTwin;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.reference.Decimals;

class CylinderCylinderTest {
    private final Scratch scratch = new Scratch();

    /**
     * Pairs made to be a gap of 10^-3 to 10^-16 of their size apart, or so deep in each other: outside 2^-40 of the size
     * every answer is right and certain; inside, what is called certain is right.
     */
    @Test
    void certainAnswersAreRightAndGapsAboveTheBoundAreCertain() {
        SplittableRandom random = new SplittableRandom(101);
        int apart = 0;
        int touching = 0;
        int doubtful = 0;
        int close = 0;
        for (int n = 0; n < Effort.cases(2000); n++) {
            double scale = Math.scalb(1.0, n % 5 == 0 ? random.nextInt(-40, 41) : 0);
            double[] direction = new double[3];
            LeafKind kindA = n % 3 == 0 ? LeafKind.UPRIGHT_CYLINDER : LeafKind.CYLINDER;
            double[] a = cylinder(random, scale);
            double[] b = cylinder(random, scale);
            if (n % 7 == 0) {
                nearlyParallel(kindA, a, b, random);
            }
            direction(n / 3 % 6, kindA, a, b, random, direction);
            double share = Math.pow(10, -random.nextDouble(3, 16)) * (random.nextBoolean() ? 1 : -1);
            double gap = share * 3 * scale;
            place(kindA, a, b, direction, gap, n % 4 == 0 ? 1e6 * scale : 0);
            CylinderTwin p = new CylinderTwin(kindA, a);
            CylinderTwin q = new CylinderTwin(LeafKind.CYLINDER, b);
            BigDecimal[] normal = CylinderTwin.decimals(direction);
            double width = Math.max(p.gap(q, normal).doubleValue(), p.widestOfCaps(q));
            boolean isApart = width > 0;
            boolean isTouching = !isApart && meet(p, q, normal);
            String pair = kindA + " " + Arrays.toString(a) + " with " + Arrays.toString(b) + " gap " + width + " along "
                    + Arrays.toString(direction);
            double bound = 0x1p-40 * scale;
            scratch.overlap.uncertain = false;
            boolean answer =
                    SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(LeafKind.CYLINDER, b, 0), scratch.overlap);
            boolean certain = !scratch.overlap.uncertain;
            assertThat(SpatialOverlap.test(new Leaf(LeafKind.CYLINDER, b, 0), new Leaf(kindA, a, 0), scratch.overlap))
                    .as(pair + " swapped")
                    .isEqualTo(answer);
            if (isApart) {
                apart++;
                assertThat(answer && (certain || width > bound)).as(pair).isFalse();
            } else if (isTouching) {
                touching++;
                assertThat(answer).as(pair).isTrue();
            }
            if (isApart || isTouching) {
                assertThat(answer).as(pair).isEqualTo(isTouching || !certain);
            }
            if (!certain) {
                // Apart or in each other by less than the bound, along the direction that it tells.
                BigDecimal[] told =
                        CylinderTwin.decimals(scratch.gjk.hull.x(), scratch.gjk.hull.y(), scratch.gjk.hull.z());
                double along = Math.max(
                        p.gap(q, told).doubleValue(),
                        p.gap(q, CylinderTwin.negate(told)).doubleValue());
                assertThat(Math.abs(Math.max(width, along)))
                        .as(pair + " doubtful")
                        .isLessThan(bound);
                doubtful++;
            }
            close += Math.abs(width) < bound ? 1 : 0;
        }
        assertThat(apart).isGreaterThan(Effort.cases(700));
        assertThat(touching).isGreaterThan(Effort.cases(400));
        assertThat(close).isGreaterThan(Effort.cases(300));
        assertThat(doubtful).isBetween(1, close / 2);
    }

    private static double[] cylinder(SplittableRandom random, double scale) {
        double radius = random.nextDouble(0.1, 1) * scale;
        double half = random.nextDouble(0.1, 1) * scale;
        int flat = random.nextInt(12);
        return Rows.cylinder(0, 0, 0, flat == 0 ? 0 : radius, flat == 1 ? 0 : half, Rows.rotation(random));
    }

    private static void nearlyParallel(LeafKind kindA, double[] a, double[] b, SplittableRandom random) {
        for (int k = 7; k <= 13; k += 3) {
            double own = kindA == LeafKind.CYLINDER ? a[k] : k == 10 ? 1 : 0;
            b[k] = own + Math.pow(10, -random.nextDouble(2, 16)) * random.nextDouble(-1, 1);
        }
    }

    // Across both axes, along one of them, across one of them, or any.
    private static void direction(
            int family, LeafKind kindA, double[] a, double[] b, SplittableRandom random, double[] out) {
        double[] p = {
            kindA == LeafKind.CYLINDER ? a[7] : 0,
            kindA == LeafKind.CYLINDER ? a[10] : 1,
            kindA == LeafKind.CYLINDER ? a[13] : 0
        };
        double[] q = {b[7], b[10], b[13]};
        double[] any = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
        double[] n = switch (family) {
            case 0 -> cross(p, q);
            case 1 -> p;
            case 2 -> q;
            case 3 -> cross(p, any);
            case 4 -> cross(q, any);
            default -> any;
        };
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++) {
            out[k] = length > 0 ? n[k] / length : any[k];
        }
    }

    private static double[] cross(double[] p, double[] q) {
        return new double[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }

    /** Puts b so that its point furthest back lies a gap along the direction beyond a's furthest. */
    private static void place(LeafKind kindA, double[] a, double[] b, double[] direction, double gap, double off) {
        a[0] += off;
        a[2] -= off;
        BigDecimal[] normal = CylinderTwin.decimals(direction);
        BigDecimal[] from = new CylinderTwin(kindA, a).furthest(normal);
        BigDecimal[] to = new CylinderTwin(LeafKind.CYLINDER, b).furthest(CylinderTwin.negate(normal));
        for (int k = 0; k < 3; k++) {
            b[k] = from[k].subtract(to[k])
                    .add(normal[k].multiply(new BigDecimal(gap)))
                    .doubleValue();
        }
    }

    /** Whether the place half-way between the two furthest points, or one a little deeper, is in both. */
    private static boolean meet(CylinderTwin p, CylinderTwin q, BigDecimal[] normal) {
        BigDecimal[] from = p.furthest(normal);
        BigDecimal[] to = q.furthest(CylinderTwin.negate(normal));
        BigDecimal[] middle = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            middle[k] = from[k].add(to[k]).divide(BigDecimal.valueOf(2));
        }
        return p.holds(middle) && q.holds(middle);
    }

    /** Axes of whole numbers, of lengths that differ: the verdict is that of exact decimals, at touch and one step off. */
    @Test
    void parallelCylindersAreExact() {
        SplittableRandom random = new SplittableRandom(102);
        double[] factors = {1, -1, 0.5, 0.75, -1.25, 1 + 0x1p-30};
        int touching = 0;
        int apart = 0;
        for (int n = 0; n < 3000; n++) {
            int[][] triples = {{3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {0, 5, 12, 13}, {0, 1, 0, 1}};
            int[] axis = triples[random.nextInt(triples.length)];
            double factor = factors[random.nextInt(factors.length)];
            double[] a = Rows.cylinder(0, 0, 0, random.nextInt(0, 4), random.nextInt(0, 4), new double[9]);
            double[] b = Rows.cylinder(0, 0, 0, random.nextInt(0, 4), random.nextInt(0, 4), new double[9]);
            for (int k = 0; k < 3; k++) {
                a[7 + 3 * k] = axis[k] / 8.0;
                b[7 + 3 * k] = factor * axis[k] / 8.0;
                a[k] = random.nextInt(-2, 3);
            }
            boolean upright = axis[3] == 1;
            LeafKind kindA = upright ? LeafKind.UPRIGHT_CYLINDER : LeafKind.CYLINDER;
            if (n % 2 == 0) { // cap on cap
                double lengths = (upright ? 1 : 1 / 8.0) * a[4] + Math.abs(factor) / 8 * b[4];
                for (int k = 0; k < 3; k++) {
                    b[k] = a[k] + lengths * axis[k];
                }
            } else { // side on side, across the axis by whole lengths
                double reach = a[3] + b[3];
                int[] aside = axis[3] == 5
                        ? new int[] {-4, 3, 0, 5}
                        : axis[3] == 3
                                ? new int[] {2, 1, -2, 3}
                                : axis[3] == 7
                                        ? new int[] {6, 2, -3, 7}
                                        : axis[3] == 13 ? new int[] {0, -12, 5, 13} : new int[] {3, 0, 4, 5};
                b[3] = aside[3] * (double) random.nextInt(1, 4);
                a[3] = aside[3] * (double) random.nextInt(0, 3);
                reach = a[3] + b[3];
                for (int k = 0; k < 3; k++) {
                    b[k] = a[k] + reach / aside[3] * aside[k] + axis[k] * 0.0625 * random.nextInt(-2, 3);
                }
            }
            int step = random.nextInt(-1, 2);
            int moved = random.nextInt(3);
            b[moved] += step * Math.ulp(b[moved]);
            boolean truth = exactlyParallel(kindA, a, b);
            touching += truth ? 1 : 0;
            apart += truth ? 0 : 1;
            String pair = kindA + " " + Arrays.toString(a) + " with " + Arrays.toString(b);
            scratch.overlap.uncertain = false;
            assertThat(SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(LeafKind.CYLINDER, b, 0), scratch.overlap))
                    .as(pair)
                    .isEqualTo(truth);
            assertThat(SpatialOverlap.test(new Leaf(LeafKind.CYLINDER, b, 0), new Leaf(kindA, a, 0), scratch.overlap))
                    .as(pair)
                    .isEqualTo(truth);
            assertThat(scratch.overlap.uncertain).as(pair).isFalse();
        }
        assertThat(touching).isGreaterThan(700);
        assertThat(apart).isGreaterThan(400);
    }

    private static boolean exactlyParallel(LeafKind kindA, double[] a, double[] b) {
        BigDecimal[] p = CylinderTwin.decimals(a[7], a[10], a[13]);
        if (kindA == LeafKind.UPRIGHT_CYLINDER) {
            p = CylinderTwin.decimals(0, 1, 0);
        }
        BigDecimal[] q = CylinderTwin.decimals(b[7], b[10], b[13]);
        BigDecimal[] w = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            w[k] = new BigDecimal(b[k]).subtract(new BigDecimal(a[k]));
        }
        BigDecimal square = Decimals.dot(p, p);
        BigDecimal heights = new BigDecimal(a[4])
                .multiply(square)
                .add(new BigDecimal(b[4]).multiply(Decimals.dot(p, q).abs()));
        BigDecimal reach = new BigDecimal(a[3]).add(new BigDecimal(b[3]));
        BigDecimal[] cross = Decimals.cross(w, p);
        return Decimals.dot(w, p).abs().compareTo(heights) <= 0
                && Decimals.dot(cross, cross).compareTo(reach.multiply(reach).multiply(square)) <= 0;
    }
}
