package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Turns in the plane, against sampled poses: no contact before the answer, and contact right after it. */
class PlanarTurnSweepTest {
    private static final int[] KINDS = {
        Leaf.UPRIGHT_BOX, Leaf.UPRIGHT_CYLINDER, Leaf.SPHERE, Leaf.BOX, Leaf.TRIANGLE, Leaf.PRISM
    };

    private final Scratch scratch = new Scratch();
    private final SplittableRandom random = new SplittableRandom(20052);
    private int contacts;
    private int hits;
    private int misses;
    private int blocked;

    @Test
    void isFreeUpToContactAndNoFurther() {
        int count = 0;
        for (int k = 0; k < 15; k++) {
            for (int kindA : KINDS) {
                for (int kindB : KINDS) {
                    double[] a = SweepRows.random(kindA, 1.6, random);
                    double[] b = SweepRows.random(kindB, 1.6, random);
                    double px = k % 3 == 0 ? centre(kindA, a, 0) : random.nextDouble(-2, 2);
                    double pz = k % 3 == 0 ? centre(kindA, a, 2) : random.nextDouble(-2, 2);
                    check(kindA, a, px, pz, random.nextDouble(-400, 400), kindB, b);
                    count++;
                }
            }
        }
        assertThat(hits).isGreaterThan(count / 10);
        assertThat(misses).isGreaterThan(count / 10);
        assertThat(contacts).isGreaterThan(count / 10);
        assertThat(blocked).isGreaterThan(count / 20);
    }

    private static double centre(int kind, double[] row, int axis) {
        return kind == Leaf.PRISM ? 0.5 * (row[axis] + row[axis + 1]) : row[axis];
    }

    private void check(int kindA, double[] a, double px, double pz, double degrees, int kindB, double[] b) {
        String what = "kind %d %s about (%s, %s) by %s, kind %d %s"
                .formatted(kindA, Arrays.toString(a), px, pz, degrees, kindB, Arrays.toString(b));
        double share = PlanarTurnSweep.free(kindA, a, 0, px, 0, pz, 0, 1, 0, degrees, kindB, b, 0, scratch);
        FlatPair pair = new FlatPair(kindA, a, px, pz, kindB, b);
        double start = pair.gap(0);
        double limit = Math.min(start, 0);
        double end = Math.min(1, share);
        for (int k = 0; k <= 100; k++) {
            double gap = pair.gap(degrees * end * k / 100);
            assertThat(gap).as(what).isGreaterThan(limit - 1e-13);
        }
        if (share <= 1) {
            assertThat(share).as(what).isLessThan(1);
            // Contact, or the depth of the start, comes at once.
            assertThat(pair.gap(degrees * share)).as(what).isLessThan(limit + 1e-12);
            blocked += share == 0 ? 1 : 0;
        }
        contacts += start <= 0 ? 1 : 0;
        hits += start > 0 && share <= 1 ? 1 : 0;
        misses += start > 0 && share > 1 ? 1 : 0;
    }
}
