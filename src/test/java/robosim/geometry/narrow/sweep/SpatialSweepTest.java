package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.leaf.PivotTurn;

/** Motions of all pairs of kinds in space, against poses sampled on the way and judged by GJK. */
class SpatialSweepTest {
    private static final int SAMPLES = 60;

    private final Scratch scratch = new Scratch();
    private final Gjk gjk = new Gjk();
    private final Penetration penetration = new Penetration();
    private final SplittableRandom random = new SplittableRandom(20053);
    private int contacts;
    private int blocked;
    private int hits;
    private int misses;

    @Test
    void aTranslationIsFreeUpToContactAndNoFurther() {
        for (int k = 0; k < 12; k++) {
            for (LeafKind kindA : Leaves.KINDS) {
                for (LeafKind kindB : Leaves.KINDS) {
                    double[] a = SweepRows.random(kindA, 1.4, random);
                    double[] b = SweepRows.random(kindB, 1.4, random);
                    double level = k % 3 == 0 ? 0 : 1;
                    translate(
                            kindA,
                            a,
                            random.nextDouble(-3, 3),
                            level * random.nextDouble(-3, 3),
                            random.nextDouble(-3, 3),
                            kindB,
                            b);
                }
            }
        }
        assertMix(12 * 81);
    }

    @Test
    void aTurnIsFreeUpToContactAndNoFurther() {
        for (int k = 0; k < 12; k++) {
            for (LeafKind kindA : Leaves.KINDS) {
                for (LeafKind kindB : Leaves.KINDS) {
                    if (kindA == LeafKind.PRISM || kindB == LeafKind.PRISM) {
                        continue; // an enclosure, which becomes another one where it turns
                    }
                    double[] a = SweepRows.random(kindA, 1.5, random);
                    double[] b = SweepRows.random(kindB, 1.5, random);
                    double[] pivot = {a[0], a[1], a[2]};
                    if (k % 2 == 0) {
                        pivot = new double[] {
                            random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)
                        };
                    }
                    turn(kindA, a, pivot, axis(k), random.nextDouble(-400, 400), kindB, b);
                }
            }
        }
        assertMix(12 * 64);
    }

    @Test
    void whatCameToContactGoesNoFurther() {
        int stopped = 0;
        int headOn = 0;
        double[] pose = new double[Leaf.STRIDE];
        for (int k = 0; k < 4000; k++) {
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            double[] a = SweepRows.random(kindA, 3, random);
            double[] b = SweepRows.random(kindB, 0.3, random);
            if (k % 4 == 0) { // side by side and upright, or hardly leaning
                kindA = LeafKind.CYLINDER;
                kindB = LeafKind.CYLINDER;
                a = SweepRows.cylinder(a[0], 0.1 * a[1], a[2], 0.2, 0.7, 0, (k % 8) * 1e-4, 0);
                b = SweepRows.cylinder(b[0], b[1], b[2], 0.5, 0.9, 0, 0, 0);
            }
            double dx = -a[0] + random.nextDouble(-1, 1);
            double dy = (-a[1] + random.nextDouble(-1, 1)) * (k % 4 == 0 ? 0.01 : 1);
            double dz = -a[2] + random.nextDouble(-1, 1);
            double time =
                    SpatialSweep.translation(new Leaf(kindA, a, 0), dx, dy, dz, new Leaf(kindB, b, 0), scratch.sweep);
            if (time == 0 || time > 1) {
                continue;
            }
            MovedLeaf.moved(new Leaf(kindA, a, 0), time * dx, time * dy, time * dz, new Leaf(LeafKind.SPHERE, pose, 0));
            double more = SpatialSweep.translation(
                    new Leaf(kindA, pose, 0), dx, dy, dz, new Leaf(kindB, b, 0), scratch.sweep);
            String what = "kind %s %s by (%s, %s, %s), kind %s %s"
                    .formatted(kindA, Arrays.toString(a), dx, dy, dz, kindB, Arrays.toString(b));
            assertThat(more).as(what).isLessThan(1e-9);
            stopped++;
            // The same a little deeper, where it did not arrive grazing.
            double before = time - 1e-6;
            MovedLeaf.moved(
                    new Leaf(kindA, a, 0), before * dx, before * dy, before * dz, new Leaf(LeafKind.SPHERE, pose, 0));
            gjk.spatial(new Leaf(kindA, pose, 0), new Leaf(kindB, b, 0));
            double closing = -(gjk.nx() * dx + gjk.ny() * dy + gjk.nz() * dz);
            if (gjk.lower() > 0 && closing > 0.1 * Math.sqrt(dx * dx + dy * dy + dz * dz)) {
                double after = time + 1e-6;
                MovedLeaf.moved(
                        new Leaf(kindA, a, 0), after * dx, after * dy, after * dz, new Leaf(LeafKind.SPHERE, pose, 0));
                assertThat(SpatialSweep.translation(
                                new Leaf(kindA, pose, 0), dx, dy, dz, new Leaf(kindB, b, 0), scratch.sweep))
                        .as(what)
                        .isZero();
                assertThat(SpatialSweep.translation(
                                new Leaf(kindA, pose, 0), -dx, -dy, -dz, new Leaf(kindB, b, 0), scratch.sweep))
                        .as(what)
                        .isInfinite();
                headOn++;
            }
        }
        assertThat(stopped).isGreaterThan(1000);
        assertThat(headOn).isGreaterThan(500);
    }

    private double[] axis(int k) {
        if (k % 3 == 0) {
            return new double[] {0, k % 2 == 0 ? 1 : -1, 0};
        }
        double[] row = SweepRows.random(LeafKind.BOX, 1, random);
        return new double[] {row[6], row[9], row[12]};
    }

    private void assertMix(int count) {
        assertThat(hits + misses + contacts).isEqualTo(count);
        assertThat(hits).isGreaterThan(count / 12);
        assertThat(misses).isGreaterThan(count / 10);
        assertThat(contacts).isGreaterThan(count / 20);
        assertThat(blocked).isGreaterThan(count / 50);
    }

    private void translate(LeafKind kindA, double[] a, double dx, double dy, double dz, LeafKind kindB, double[] b) {
        String what = "kind %s %s by (%s, %s, %s), kind %s %s"
                .formatted(kindA, Arrays.toString(a), dx, dy, dz, kindB, Arrays.toString(b));
        double time = SpatialSweep.translation(new Leaf(kindA, a, 0), dx, dy, dz, new Leaf(kindB, b, 0), scratch.sweep);
        double[] pose = new double[Leaf.STRIDE];
        double start = gap(kindA, a, kindB, b);
        double end = Math.min(1, time);
        if (start < 0) {
            MovedLeaf.moved(new Leaf(kindA, a, 0), 1e-6 * dx, 1e-6 * dy, 1e-6 * dz, new Leaf(LeafKind.SPHERE, pose, 0));
            double change = gap(kindA, pose, kindB, b) - start;
            contacts++;
            blocked += time == 0 ? 1 : 0;
            assertThat(time).as(what).isIn(0.0, Double.POSITIVE_INFINITY);
            // One way or the other to first order; within a hair of neither, either.
            if (Math.abs(change) > (isCylinder(kindA) || isCylinder(kindB) ? 1e-2 : 1e-10)) {
                assertThat(time).as(what).isEqualTo(change < 0 ? 0 : Double.POSITIVE_INFINITY);
            }
            return;
        }
        for (int k = 0; k <= SAMPLES; k++) {
            double t = end * (k == SAMPLES ? 1 - 1e-9 : (double) k / SAMPLES);
            MovedLeaf.moved(new Leaf(kindA, a, 0), t * dx, t * dy, t * dz, new Leaf(LeafKind.SPHERE, pose, 0));
            gjk.spatial(new Leaf(kindA, pose, 0), new Leaf(kindB, b, 0));
            assertThat(gjk.overlapping()).as(what).isFalse();
        }
        if (time <= 1) {
            assertThat(time).as(what).isNotNegative();
            MovedLeaf.moved(new Leaf(kindA, a, 0), time * dx, time * dy, time * dz, new Leaf(LeafKind.SPHERE, pose, 0));
            gjk.spatial(new Leaf(kindA, pose, 0), new Leaf(kindB, b, 0));
            assertThat(gjk.upper()).as(what).isLessThan(1e-10);
        } else {
            assertThat(time).as(what).isInfinite();
        }
        hits += time <= 1 ? 1 : 0;
        misses += time <= 1 ? 0 : 1;
    }

    private void turn(
            LeafKind kindA, double[] a, double[] pivot, double[] axis, double degrees, LeafKind kindB, double[] b) {
        String what = "kind %s %s about %s through %s by %s, kind %s %s"
                .formatted(
                        kindA,
                        Arrays.toString(a),
                        Arrays.toString(axis),
                        Arrays.toString(pivot),
                        degrees,
                        kindB,
                        Arrays.toString(b));
        double share = SpatialSweep.turn(
                new Leaf(kindA, a, 0),
                new PivotTurn().about(pivot[0], pivot[1], pivot[2]).by(axis[0], axis[1], axis[2], degrees),
                new Leaf(kindB, b, 0),
                scratch.sweep);
        double start = gap(kindA, a, kindB, b);
        double limit = Math.min(0, start);
        double end = Math.min(1, share);
        double[] pose = new double[Leaf.STRIDE];
        LeafKind kind = MovedLeaf.turnedKind(kindA);
        // Depths that a rim has a part in are found by a search that may stop in a valley of its own.
        boolean rim = isCylinder(kindA) || isCylinder(kindB);
        double slack = rim && start < 0 ? 5e-3 : 1e-10;
        for (int k = 0; k <= SAMPLES; k++) {
            turned(kindA, a, pivot, axis, degrees * end * k / SAMPLES, pose);
            double gap = gap(kind, pose, kindB, b);
            assertThat(gap).as(what).isGreaterThan(limit - slack);
        }
        if (share <= 1) {
            assertThat(share).as(what).isLessThan(1);
            assertThat(gap(kind, pose, kindB, b)).as(what).isLessThan(limit + 100 * slack);
            blocked += share == 0 ? 1 : 0;
        }
        contacts += start < 0 ? 1 : 0;
        hits += start >= 0 && share <= 1 ? 1 : 0;
        misses += start >= 0 && share > 1 ? 1 : 0;
    }

    private static void turned(
            LeafKind kind, double[] a, double[] pivot, double[] axis, double degrees, double[] pose) {
        double cos = StrictMath.cos(Math.toRadians(degrees));
        double sin = StrictMath.sin(Math.toRadians(degrees));
        MovedLeaf.turned(
                new Leaf(kind, a, 0),
                new PivotTurn().about(pivot[0], pivot[1], pivot[2]).by(axis[0], axis[1], axis[2], 0),
                cos,
                sin,
                new Leaf(LeafKind.SPHERE, pose, 0));
    }

    private static boolean isCylinder(LeafKind kind) {
        return kind == LeafKind.CYLINDER || kind == LeafKind.UPRIGHT_CYLINDER;
    }

    private double gap(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
        return gjk.lower() > 0 ? gjk.upper() : -penetration.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
    }
}
