package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** An octagon is hit where the prism above and below it is: prisms are compared with decimals elsewhere. */
class OctagonRayTest {
    @Test
    void isHitAsThePrismInSpace() {
        SplittableRandom random = new SplittableRandom(9);
        RayScratch s = new Scratch().ray;
        int count = Effort.cases(20_000);
        int hits = 0;
        for (int k = 0; k < count; k++) {
            double x = random.nextDouble(-5, 5);
            double z = random.nextDouble(-5, 5);
            double a = random.nextDouble(0.1, 2);
            double c = random.nextDouble(0.1, 2);
            double cut = (a + c) * random.nextDouble(0.6, 1);
            double[] row = {x - a, x + a, z - c, z + c, x + z - cut, x + z + cut, x - z - cut, x - z + cut, -1, 1};
            // Half of them go through a corner, or past it by little.
            boolean isToCorner = random.nextBoolean();
            double toX = isToCorner ? row[0] : random.nextDouble(-6, 6);
            double toZ = isToCorner ? row[4] - toX : random.nextDouble(-6, 6);
            double fromX = random.nextDouble(-6, 6);
            double fromZ = random.nextDouble(-6, 6);
            double length = k % 7 == 0 ? 1e-9 : 1;
            BeamAxis ray = new BeamAxis()
                    .line(
                            fromX,
                            0,
                            fromZ,
                            k % 8 == 0 ? 0 : length * (toX - fromX),
                            0,
                            k % 8 == 1 ? 0 : length * (toZ - fromZ));
            double found = PlanarRay.distance(ray, LeafKind.PRISM, row, 0, s);
            assertThat(found).isEqualTo(SpatialRay.distance(ray, LeafKind.PRISM, row, 0, s));
            row[8] = 2; // heights do not count
            row[9] = 3;
            assertThat(PlanarRay.distance(ray, LeafKind.PRISM, row, 0, s)).isEqualTo(found);
            hits += found < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(hits).isBetween(count / 10, count * 9 / 10);
    }
}
