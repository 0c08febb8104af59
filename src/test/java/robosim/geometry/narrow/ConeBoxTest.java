package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.cone.SpatialCone;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;

/** Boxes in cones against the triangles of their faces, for boxes whose corners are doubles. */
class ConeBoxTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** Corners by the bits of their numbers, as faces in two triangles each. */
    private static final int[][] FACES = {
        {0, 1, 3}, {0, 2, 3}, {4, 5, 7}, {4, 6, 7}, {0, 1, 5}, {0, 4, 5},
        {2, 3, 7}, {2, 6, 7}, {0, 2, 6}, {0, 4, 6}, {1, 3, 7}, {1, 5, 7}
    };

    private final Scratch scratch = new Scratch();

    @Test
    void aBoxIsMetWhereAFaceIs() {
        SplittableRandom random = new SplittableRandom(733);
        int trials = 20_000;
        int met = 0;
        for (int k = 0; k < trials; k++) {
            double[] box = box(k, random);
            double[][] corners = corners(box);
            double[] apex = {dyadic(random, 64), dyadic(random, 64), dyadic(random, 64)};
            double half = StrictMath.toRadians(
                    switch (k % 4) {
                        case 0 -> 1e-6;
                        case 1 -> 45;
                        case 2 -> random.nextDouble(0.1, 30);
                        default -> random.nextDouble(30, 90);
                    });
            double cos = StrictMath.cos(half);
            double sin = StrictMath.sin(half);
            double[] u = axis(apex, corners[random.nextInt(8)], corners[random.nextInt(8)], half, random);
            double least = INFINITE;
            double[] row = new double[Leaf.STRIDE];
            for (int[] face : FACES) {
                for (int i = 0; i < 3; i++) {
                    System.arraycopy(corners[face[i]], 0, row, 3 * i, 3);
                }
                least = Math.min(
                        least,
                        SpatialCone.distance(
                                new BeamAxis()
                                        .line(apex[0], apex[1], apex[2], u[0], u[1], u[2])
                                        .widen(cos, sin),
                                LeafKind.TRIANGLE,
                                row,
                                0,
                                Double.POSITIVE_INFINITY,
                                scratch.cone));
            }
            LeafKind kind = k % 2 == 0 ? LeafKind.UPRIGHT_BOX : LeafKind.BOX;
            double found = SpatialCone.distance(
                    new BeamAxis()
                            .line(apex[0], apex[1], apex[2], u[0], u[1], u[2])
                            .widen(cos, sin),
                    kind,
                    box,
                    0,
                    Double.POSITIVE_INFINITY,
                    scratch.cone);
            String what = Arrays.toString(box) + " from " + Arrays.toString(apex) + " along " + Arrays.toString(u)
                    + ", half " + half;
            if (found > 0) { // else the apex is inside
                assertThat(found < INFINITE).as(what).isEqualTo(least < INFINITE);
                met += least < INFINITE ? 1 : 0;
            }
        }
        assertThat(met).isBetween(trials / 5, trials * 4 / 5);
    }

    private static double dyadic(SplittableRandom random, int most) {
        return random.nextInt(-most, most + 1) * 0x1p-3;
    }

    /** One in three is a dot, one a stick; every other one lies on its side. */
    private static double[] box(int way, SplittableRandom random) {
        double[] row = new double[Leaf.STRIDE];
        for (int axis = 0; axis < 3; axis++) {
            row[axis] = dyadic(random, 64);
            row[3 + axis] =
                    way % 3 == 0 || (way % 3 == 1 && axis != way / 3 % 3) ? 0x1p-20 : random.nextInt(32) * 0x1p-3;
            int column = way % 2 == 0 ? axis : (axis + 1) % 3;
            row[Leaf.ROTATION + 3 * axis + column] = 1;
        }
        return row;
    }

    private static double[][] corners(double[] box) {
        double[][] corners = new double[8][3];
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 0; axis < 3; axis++) {
                double place = box[axis];
                for (int i = 0; i < 3; i++) {
                    double half = (corner >> i & 1) == 0 ? -box[3 + i] : box[3 + i];
                    place += half * box[Leaf.ROTATION + 3 * axis + i];
                }
                corners[corner][axis] = place;
            }
        }
        return corners;
    }

    /** Aimed between two corners, at one, beside one so that it lies on the border but for rounding, or anywhere. */
    private static double[] axis(double[] apex, double[] p, double[] q, double half, SplittableRandom random) {
        int way = random.nextInt(4);
        double[] u = new double[3];
        double[] w = new double[3];
        for (int k = 0; k < 3; k++) {
            u[k] = (way == 0 ? (p[k] + q[k]) / 2 : p[k]) - apex[k];
            w[k] = random.nextDouble(-1, 1);
        }
        double length = VectorMath.length(u[0], u[1], u[2]);
        if (way == 3 || length == 0) {
            return w;
        }
        if (way == 2) {
            double[] across = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
            double share = length / VectorMath.length(across[0], across[1], across[2]) * StrictMath.tan(half);
            for (int k = 0; k < 3; k++) {
                u[k] += share * across[k];
            }
        }
        return u;
    }
}
