package robosim.geometry.narrow.cone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** An upright box in a sector, of which only the nearest point is computed, has the distance of all of it, to the bit. */
class PlainSectorBoxTest {
    private static final int CASES = Effort.cases(60_000);

    private final Scratch scratch = new Scratch();
    private final PlainSectorBox plain = new PlainSectorBox();
    private final Cone cone = new Cone();
    private final int[] known = new int[4];
    private int cut;

    @Test
    void saysTheSameOfRandomSectors() {
        SplittableRandom random = new SplittableRandom(71);
        for (int i = 0; i < CASES; i++) {
            double size = Math.scalb(1, random.nextInt(-30, 31));
            double[] row = Leaves.random(LeafKind.UPRIGHT_BOX, random, size);
            row[3 + random.nextInt(3)] *= random.nextInt(3) == 0 ? 0.05 : 1;
            double[] o = Leaves.vector(random, random.nextInt(1, 5) * size);
            double[] to = placed(row, random.nextDouble(-3, 3), random.nextDouble(-3, 3));
            double half = random.nextInt(3) > 0 ? random.nextDouble(0.02, 0.3) : random.nextDouble(0.001, 1.57);
            compare(row, o[0], o[2], to[0] - o[0], to[1] - o[2], StrictMath.cos(half), random);
        }
        assertThat(known[PlainSectorBox.HELD]).isGreaterThan(CASES / 12);
        assertThat(known[PlainSectorBox.CROSSED]).isGreaterThan(CASES / 6);
        assertThat(known[PlainSectorBox.BEYOND]).isGreaterThan(CASES / 6);
        assertThat(known[PlainSectorBox.UNSURE]).isBetween(CASES / 60, CASES / 3);
        assertThat(cut).as("beyond a limit").isGreaterThan(CASES / 20);
    }

    /** Borders through corners, axes along sides, thin boxes, from the outline: off by some ulps. */
    @Test
    void saysTheSameWherePointsTie() {
        SplittableRandom random = new SplittableRandom(72);
        for (int i = 0; i < CASES; i++) {
            double[] row = random.nextBoolean()
                    ? Leaves.grid(LeafKind.UPRIGHT_BOX, random)
                    : Leaves.random(LeafKind.UPRIGHT_BOX, random, 2);
            if (random.nextInt(4) == 0) {
                row[random.nextBoolean() ? 3 : 5] *= Math.scalb(1, -random.nextInt(60));
            }
            double[] o = random.nextInt(5) == 0
                    ? placed(row, random.nextInt(-2, 3) / 2.0, random.nextInt(-1, 2))
                    : new double[] {random.nextInt(-6, 7), random.nextInt(-6, 7)};
            double[] to = placed(row, random.nextInt(-2, 3), random.nextInt(-1, 2));
            double dx = to[0] - o[0];
            double dz = to[1] - o[1];
            if (random.nextInt(3) == 0) {
                dx = row[6];
                dz = row[12];
            }
            double[] border = placed(row, random.nextInt(-1, 2), random.nextInt(-1, 2));
            double bx = border[0] - o[0];
            double bz = border[1] - o[1];
            double cos = (dx * bx + dz * bz) / Math.sqrt((dx * dx + dz * dz) * (bx * bx + bz * bz));
            if (!(cos > 0 && cos < 1)) {
                cos = StrictMath.cos(random.nextDouble(0.01, 1.5));
            }
            for (int k = random.nextInt(4); k > 0; k--) {
                cos = random.nextBoolean() ? Math.nextUp(cos) : Math.nextDown(cos);
            }
            double ox = o[0] + random.nextInt(-2, 3) * Math.ulp(o[0]);
            if ((dx != 0 || dz != 0) && cos < 1) {
                compare(row, ox, o[1], dx, dz, cos, random);
            }
        }
        assertThat(known[PlainSectorBox.HELD]).isGreaterThan(CASES / 60);
        assertThat(known[PlainSectorBox.CROSSED]).isGreaterThan(CASES / 60);
        assertThat(known[PlainSectorBox.BEYOND]).isGreaterThan(CASES / 12);
        assertThat(known[PlainSectorBox.UNSURE]).isGreaterThan(CASES / 6);
    }

    private void compare(
            double[] row, double ox, double oz, double dx, double dz, double cos, SplittableRandom random) {
        LeafKind kind = LeafKind.UPRIGHT_BOX;
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        BeamAxis beam = new BeamAxis().line(ox, 0, oz, dx, 0, dz).widen(cos, sin);
        double all = PlanarCone.all(beam, kind, row, 0, Double.POSITIVE_INFINITY, scratch.cone);
        double none = Double.POSITIVE_INFINITY;
        double near = PlanarCone.distance(beam, kind, row, 0, none, scratch.cone);
        if (Double.doubleToLongBits(near) != Double.doubleToLongBits(all)) {
            assertThat(near).as(name(row, ox, oz, dx, dz, cos)).isEqualTo(all);
        }
        cone.set(beam, 0);
        known[plain.look(cone, row, 0, none)]++;
        double limit = random.nextInt(3) == 0 ? all : all * random.nextDouble(0.5, 1.5);
        double limited = PlanarCone.distance(beam, kind, row, 0, limit, scratch.cone);
        if (limited != all) {
            cut++;
            assertThat(limited == none && all > limit)
                    .as("%s: %s of %s within %s", name(row, ox, oz, dx, dz, cos), limited, all, limit)
                    .isTrue();
        }
    }

    private static String name(double[] row, double ox, double oz, double dx, double dz, double cos) {
        return "%s from %s, %s along %s, %s, cosine %s".formatted(Arrays.toString(row), ox, oz, dx, dz, cos);
    }

    private static double[] placed(double[] row, double ownX, double ownZ) {
        double x = ownX * row[3];
        double z = ownZ * row[5];
        return new double[] {row[0] + row[6] * x + row[8] * z, row[2] + row[12] * x + row[14] * z};
    }
}
