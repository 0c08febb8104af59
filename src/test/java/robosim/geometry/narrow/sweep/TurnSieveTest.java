package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;

/** What is left out as clear of a turn is free for the kernel too. */
class TurnSieveTest {
    private final Scratch scratch = new Scratch();
    private final TurnSieve sieve = new TurnSieve();
    private final SplittableRandom random = new SplittableRandom(8301);

    @Test
    void whatIsClearIsFree() {
        int cases = Effort.cases(20_000);
        int clear = 0;
        int blocked = 0;
        for (int k = 0; k < cases; k++) {
            double[] moving = k % 2 == 0 ? anywhere() : tip();
            double[] resting = k % 2 == 0 ? anywhere() : wall();
            double degrees = random.nextBoolean() ? random.nextDouble(-20, 20) : random.nextDouble(-300, 300);
            PivotTurn turn = new PivotTurn().about(0.1, 0.2, -0.1);
            if (k % 2 == 0) {
                double angle = random.nextDouble(7);
                double up = random.nextDouble(-1, 1);
                double level = StrictMath.sqrt(1 - up * up);
                turn.by(level * StrictMath.cos(angle), up, level * StrictMath.sin(angle), degrees);
            } else { // from one side of the nearest point of the wall to the other
                degrees = random.nextDouble(5, 140);
                moving = turned(moving, -degrees / 2);
                turn.about(0, 0, 0).by(0, 1, 0, degrees);
            }
            sieve.begin(turn, false);
            sieve.mover(moving);
            boolean isClear = sieve.isClear(resting, moving);
            double free = SpatialSweep.turn(
                    new Leaf(LeafKind.TRIANGLE, moving, 0),
                    turn,
                    new Leaf(LeafKind.TRIANGLE, resting, 0),
                    scratch.sweep);
            if (isClear) {
                assertThat(free)
                        .as("%s turned by %s past %s", Arrays.toString(moving), degrees, Arrays.toString(resting))
                        .isInfinite();
            }
            clear += isClear ? 1 : 0;
            blocked += free < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(clear).isBetween(cases / 10, cases * 9 / 10);
        assertThat(blocked).isBetween(cases / 20, cases * 9 / 10);
    }

    private double[] anywhere() {
        double[] t = new double[Leaf.STRIDE];
        double size = random.nextBoolean() ? 1 : 0.1;
        for (int axis = 0; axis < 3; axis++) {
            double at = random.nextDouble(-1, 1);
            for (int k = axis; k < 9; k += 3) {
                t[k] = at + random.nextDouble(-size, size);
            }
        }
        return t;
    }

    /** A triangle near (1, 0, 0), where a turn about the vertical is farthest along X. */
    private double[] tip() {
        double[] t = new double[Leaf.STRIDE];
        for (int k = 0; k < 9; k += 3) {
            t[k] = 1 - random.nextDouble(0.1);
            t[k + 1] = random.nextDouble(-0.1, 0.1);
            t[k + 2] = random.nextDouble(-0.1, 0.1);
        }
        return t;
    }

    /** A large triangle across X, a little nearer or farther than a tip comes. */
    private double[] wall() {
        double x = random.nextDouble(0.5, 1.1);
        double[] t = {x, -3, -3, x, -3, 3, x, 5, 0, 0, 0, 0, 0, 0, 0, 0};
        return Arrays.copyOf(t, Leaf.STRIDE);
    }

    private static double[] turned(double[] t, double degrees) {
        double angle = StrictMath.toRadians(degrees);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        double[] out = t.clone();
        for (int k = 0; k < 9; k += 3) {
            out[k] = cos * t[k] + sin * t[k + 2];
            out[k + 2] = cos * t[k + 2] - sin * t[k];
        }
        return out;
    }
}
