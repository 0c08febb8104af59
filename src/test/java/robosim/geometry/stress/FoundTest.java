package robosim.geometry.stress;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Leaf;
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
}
