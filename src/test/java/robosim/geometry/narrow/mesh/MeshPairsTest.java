package robosim.geometry.narrow.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Overlap;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.LocalLeaves;
import robosim.geometry.narrow.overlap.SpatialOverlap;

/** Two meshes' trees descended together against every pair of their triangles. */
class MeshPairsTest {
    private final Scratch scratch = new Scratch();

    /** Placed so that about half of the pairs meet, many of them by one corner or edge alone, or by nothing but an ulp. */
    @ParameterizedTest
    @EnumSource
    void findsWhatAllPairsFind(MeshRayTest.Family family) {
        SplittableRandom random = new SplittableRandom(631 + family.ordinal());
        int hits = 0;
        int pairs = 0;
        for (int trial = 0; trial < 120; trial++) {
            MeshObject one = placed(family.mesh(random), random.nextInt(5), random);
            MeshObject two = placed(family.mesh(random), random.nextInt(5), random);
            LeafColumn a = LocalLeaves.placed(one);
            double[][] rowsA = MeshRayTest.rows(a);
            two = brought(two, rowsA, trial, family, random);
            LeafColumn b = LocalLeaves.placed(two);
            double[][] rowsB = MeshRayTest.rows(b);
            boolean truth = false;
            for (int p = 0; p < rowsA.length && !truth; p++) {
                for (int q = 0; q < rowsB.length && !truth; q++) {
                    truth = meet(rowsA[p], rowsB[q]);
                }
            }
            String what = one + " and " + two;
            assertThat(Overlap.test(Dimension.SPATIAL, a, 0, b, 0, scratch))
                    .as(what)
                    .isEqualTo(truth);
            assertThat(Overlap.test(Dimension.SPATIAL, b, 0, a, 0, scratch))
                    .as(what + " swapped")
                    .isEqualTo(truth);
            hits += truth ? 1 : 0;
            pairs++;
        }
        // Dots meet by a corner at best.
        assertThat(hits).isBetween(family == MeshRayTest.Family.DOTS ? pairs / 20 : pairs / 10, pairs * 9 / 10);
    }

    private boolean meet(double[] p, double[] q) {
        for (int axis = 0; axis < 3; axis++) { // the plain comparison of corners, which is exact
            if (least(p, axis) > greatest(q, axis) || least(q, axis) > greatest(p, axis)) {
                return false;
            }
        }
        return SpatialOverlap.test(
                new Leaf(LeafKind.TRIANGLE, p, 0), new Leaf(LeafKind.TRIANGLE, q, 0), scratch.overlap);
    }

    private static double least(double[] t, int axis) {
        return Math.min(t[axis], Math.min(t[3 + axis], t[6 + axis]));
    }

    private static double greatest(double[] t, int axis) {
        return Math.max(t[axis], Math.max(t[3 + axis], t[6 + axis]));
    }

    static MeshObject placed(MeshObject mesh, int way, SplittableRandom random) {
        return switch (way) {
            case 0 -> mesh;
            case 1 -> mesh.turned(90, -90);
            case 2 -> mesh.oriented(new double[] {1 - 4e-10, 0, 0, 0, 1, 0, 0, 0, 1 + 4e-10});
            default -> mesh.turned(random.nextDouble(360), random.nextDouble(360));
        };
    }

    /** Moved so that a corner of it lies on a corner of the other one, or beside it, and the rest mostly on the far side. */
    static MeshObject brought(
            MeshObject mesh, double[][] rows, int trial, MeshRayTest.Family family, SplittableRandom random) {
        double[][] own = MeshRayTest.rows(LocalLeaves.placed(mesh));
        int axis = trial % 3;
        double[] highest = extreme(rows, axis, 1);
        double[] lowest = extreme(own, axis, -1);
        double[] to = new double[3];
        double apart = switch (trial % 4) {
            case 0 -> 0;
            case 1 -> family.size() * 0x1p-40;
            case 2 -> -family.size() * 0.01;
            default -> -family.size() * random.nextDouble(3);
        };
        for (int k = 0; k < 3; k++) {
            to[k] = highest[k] - lowest[k] + (k == axis ? apart : 0);
        }
        return mesh.movedTo(new Point(to[0], to[1], to[2]));
    }

    private static double[] extreme(double[][] rows, int axis, int sign) {
        double[] best = {rows[0][0], rows[0][1], rows[0][2]};
        for (double[] row : rows) {
            for (int k = 0; k < 9; k += 3) {
                if (sign * row[k + axis] > sign * best[axis]) {
                    best = new double[] {row[k], row[k + 1], row[k + 2]};
                }
            }
        }
        return best;
    }

    /** The larger one leads, whatever the lengths: no product of the two that overflows or vanishes loses a pair. */
    @Test
    void meetsWhatIsFarLargerOrSmaller() {
        SplittableRandom random = new SplittableRandom(641);
        for (double unit : new double[] {Double.MIN_VALUE, 0x1p-1000, 0x1p-300, 0x1p-60, 0x1p60, 0x1p90}) {
            MeshObject small = triangle(unit);
            for (MeshRayTest.Family family : MeshRayTest.Family.values()) {
                MeshObject mesh = family.mesh(random).turned(random.nextDouble(360), 20);
                double[] t = MeshRayTest.rows(LocalLeaves.placed(mesh))[0];
                LeafColumn a = LocalLeaves.placed(mesh);
                LeafColumn b = LocalLeaves.placed(small.movedTo(new Point(t[0], t[1], t[2])));
                assertThat(Overlap.test(Dimension.SPATIAL, a, 0, b, 0, scratch)).isTrue();
                assertThat(Overlap.test(Dimension.SPATIAL, b, 0, a, 0, scratch)).isTrue();
                LeafColumn away = LocalLeaves.placed(small.movedTo(new Point(0x1p99, 0, 0)));
                assertThat(Overlap.test(Dimension.SPATIAL, a, 0, away, 0, scratch))
                        .isFalse();
            }
        }
    }

    private static MeshObject triangle(double unit) {
        return new MeshObject(
                List.of(new Point(0, 0, 0), new Point(unit, 0, 0), new Point(0, unit, unit)), new int[][] {{0, 1, 2}});
    }
}
