package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.PlanarRows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;

/** Discs that turn past the end of a side. The census has the random turns, in every regime. */
class PlanarTurnSweepTest {
    private final Scratch scratch = new Scratch();

    /** It grazes the line of a side beyond the side's end: the way along that line is no part of the contact. */
    @Test
    void aDiscThatPassesTheEndOfASideIsNotStoppedBeforeIt() {
        double[] disc = SweepRows.disc(0.39700994351509666, 0, 0.3582216939049856, 1.5301727349261678E-12, 1);
        double[] box = new double[Leaf.STRIDE];
        System.arraycopy(
                new double[] {-0.24879647073707784, 0, 1.7267438464416869, 0.8904104402857016, 1, 0.8536647401457984},
                0,
                box,
                0,
                6);
        System.arraycopy(
                new double[] {
                    0.8831513958390621, 0, 0.4690880642560801, 0, 1, 0, -0.4690880642560801, 0, 0.8831513958390621
                },
                0,
                box,
                Leaf.ROTATION,
                9);
        double px = -0.3423529954203559;
        double pz = -0.34756818533578415;
        double degrees = -51.102608853458996;
        double share = PlanarSweep.turn(
                new Leaf(LeafKind.SPHERE, disc, 0),
                new PivotTurn().about(px, 0, pz).by(0, 1, 0, degrees),
                new Leaf(LeafKind.UPRIGHT_BOX, box, 0),
                scratch.sweep);
        double gap = gap(LeafKind.SPHERE, disc, px, pz, degrees * Math.min(1, share), LeafKind.UPRIGHT_BOX, box);
        assertThat(share > 1 || gap < 0x1p-30)
                .as("share %s, gap %s", share, gap)
                .isTrue();
    }

    /** It starts 10^-16 from a corner, a hair past the end of a side of 8e-5, and comes over that side and into it. */
    @Test
    void aDiscThatComesOverTheEndOfASideIsStoppedThere() {
        double[] disc = SweepRows.disc(0.13796715898997713, 0, -0.42254734082377676, 0.49036815246453935, 1);
        double[] box = new double[Leaf.STRIDE];
        double[] numbers = {
            0.9044714254705242,
            0.8957468915180091,
            0.031897122313213844,
            1.1401566519911221E-11,
            4.6333573064585746E-5,
            0.6074092857512731,
            -0.31587400384114317,
            0.6261313156859153,
            -0.712869685997932,
            0.5120134852191277,
            -0.520057470334932,
            -0.6836537270450542,
            -0.7987902131668412,
            -0.5809473324375075,
            -0.15631504176699187
        };
        System.arraycopy(numbers, 0, box, 0, numbers.length);
        double px = 1.5984062612296086;
        double pz = 1.1514794349385777;
        double share = PlanarSweep.turn(
                new Leaf(LeafKind.SPHERE, disc, 0),
                new PivotTurn().about(px, 0, pz).by(0, 1, 0, 35.23771176608052),
                new Leaf(LeafKind.BOX, box, 0),
                scratch.sweep);
        double gap = gap(LeafKind.SPHERE, disc, px, pz, 35.23771176608052 * share, LeafKind.BOX, box);
        assertThat(gap).as("share %s", share).isGreaterThan(-1e-14);
    }

    /** Distance of the two, or less the depth, when the first is turned about the upward vertical. */
    private static double gap(
            LeafKind kindA, double[] a, double px, double pz, double degrees, LeafKind kindB, double[] b) {
        double angle = Math.toRadians(-degrees);
        return PlanarRows.twin(kindA, a)
                .turned(px, pz, StrictMath.cos(angle), StrictMath.sin(angle))
                .partedRoughly(PlanarRows.twin(kindB, b));
    }
}
