package robosim.geometry.narrow.gjk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.narrow.CylinderTwin;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.SupportTwin;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/**
 * Depths of cylinders and capsules against a search of all directions, with support functions of its own ({@link SupportTwin}): the
 * search is in doubles, what it found is judged in decimals.
 */
class PenetrationTest {
    private static final BigDecimal PROVEN = new BigDecimal(0x1p-34);

    private final Penetration penetration = new Penetration();

    @ParameterizedTest
    @EnumSource(names = {"CYLINDER", "CAPSULE"})
    void noDirectionIsShallowerAndTheDepthIsProven(LeafKind first) {
        SplittableRandom random = new SplittableRandom(61);
        LeafKind[] kinds = Leaves.KINDS;
        int deep = 0;
        int closed = 0;
        for (int n = 0; n < Effort.cases(1080); n++) {
            LeafKind kind = kinds[n % kinds.length];
            double[] a = Rows.random(first, random, 0.7);
            double[] b = Rows.random(kind, random, 0.7);
            String pair = Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
            double depth = penetration.spatial(new Leaf(first, a, 0), new Leaf(kind, b, 0));
            double proven = penetration.proven();
            if (depth < 1e-3) {
                continue;
            }
            deep++;
            Pair twin = new Pair(first, a, kind, b);
            BigDecimal told = twin.exactly(new double[] {penetration.nx(0), penetration.ny(0), penetration.nz(0)});
            BigDecimal least = twin.exactly(twin.shallowest(random)).min(told);
            BigDecimal share = PROVEN.multiply(twin.size());
            assertThat(new BigDecimal(proven)).as(pair).isLessThanOrEqualTo(least);
            assertThat(new BigDecimal(depth)).as(pair).isLessThanOrEqualTo(least.add(share));
            closed += told.subtract(new BigDecimal(proven)).compareTo(share) <= 0 ? 1 : 0;
            assertThat(penetration.spatial(new Leaf(kind, b, 0), new Leaf(first, a, 0)))
                    .as(pair)
                    .isEqualTo(depth);
        }
        assertThat(deep).isGreaterThan(Effort.cases(400));
        assertThat(closed).isGreaterThan(deep * 99 / 100);
    }

    @ParameterizedTest
    @EnumSource(names = {"CYLINDER", "CAPSULE"})
    void inThePlaneToo(LeafKind first) {
        SplittableRandom random = new SplittableRandom(62);
        int deep = 0;
        for (int n = 0; n < Effort.cases(720); n++) {
            LeafKind kind = Leaves.KINDS[n % Leaves.KINDS.length];
            double[] a = Rows.random(first, random, 0.7);
            double[] b = Rows.random(kind, random, 0.7);
            String pair = Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
            double depth = penetration.planar(new Leaf(first, a, 0), new Leaf(kind, b, 0));
            if (depth < 1e-3) {
                continue;
            }
            deep++;
            Pair twin = new Pair(first, a, kind, b);
            double[] best = {1, 0, 0};
            for (int k = 1; k < 4096; k++) {
                double t = k * Math.PI / 2048;
                double[] way = {StrictMath.cos(t), 0, StrictMath.sin(t)};
                best = twin.depth(way) < twin.depth(best) ? way : best;
            }
            double sampled = twin.exactly(best).doubleValue();
            assertThat(penetration.proven()).as(pair).isBetween(depth - 1e-9, sampled);
            assertThat(depth).as(pair).isBetween(sampled - 1e-2, sampled + 1e-12);
        }
        assertThat(deep).isGreaterThan(Effort.cases(200));
    }

    /** A pattern alone takes some 900 to 1,000 tries. */
    @ParameterizedTest
    @CsvSource({"CYLINDER, CYLINDER, 150", "CYLINDER, BOX, 280", "CAPSULE, CYLINDER, 150"})
    void searchesAreShort(LeafKind first, LeafKind second, int most) {
        SplittableRandom random = new SplittableRandom(64);
        long tries = 0;
        int deep = 0;
        for (int n = 0; n < 400; n++) {
            double[] a = Rows.random(first, random, 0.7);
            double[] b = Rows.random(second, random, 0.7);
            if (penetration.spatial(new Leaf(first, a, 0), new Leaf(second, b, 0)) > 0) {
                deep++;
                tries += penetration.tries();
            }
        }
        assertThat(deep).isGreaterThan(150);
        assertThat(tries / deep).isBetween(20L, (long) most);
    }

    /** Of two rings of directions that nearly tie the depth told is still no more than the least. */
    @Test
    void nearlyParallelCylindersAreNotTooDeep() {
        SplittableRandom random = new SplittableRandom(63);
        int open = 0;
        for (int n = 0; n < 300; n++) {
            double[] a = Rows.random(LeafKind.CYLINDER, random, 0.3);
            double[] b = Rows.random(LeafKind.CYLINDER, random, 0.3);
            for (int k = 0; k < 9; k++) {
                b[6 + k] = a[6 + k] + random.nextDouble(-1, 1) * Math.pow(10, -random.nextDouble(6, 20));
            }
            if (n % 2 == 0) {
                for (int k = 0; k < 3; k++) {
                    b[k] = a[k] + 0.1 * a[7 + 3 * k]; // on one line, so that all ways across tie
                }
            }
            String pair = Arrays.toString(a) + " with " + Arrays.toString(b);
            double depth = penetration.spatial(new Leaf(LeafKind.CYLINDER, a, 0), new Leaf(LeafKind.CYLINDER, b, 0));
            double proven = penetration.proven();
            Pair twin = new Pair(LeafKind.CYLINDER, a, LeafKind.CYLINDER, b);
            BigDecimal least = twin.exactly(twin.shallowest(random));
            for (int k = 0; k < 4; k++) {
                double[] axis = k < 2 ? a : b;
                double side = k % 2 == 0 ? 1 : -1;
                least = least.min(twin.exactly(new double[] {side * axis[7], side * axis[10], side * axis[13]}));
            }
            assertThat(new BigDecimal(proven)).as(pair).isLessThanOrEqualTo(least);
            assertThat(new BigDecimal(depth))
                    .as(pair)
                    .isBetween(least.subtract(new BigDecimal("0.005")), least.add(PROVEN.multiply(twin.size())));
            open += depth < least.doubleValue() - 1e-6 ? 1 : 0;
        }
        assertThat(open).isLessThan(300 / 2);
    }

    /** Depths that are known without any search, in both orders. */
    @Test
    void depthsByHand() {
        double[] lying = {0, -1, 0, 1, 0, 0, 0, 0, 1}; // its own Y along the world's X
        double[] upright = Rows.cylinder(0, 0, 0, 1, 5, Rows.identity());
        // Axes that cross at right angles, half a unit apart.
        known(1.5, upright, LeafKind.CYLINDER, Rows.cylinder(0, 0, 0.5, 1, 5, lying));
        // An end 1 beyond the other's side; the same one's end above the other's.
        known(1, upright, LeafKind.CYLINDER, Rows.cylinder(5, 0, 0, 1, 5, lying));
        known(0.25, upright, LeafKind.CYLINDER, Rows.cylinder(0.5, 5.75, 0, 1, 5, lying));
        // A ball in the side, in the cap, and 3, 4, 5 beside the rim.
        known(0.75, upright, LeafKind.SPHERE, Rows.sphere(0.75, 0, 0, 0.5));
        known(0.125, upright, LeafKind.SPHERE, Rows.sphere(0, 5.375, 0, 0.5));
        known(0.75, upright, LeafKind.SPHERE, Rows.sphere(1.75, 6, 0, 2));
        // A box in the side, and a corner of a box on edge in the cap.
        known(0.5, upright, LeafKind.BOX, Rows.box(1.5, 0, 0, 1, 1, 1, Rows.identity()));
        known(0.25, upright, LeafKind.BOX, Rows.box(0, 6.75, 0, 1, 2, 1, Rows.identity()));
        // A triangle 0.375 in the cap.
        known(0.375, upright, LeafKind.TRIANGLE, Rows.triangle(0, 4.625, 0, 0.25, 8, 0, 0, 8, 0.25));
    }

    /** The same of a capsule: by its side, by its end, and where the segment itself is deep inside. */
    @Test
    void depthsOfCapsulesByHand() {
        double[] lying = {0, -1, 0, 1, 0, 0, 0, 0, 1};
        double[] upright = Rows.cylinder(0, 0, 0, 1, 5, Rows.identity());
        LeafKind capsule = LeafKind.CAPSULE;
        known(1.5, capsule, upright, capsule, Rows.cylinder(0, 0, 0.5, 1, 5, lying));
        // End on end, 3, 4, 5 apart.
        known(0.5, capsule, upright, capsule, Rows.cylinder(3, 14, 0, 4.5, 5, Rows.identity()));
        known(0.75, capsule, upright, LeafKind.SPHERE, Rows.sphere(0.75, 0, 0, 0.5));
        known(0.25, capsule, upright, LeafKind.SPHERE, Rows.sphere(0, 6.25, 0, 0.5));
        known(0.5, capsule, upright, LeafKind.BOX, Rows.box(1.5, 0, 0, 1, 1, 1, Rows.identity()));
        known(0.25, capsule, upright, LeafKind.BOX, Rows.box(0, 7.75, 0, 1, 2, 1, Rows.identity()));
        // All of it inside, nearest to a side of the box at x = 3.
        known(4, capsule, upright, LeafKind.BOX, Rows.box(0, 0, 0, 3, 20, 9, Rows.identity()));
        known(0.5, capsule, upright, LeafKind.CYLINDER, Rows.cylinder(0, 7.5, 0, 2, 2, Rows.identity()));
    }

    private void known(double depth, double[] a, LeafKind kind, double[] b) {
        known(depth, LeafKind.CYLINDER, a, kind, b);
    }

    private void known(double depth, LeafKind first, double[] a, LeafKind kind, double[] b) {
        String pair = first + " " + Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
        assertThat(penetration.spatial(new Leaf(first, a, 0), new Leaf(kind, b, 0)))
                .as(pair)
                .isCloseTo(depth, within(1e-9));
        assertThat(penetration.spatial(new Leaf(kind, b, 0), new Leaf(first, a, 0)))
                .as(pair)
                .isCloseTo(depth, within(1e-9));
    }

    /** Two leaves, and how far the first has to go along a direction until it is out. */
    private static final class Pair {
        private final Reach a;
        private final Reach b;

        Pair(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
            this.a = new Reach(kindA, a);
            this.b = new Reach(kindB, b);
        }

        /** In decimals, along a direction of any length. */
        BigDecimal exactly(double[] way) {
            return a.twin.gap(b.twin, CylinderTwin.decimals(way)).negate();
        }

        /** To rounding, along a unit direction. */
        double depth(double[] n) {
            return a.along(-n[0], -n[1], -n[2]) + b.along(n[0], n[1], n[2]);
        }

        /** The half sizes of both along the world's axes, and the magnitudes of the offset of their middles. */
        BigDecimal size() {
            double size = 0;
            for (int k = 0; k < 3; k++) {
                double x = k == 0 ? 1 : 0;
                double y = k == 1 ? 1 : 0;
                double z = k == 2 ? 1 : 0;
                double mostA = a.along(x, y, z);
                double mostB = b.along(x, y, z);
                double leastA = -a.along(-x, -y, -z);
                double leastB = -b.along(-x, -y, -z);
                size += (mostA - leastA + mostB - leastB + Math.abs(mostA + leastA - mostB - leastB)) / 2;
            }
            return new BigDecimal(size);
        }

        /** The shallowest of many random directions, the best of which are drawn closer. */
        double[] shallowest(SplittableRandom random) {
            double[][] best = new double[12][];
            double[] depths = new double[best.length];
            Arrays.fill(depths, Double.POSITIVE_INFINITY);
            for (int n = 0; n < 3000; n++) {
                double[] way = unit(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
                double depth = depth(way);
                int worst = 0;
                for (int k = 1; k < best.length; k++) {
                    worst = depths[k] > depths[worst] ? k : worst;
                }
                if (depth < depths[worst]) {
                    depths[worst] = depth;
                    best[worst] = way;
                }
            }
            double[] shallowest = best[0];
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k < best.length; k++) {
                double[] at = best[k];
                double depth = depths[k];
                for (double step = 0.05; step > 1e-9; step *= 0.8) {
                    for (int n = 0; n < 6; n++) {
                        double[] way = unit(
                                at[0] + random.nextDouble(-step, step),
                                at[1] + random.nextDouble(-step, step),
                                at[2] + random.nextDouble(-step, step));
                        double there = depth(way);
                        if (there < depth) {
                            depth = there;
                            at = way;
                        }
                    }
                }
                if (depth < least) {
                    least = depth;
                    shallowest = at;
                }
            }
            return shallowest;
        }
    }

    /** The support function, from the definition of each leaf; an octagon's corners are those found in decimals. */
    private static final class Reach {
        final SupportTwin twin;
        private final LeafKind kind;
        private final double[] r;
        private final double[][] corners;

        Reach(LeafKind kind, double[] row) {
            this.kind = kind;
            this.r = row;
            this.twin = new SupportTwin(kind, row);
            this.corners = kind == LeafKind.TRIANGLE
                    ? new double[][] {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}}
                    : twin.octagonCorners();
        }

        double along(double x, double y, double z) {
            if (corners.length > 0) {
                double most = Double.NEGATIVE_INFINITY;
                for (double[] p : corners) {
                    most = Math.max(most, x * p[0] + y * p[1] + z * p[2]);
                }
                return most;
            }
            double middle = x * r[0] + y * r[1] + z * r[2];
            if (kind == LeafKind.SPHERE) {
                return middle + r[3] * Math.sqrt(x * x + y * y + z * z);
            }
            if (kind.isCapsule()) {
                boolean isTurned = kind == LeafKind.CAPSULE;
                double along = isTurned ? x * r[7] + y * r[10] + z * r[13] : y;
                return middle + r[4] * Math.abs(along) + r[3] * Math.sqrt(x * x + y * y + z * z);
            }
            if (kind == LeafKind.CYLINDER || kind == LeafKind.UPRIGHT_CYLINDER) {
                double ax = kind == LeafKind.CYLINDER ? r[7] : 0;
                double ay = kind == LeafKind.CYLINDER ? r[10] : 1;
                double az = kind == LeafKind.CYLINDER ? r[13] : 0;
                double along = x * ax + y * ay + z * az;
                double length = Math.sqrt(ax * ax + ay * ay + az * az);
                double cx = y * az - z * ay;
                double cy = z * ax - x * az;
                double cz = x * ay - y * ax;
                return middle + r[4] * Math.abs(along) + r[3] * Math.sqrt(cx * cx + cy * cy + cz * cz) / length;
            }
            for (int k = 0; k < 3; k++) {
                middle += r[3 + k] * Math.abs(x * r[6 + k] + y * r[9 + k] + z * r[12 + k]);
            }
            return middle;
        }
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }
}
