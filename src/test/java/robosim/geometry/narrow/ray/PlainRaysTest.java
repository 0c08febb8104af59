package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.Rotations;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;

/** What plain numbers are sure of a box or a cylinder is what the stage with derived bounds says, to the bit. */
class PlainRaysTest {
    private final RayScratch scratch = new Scratch().ray;
    private int sure;
    private int missed;
    private int left;

    @ParameterizedTest
    @EnumSource(names = {"BOX", "UPRIGHT_BOX", "CYLINDER", "UPRIGHT_CYLINDER"})
    void plainNumbersSayTheSameOfRandomRays(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(31);
        for (int i = 0; i < Effort.cases(60_000); i++) {
            double size = Math.scalb(1, random.nextInt(-30, 31));
            double[] row = Leaves.random(kind, random, size);
            double[] o = Leaves.vector(random, 3 * size);
            double[] d = Leaves.vector(random, 1);
            if (random.nextInt(3) > 0) {
                double[] target = inside(kind, row, random, 1.2);
                d = new double[] {target[0] - o[0], target[1] - o[1], target[2] - o[2]};
            }
            compare(kind, row, o, d);
        }
        assertThat(sure).isGreaterThan(Effort.cases(15_000));
        assertThat(missed).isGreaterThan(Effort.cases(15_000));
        assertThat(left).isBetween(Effort.cases(10), Effort.cases(15_000));
    }

    /** Along edges and faces, through corners, from the surface, off by some ulps: mostly for the slabs. */
    @ParameterizedTest
    @EnumSource(names = {"BOX", "UPRIGHT_BOX", "CYLINDER", "UPRIGHT_CYLINDER"})
    void plainNumbersSayTheSameWhereEverythingTies(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(32);
        for (int i = 0; i < Effort.cases(60_000); i++) {
            double[] row = random.nextBoolean() ? Leaves.grid(kind, random) : Leaves.random(kind, random, 2);
            double[] o = random.nextBoolean() ? corner(kind, row, random) : Leaves.gridVector(random, 5);
            double[] to = corner(kind, row, random);
            double[] d = {to[0] - o[0], to[1] - o[1], to[2] - o[2]};
            if (random.nextInt(4) == 0) {
                Arrays.fill(d, 0);
                d[random.nextInt(3)] = random.nextBoolean() ? 1 : -1;
            }
            for (int axis = 0; axis < 3; axis++) {
                o[axis] -= random.nextInt(3) == 0 ? 3 * d[axis] : 0;
                o[axis] += random.nextInt(-2, 3) * Math.ulp(o[axis]);
            }
            if (d[0] != 0 || d[1] != 0 || d[2] != 0) {
                compare(kind, row, o, d);
            }
        }
        assertThat(sure).isGreaterThan(Effort.cases(1000));
        assertThat(left).isGreaterThan(Effort.cases(9000));
    }

    /** Rotations are kept as they are given, orthonormal to 1e-9; rays that pass an edge as near as that. */
    @ParameterizedTest
    @EnumSource(names = {"BOX", "UPRIGHT_BOX", "CYLINDER"})
    void plainNumbersSayTheSameWhereColumnsAreNotQuiteOrthonormal(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(33);
        for (int i = 0; i < Effort.cases(60_000); i++) {
            double[] row = Leaves.random(kind, random, 2);
            double off = random.nextBoolean() ? 4e-10 : 1e-11;
            for (int k = 6; k < 15; k++) {
                row[k] += row[k] == 0 || row[k] == 1 ? 0 : random.nextDouble(-off, off) / 2;
            }
            assertThat(Rotations.isOrthonormal(row, 6)).isTrue();
            double[] to = placed(row, edge(kind, row, random, Math.scalb(1, random.nextInt(-40, -22))));
            double[] d = Leaves.vector(random, 1);
            double back = random.nextDouble(5);
            double[] o = {to[0] - back * d[0], to[1] - back * d[1], to[2] - back * d[2]};
            compare(kind, row, o, d);
        }
        assertThat(sure).isGreaterThan(Effort.cases(1000));
    }

    /** A point in the shape's own frame on its surface but for a share, and on two faces at once where that is possible. */
    private static double[] edge(LeafKind kind, double[] row, SplittableRandom random, double share) {
        double[] own = new double[3];
        int free = random.nextInt(3);
        for (int axis = 0; axis < 3; axis++) {
            double part = axis == free ? random.nextDouble(-1, 1) : random.nextBoolean() ? 1 : -1;
            own[axis] = part * half(kind, row, axis) * (1 + share * random.nextDouble(-1, 1));
        }
        return own;
    }

    private void compare(LeafKind kind, double[] row, double[] o, double[] d) {
        double plain = plain(kind, row, o, d);
        if (!(plain >= 0)) {
            left++;
            return;
        }
        assertThat(plain)
                .as(() -> "%s %s from %s along %s"
                        .formatted(kind, Arrays.toString(row), Arrays.toString(o), Arrays.toString(d)))
                .isEqualTo(bounded(kind, row, o, d));
        if (plain < Double.POSITIVE_INFINITY) {
            sure++;
        } else {
            missed++;
        }
    }

    private double plain(LeafKind kind, double[] row, double[] o, double[] d) {
        BeamAxis ray = new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]);
        return switch (kind) {
            case BOX -> RayBox.plain(ray, row, 0, scratch);
            case UPRIGHT_BOX -> RayBox.plainUpright(ray, row, 0, scratch);
            default -> RayCylinder.plain(ray, cylinder(kind, row), scratch);
        };
    }

    private double bounded(LeafKind kind, double[] row, double[] o, double[] d) {
        BeamAxis ray = new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]);
        return switch (kind) {
            case BOX -> RayBox.inSlabs(ray, row, 0, scratch);
            case UPRIGHT_BOX -> RayBox.inUprightSlabs(ray, row, 0, scratch);
            default -> RayCylinder.inBounds(ray, cylinder(kind, row), scratch);
        };
    }

    private static PlacedCylinder cylinder(LeafKind kind, double[] row) {
        PlacedCylinder cylinder = new PlacedCylinder();
        return kind == LeafKind.UPRIGHT_CYLINDER ? cylinder.upright(row, 0) : cylinder.turned(row, 0);
    }

    private static double[] inside(LeafKind kind, double[] row, SplittableRandom random, double most) {
        double[] own = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            own[axis] = random.nextDouble(-most, most) * half(kind, row, axis);
        }
        return placed(row, own);
    }

    private static double[] corner(LeafKind kind, double[] row, SplittableRandom random) {
        double[] own = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            own[axis] = random.nextInt(-1, 2) * half(kind, row, axis);
        }
        return placed(row, own);
    }

    /** Half the size along one of the shape's own axes. */
    private static double half(LeafKind kind, double[] row, int axis) {
        boolean isBox = kind == LeafKind.BOX || kind == LeafKind.UPRIGHT_BOX;
        return isBox || axis == 1 ? row[3 + axis] : row[3];
    }

    private static double[] placed(double[] row, double[] own) {
        double[] at = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = row[axis] + row[6 + 3 * axis] * own[0] + row[7 + 3 * axis] * own[1] + row[8 + 3 * axis] * own[2];
        }
        return at;
    }
}
