package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Depths of cylinders against a search of all directions that shares nothing with the kernel. */
class PenetrationTest {
    private final Penetration penetration = new Penetration();

    @Test
    void noDirectionIsShallowerAndTheDepthIsProven() {
        SplittableRandom random = new SplittableRandom(61);
        int[] kinds = {
            Leaf.UPRIGHT_BOX, Leaf.UPRIGHT_CYLINDER, Leaf.SPHERE, Leaf.BOX, Leaf.CYLINDER, Leaf.TRIANGLE, Leaf.PRISM
        };
        int deep = 0;
        int closed = 0;
        for (int n = 0; n < 1400; n++) {
            int kind = kinds[n % kinds.length];
            double[] a = Rows.random(Leaf.CYLINDER, random, 0.7);
            double[] b = Rows.random(kind, random, 0.7);
            String pair = Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
            double depth = penetration.spatial(Leaf.CYLINDER, a, 0, kind, b, 0);
            double proven = penetration.proven();
            if (depth < 1e-3) {
                continue;
            }
            deep++;
            double size = size(Leaf.CYLINDER, a, kind, b);
            double[] way = {penetration.nx(0), penetration.ny(0), penetration.nz(0)};
            double told = depth(Leaf.CYLINDER, a, kind, b, way);
            double sampled = least(Leaf.CYLINDER, a, kind, b, random);
            assertThat(proven).as(pair).isLessThanOrEqualTo(Math.min(told, sampled));
            assertThat(depth).as(pair).isLessThanOrEqualTo(Math.min(told, sampled) + 0x1p-34 * size);
            closed += told - proven <= 0x1p-34 * size ? 1 : 0;
            assertThat(penetration.spatial(kind, b, 0, Leaf.CYLINDER, a, 0))
                    .as(pair)
                    .isEqualTo(depth);
        }
        assertThat(deep).isGreaterThan(500);
        assertThat(closed).isGreaterThan(deep * 99 / 100);
    }

    @Test
    void inThePlaneToo() {
        SplittableRandom random = new SplittableRandom(62);
        int deep = 0;
        for (int n = 0; n < 700; n++) {
            int kind = n % 7;
            double[] a = Rows.random(Leaf.CYLINDER, random, 0.7);
            double[] b = Rows.random(kind, random, 0.7);
            String pair = Arrays.toString(a) + " with " + kind + " " + Arrays.toString(b);
            double depth = penetration.planar(Leaf.CYLINDER, a, 0, kind, b, 0);
            if (depth < 1e-3) {
                continue;
            }
            deep++;
            double sampled = Double.POSITIVE_INFINITY;
            for (int k = 0; k < 4096; k++) {
                double t = k * Math.PI / 2048;
                sampled =
                        Math.min(sampled, depth(Leaf.CYLINDER, a, kind, b, new double[] {Math.cos(t), 0, Math.sin(t)}));
            }
            assertThat(penetration.proven()).as(pair).isBetween(depth - 1e-9, sampled);
            assertThat(depth).as(pair).isBetween(sampled - 1e-2, sampled + 1e-12);
        }
        assertThat(deep).isGreaterThan(200);
    }

    /** Of two rings of directions that nearly tie the depth told is still no more than the least. */
    @Test
    void nearlyParallelCylindersAreNotTooDeep() {
        SplittableRandom random = new SplittableRandom(63);
        int open = 0;
        for (int n = 0; n < 300; n++) {
            double[] a = Rows.random(Leaf.CYLINDER, random, 0.3);
            double[] b = Rows.random(Leaf.CYLINDER, random, 0.3);
            for (int k = 0; k < 9; k++) {
                b[6 + k] = a[6 + k] + random.nextDouble(-1, 1) * Math.pow(10, -random.nextDouble(6, 20));
            }
            if (n % 2 == 0) {
                for (int k = 0; k < 3; k++) {
                    b[k] = a[k] + 0.1 * a[7 + 3 * k]; // on one line, so that all ways across tie
                }
            }
            String pair = Arrays.toString(a) + " with " + Arrays.toString(b);
            double depth = penetration.spatial(Leaf.CYLINDER, a, 0, Leaf.CYLINDER, b, 0);
            double proven = penetration.proven();
            double sampled = least(Leaf.CYLINDER, a, Leaf.CYLINDER, b, random);
            for (int k = 0; k < 4; k++) {
                double[] axis = k < 2 ? a : b;
                double side = k % 2 == 0 ? 1 : -1;
                double[] way = unit(side * axis[7], side * axis[10], side * axis[13]);
                sampled = Math.min(sampled, depth(Leaf.CYLINDER, a, Leaf.CYLINDER, b, way));
            }
            double size = size(Leaf.CYLINDER, a, Leaf.CYLINDER, b);
            assertThat(proven).as(pair).isLessThanOrEqualTo(sampled);
            assertThat(depth).as(pair).isBetween(sampled - 5e-3, sampled + 0x1p-34 * size);
            open += depth < sampled - 1e-6 ? 1 : 0;
        }
        assertThat(open).isLessThan(300 / 2);
    }

    private static double size(int kindA, double[] a, int kindB, double[] b) {
        Support p = new Support();
        Support q = new Support();
        load(kindA, a, kindB, b, p, q);
        return p.extent + q.extent;
    }

    private static void load(int kindA, double[] a, int kindB, double[] b, Support p, Support q) {
        double ox = Support.originX(kindA, a, 0);
        double oy = Support.originY(kindA, a, 0);
        double oz = Support.originZ(kindA, a, 0);
        p.spatial(kindA, a, 0, ox, oy, oz, 1);
        q.spatial(kindB, b, 0, ox, oy, oz, 1);
    }

    /** How far a has to go along a unit direction until it is out. */
    private static double depth(int kindA, double[] a, int kindB, double[] b, double[] n) {
        return reach(kindA, a, -n[0], -n[1], -n[2]) + reach(kindB, b, n[0], n[1], n[2]);
    }

    /** The support function, from the definition of each leaf. */
    private static double reach(int kind, double[] r, double x, double y, double z) {
        switch (kind) {
            case Leaf.TRIANGLE -> {
                double most = Double.NEGATIVE_INFINITY;
                for (int k = 0; k < 9; k += 3) {
                    most = Math.max(most, x * r[k] + y * r[k + 1] + z * r[k + 2]);
                }
                return most;
            }
            case Leaf.PRISM -> {
                double most = Double.NEGATIVE_INFINITY;
                double[] px = new double[8];
                double[] pz = new double[8];
                PrismCorners.load(r, 0, 0, 0, px, pz);
                for (int k = 0; k < 8; k++) {
                    most = Math.max(most, x * px[k] + z * pz[k] + Math.max(y * r[8], y * r[9]));
                }
                return most;
            }
            default -> {}
        }
        double middle = x * r[0] + y * r[1] + z * r[2];
        if (kind == Leaf.SPHERE) {
            return middle + r[3] * Math.sqrt(x * x + y * y + z * z);
        }
        if (kind == Leaf.CYLINDER || kind == Leaf.UPRIGHT_CYLINDER) {
            double ax = kind == Leaf.CYLINDER ? r[7] : 0;
            double ay = kind == Leaf.CYLINDER ? r[10] : 1;
            double az = kind == Leaf.CYLINDER ? r[13] : 0;
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

    /** The least depth of many random directions, the best of which are drawn closer. */
    private static double least(int kindA, double[] a, int kindB, double[] b, SplittableRandom random) {
        double[][] best = new double[12][];
        double[] depths = new double[best.length];
        Arrays.fill(depths, Double.POSITIVE_INFINITY);
        for (int n = 0; n < 3000; n++) {
            double[] way = unit(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            double depth = depth(kindA, a, kindB, b, way);
            int worst = 0;
            for (int k = 1; k < best.length; k++) {
                worst = depths[k] > depths[worst] ? k : worst;
            }
            if (depth < depths[worst]) {
                depths[worst] = depth;
                best[worst] = way;
            }
        }
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
                    double there = depth(kindA, a, kindB, b, way);
                    if (there < depth) {
                        depth = there;
                        at = way;
                    }
                }
            }
            least = Math.min(least, depth);
        }
        return least;
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }
}
