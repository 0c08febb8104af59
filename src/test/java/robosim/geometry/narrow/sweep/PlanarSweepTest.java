package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.FlatTwin;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

class PlanarSweepTest {
    private static final LeafKind[] KINDS = {
        LeafKind.UPRIGHT_BOX, LeafKind.UPRIGHT_CYLINDER, LeafKind.SPHERE, LeafKind.BOX, LeafKind.TRIANGLE
    };

    private final Scratch scratch = new Scratch();
    private final SplittableRandom random = new SplittableRandom(20051);
    private int contacts;
    private int blocked;
    private int hits;
    private int misses;

    @Test
    void agreesWithTheExactTwinAtRandom() {
        for (int k = 0; k < 18; k++) {
            for (LeafKind kindA : KINDS) {
                for (LeafKind kindB : KINDS) {
                    double[] a = SweepRows.random(kindA, 2, random);
                    double[] b = SweepRows.random(kindB, 2, random);
                    check(kindA, a, random.nextDouble(-4, 4), random.nextDouble(-4, 4), kindB, b);
                }
            }
        }
        assertMix(450);
    }

    @Test
    void agreesWithTheExactTwinOnAGridFullOfTies() {
        for (int k = 0; k < 18; k++) {
            for (LeafKind kindA : KINDS) {
                for (LeafKind kindB : KINDS) {
                    double[] a = SweepRows.onGrid(kindA, 3, random);
                    double[] b = SweepRows.onGrid(kindB, 3, random);
                    check(kindA, a, random.nextInt(-5, 6), random.nextInt(-5, 6), kindB, b);
                }
            }
        }
        assertMix(450);
        assertThat(blocked).isGreaterThan(10);
    }

    /** Of the many directions of least depth at a corner, the one along the disc is free. */
    @Test
    void aCornerLeavesTheEndOfADiscSeenEdgeOn() {
        double[] triangle = {-1, 1, 0, -2, 0.75, -1.25, 0.25, -0.5, 1.5, 0, 0, 0, 0, 0, 0, 0};
        double[] disc = {-2.75, -2, -1.25, 0.75, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0
        }; // from x = -3.5 to -2, at z = -1.25
        for (double[] free : new double[][] {{-1.25, 0.5}, {-1, 0}, {1, 0}, {0, 1}, {1, -1}, {4, -4.5}}) {
            double time = PlanarSweep.translation(
                    new Leaf(LeafKind.TRIANGLE, triangle, 0),
                    free[0],
                    0,
                    free[1],
                    new Leaf(LeafKind.CYLINDER, disc, 0),
                    scratch.sweep);
            assertThat(time).as(Arrays.toString(free)).isInfinite();
        }
        for (double[] into : new double[][] {{-1, -0.1}, {-2, -1}}) {
            double time = PlanarSweep.translation(
                    new Leaf(LeafKind.TRIANGLE, triangle, 0),
                    into[0],
                    0,
                    into[1],
                    new Leaf(LeafKind.CYLINDER, disc, 0),
                    scratch.sweep);
            assertThat(time).as(Arrays.toString(into)).isZero();
        }
    }

    private void assertMix(int count) {
        assertThat(hits + misses + contacts).isEqualTo(count);
        assertThat(hits).isGreaterThan(count / 10);
        assertThat(misses).isGreaterThan(count / 10);
        assertThat(contacts).isGreaterThan(count / 10);
    }

    private void check(LeafKind kindA, double[] a, double dx, double dz, LeafKind kindB, double[] b) {
        String what = "kind %s %s by (%s, %s), kind %s %s"
                .formatted(kindA, Arrays.toString(a), dx, dz, kindB, Arrays.toString(b));
        double time = PlanarSweep.translation(new Leaf(kindA, a, 0), dx, 17, dz, new Leaf(kindB, b, 0), scratch.sweep);
        FlatTwin twin = new FlatTwin(kindA, a, dx, dz, kindB, b);
        if (twin.touchesAtStart()) {
            contacts++;
            boolean deeper = twin.goesDeeper();
            blocked += deeper ? 1 : 0;
            assertThat(time).as(what).isEqualTo(deeper ? 0 : Double.POSITIVE_INFINITY);
        } else if (twin.meetsBy(1)) {
            hits++;
            assertThat(time).as(what).isBetween(0.0, 1.0);
            // Rounded down, and to nothing but the next double: not yet there any earlier, there by the next one.
            BigDecimal justBefore = new BigDecimal(time).multiply(BigDecimal.ONE.subtract(new BigDecimal(0x1p-200)));
            assertThat(twin.meetsBy(justBefore)).as(what).isFalse();
            assertThat(twin.meetsBy(Math.nextUp(time))).as(what).isTrue();
        } else {
            misses++;
            assertThat(time).as(what).isEqualTo(Double.POSITIVE_INFINITY);
        }
    }
}
