package robosim.geometry.stress;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Leaf;
import robosim.geometry.narrow.PlanarOverlap;
import robosim.geometry.narrow.PlanarRay;
import robosim.geometry.narrow.Scratch;

/** What a stress run has found wrong once, in the numbers that it found. */
class FoundTest {
    /** It starts 1e-17 above a box that is thinner than any rounding, and goes away from it. */
    @Test
    void aRayFromJustBesideAFlatBoxMisses() {
        double cos = 0x1.f3b92138b3964p-2;
        double sin = -0x1.bee48faab16e3p-1;
        double[] box = new double[16];
        box[3] = 0x1.743799ce872dap-1;
        box[4] = 1;
        box[5] = Double.MIN_VALUE;
        Forms.upright(box, cos, sin);
        double distance = PlanarRay.distance(
                -0x1.107814fb7f712p-2,
                -0x1.e753e44686f26p-2,
                0x1.6b4ac6a501e23p-3,
                0x1.44e2982f04a19p-2,
                Leaf.UPRIGHT_BOX,
                box,
                0,
                new Scratch());
        assertThat(distance).isInfinite();
    }

    /** A side of 5e-324 is parallel to all others, as far as products that underflow can tell. */
    @Test
    void aBoxOfNoHeightThrowsItsWholeShadow() {
        double[] disc = new double[16];
        disc[2] = -1;
        double[] box = {
            0x1.0def1faaed8c4p-1,
            -0x1.8832dcab9e788p-2,
            -0x1.4283e76aab848p1,
            2,
            Double.MIN_VALUE,
            0.5,
            0x1.2183249acded2p-2,
            -0x1.47231b531975ep-1,
            0x1.6e4b2532da379p-1,
            -0x1.7345cd99ffdf2p-2,
            0x1.3d181f92c672ap-1,
            0x1.648f21e4d8476p-1,
            -0x1.c6aca59a2d23ep-1,
            -0x1.d33b826ad65aap-2,
            -0x1.cf599dded3e4p-5,
            0
        };
        assertThat(PlanarOverlap.test(Leaf.SPHERE, disc, 0, Leaf.BOX, box, 0, new Scratch()))
                .isTrue();
    }
}
