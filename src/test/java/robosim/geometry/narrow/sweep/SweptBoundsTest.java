package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.leaf.PivotTurn;

class SweptBoundsTest {
    private static final int SAMPLES = 2000;

    private final Scratch scratch = new Scratch();
    private final SplittableRandom random = new SplittableRandom(20054);

    @Test
    void aTurnStaysWithinAndReachesItsBounds() {
        int pushed = 0;
        int still = 0;
        for (int k = 0; k < 60; k++) {
            for (LeafKind kind : EnumSet.range(LeafKind.UPRIGHT_BOX, LeafKind.TRIANGLE)) {
                double[] row = SweepRows.random(kind, 3, random);
                double[] frame = SweepRows.random(LeafKind.BOX, 3, random);
                double[] axis = k % 3 == 0 ? new double[] {0, 1, 0} : new double[] {frame[6], frame[9], frame[12]};
                double[] p = k % 2 == 0 ? row.clone() : frame;
                double degrees = random.nextDouble(-200, 200) * (k % 5 == 0 ? 3 : 1);
                double[] bounds = new double[6];
                SweptBounds.turn(
                        new Leaf(kind, row, 0),
                        new PivotTurn().about(p[0], p[1], p[2]).by(axis[0], axis[1], axis[2], degrees),
                        bounds,
                        scratch.sweep);
                double[] seen = sampled(kind, row, p, axis, degrees);
                double[] start = new double[6];
                LeafBounds.of(kind, row, 0, start);
                for (int m = 0; m < 6; m++) {
                    String what = "kind %s %s about %s by %s: %s"
                            .formatted(kind, Arrays.toString(row), Arrays.toString(axis), degrees, m);
                    double sign = m < 3 ? -1 : 1;
                    assertThat(sign * (bounds[m] - seen[m])).as(what).isBetween(-1e-13, 2e-5);
                    assertThat(sign * (bounds[m] - start[m]) + 0.0).as(what).isNotNegative();
                    pushed += bounds[m] == start[m] ? 0 : 1;
                    still += bounds[m] == start[m] ? 1 : 0;
                }
            }
        }
        assertThat(pushed).isGreaterThan(500);
        assertThat(still).isGreaterThan(100);
    }

    @Test
    void aTurnAboutItsOwnAxisPushesNothingOut() {
        double[] robot = SweepRows.disc(0.1, 0.2, 0.3, 0.7, 1.1);
        double[] bounds = new double[6];
        double[] start = new double[6];
        LeafBounds.of(LeafKind.UPRIGHT_CYLINDER, robot, 0, start);
        SweptBounds.turn(
                new Leaf(LeafKind.UPRIGHT_CYLINDER, robot, 0),
                new PivotTurn().about(0.1, 0.2, 0.3).by(0, 1, 0, 1234.5),
                bounds,
                scratch.sweep);
        assertThat(bounds).containsExactly(start);
    }

    @Test
    void aTranslationStretchesTheBounds() {
        double[] box = SweepRows.uprightBox(1, 2, 3, 0.5, 1, 2, 90);
        double[] bounds = new double[6];
        SweptBounds.translation(new Leaf(LeafKind.UPRIGHT_BOX, box, 0), 4, -8, 0, bounds);
        assertThat(bounds).containsExactly(-1, -7, 2.5, 7, 3, 3.5);
    }

    private static double[] sampled(LeafKind kind, double[] row, double[] p, double[] axis, double degrees) {
        double[] seen = new double[6];
        Arrays.fill(seen, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(seen, 3, 6, Double.NEGATIVE_INFINITY);
        double[] pose = new double[Leaf.STRIDE];
        double[] bounds = new double[6];
        for (int k = 0; k <= SAMPLES; k++) {
            double angle = Math.toRadians(degrees * k / SAMPLES);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            MovedLeaf.turned(
                    new Leaf(kind, row, 0),
                    new PivotTurn().about(p[0], p[1], p[2]).by(axis[0], axis[1], axis[2], 0),
                    cos,
                    sin,
                    new Leaf(LeafKind.SPHERE, pose, 0));
            LeafBounds.of(MovedLeaf.turnedKind(kind), pose, 0, bounds);
            for (int m = 0; m < 3; m++) {
                seen[m] = Math.min(seen[m], bounds[m]);
                seen[m + 3] = Math.max(seen[m + 3], bounds[m + 3]);
            }
        }
        return seen;
    }
}
