package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** Octagons and their prisms are only passed over where the whole kernel finds nothing within the limit. */
class OctagonTest {
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void answersAsWithoutFilters(Dimension dimension) {
        boolean isFlat = dimension == Dimension.PLANAR;
        SplittableRandom random = new SplittableRandom(8);
        ConeScratch s = new Scratch().cone;
        ConeScratch whole = new Scratch().cone;
        int count = Effort.cases(20_000);
        int passed = 0;
        int near = 0;
        for (int k = 0; k < count; k++) {
            double[] row = octagon(random);
            BeamAxis beam = beam(random, isFlat, row);
            double half = Math.toRadians(random.nextDouble(1, 60));
            beam.widen(StrictMath.cos(half), StrictMath.sin(half));
            double limit = random.nextInt(3) == 0 ? Double.POSITIVE_INFINITY : random.nextDouble(8);
            double quick = isFlat
                    ? PlanarCone.distance(beam, LeafKind.PRISM, row, 0, limit, s)
                    : SpatialCone.distance(beam, LeafKind.PRISM, row, 0, limit, s);
            double all = isFlat
                    ? PlanarCone.all(beam, LeafKind.PRISM, row, 0, Double.POSITIVE_INFINITY, whole)
                    : SpatialCone.all(beam, LeafKind.PRISM, row, 0, Double.POSITIVE_INFINITY, whole);
            if (all <= limit) {
                assertThat(quick).isEqualTo(all);
                near++;
            } else {
                assertThat(quick).isIn(all, Double.POSITIVE_INFINITY);
                passed += quick == Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        assertThat(near).isGreaterThan(count / 20);
        assertThat(passed).isGreaterThan(count / 4);
    }

    /** A box of up to 4 a side whose corners are cut off by up to all of it. */
    private static double[] octagon(SplittableRandom random) {
        double x = random.nextDouble(-5, 5);
        double y = random.nextDouble(-2, 2);
        double z = random.nextDouble(-5, 5);
        double a = random.nextDouble(0.1, 2);
        double b = random.nextDouble(0.1, 2);
        double c = random.nextDouble(0.1, 2);
        double[] row = new double[16];
        double[] cut = new double[4];
        for (int k = 0; k < 4; k++) {
            cut[k] = (a + c) * random.nextDouble(0.6, 1);
        }
        double[] range = {x - a, x + a, z - c, z + c, x + z - cut[0], x + z + cut[1], x - z - cut[2], x - z + cut[3]};
        System.arraycopy(range, 0, row, 0, 8);
        row[8] = y - b;
        row[9] = y + b;
        return row;
    }

    /** From anywhere, or now and then past a corner of the prism by little or nothing. */
    private static BeamAxis beam(SplittableRandom random, boolean isFlat, double[] row) {
        double toX = random.nextInt(2) == 0 ? row[random.nextInt(2)] : random.nextDouble(-5, 5);
        double toZ = random.nextInt(2) == 0 ? row[4] - toX : random.nextDouble(-5, 5);
        double x = random.nextDouble(-6, 6);
        double z = random.nextDouble(-6, 6);
        double y = isFlat ? 0 : random.nextDouble(-3, 3);
        double rise = isFlat ? 0 : random.nextDouble(-1, 1);
        double dx = random.nextInt(8) == 0 ? 0 : toX - x;
        return new BeamAxis().line(x, y, z, dx, rise, toZ - z);
    }
}
