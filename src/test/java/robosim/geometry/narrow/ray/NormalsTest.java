package robosim.geometry.narrow.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Leaves;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.normal.Normals;

class NormalsTest {
    private final Scratch scratch = new Scratch();
    private final Normals normals = new Normals();
    private final double[] normal = new double[3];

    /** Two more rays beside the one tell the slope of the surface. */
    @ParameterizedTest
    @EnumSource(
            names = {"MESH", "SOLID_MESH", "GRID"},
            mode = EnumSource.Mode.EXCLUDE)
    void agreesWithTheSlopeOfTheDistances(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(kind.ordinal());
        int checked = 0;
        for (int i = 0; i < 600; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double[] o = Leaves.vector(random, 4);
            double[] near = pointOf(kind, row, random);
            double[] d = SpatialRayTest.unit(new double[] {near[0] - o[0], near[1] - o[1], near[2] - o[2]});
            double[] e = SpatialRayTest.unit(SpatialRayTest.cross(d, Leaves.vector(random, 1)));
            double[] f = SpatialRayTest.cross(d, e);
            double t = ray(o, d, kind, row);
            double step = 1e-6;
            double slopeE = (ray(plus(o, e, step), d, kind, row) - t) / step;
            double slopeF = (ray(plus(o, f, step), d, kind, row) - t) / step;
            double backE = (t - ray(plus(o, e, -step), d, kind, row)) / step;
            double backF = (t - ray(plus(o, f, -step), d, kind, row)) / step;
            boolean isSmooth = Math.abs(slopeE - backE) + Math.abs(slopeF - backF) < 1e-3;
            if (t == 0 || !isSmooth || Math.abs(slopeE) + Math.abs(slopeF) > 20) {
                continue;
            }
            checked++;
            double[] slope = new double[3];
            for (int k = 0; k < 3; k++) {
                slope[k] = slopeE * e[k] + slopeF * f[k] - d[k];
            }
            double[] p = plus(o, d, t);
            at(p, d, kind, row, Dimension.SPATIAL);
            double[] truth = SpatialRayTest.unit(slope);
            for (int k = 0; k < 3; k++) {
                assertThat(normal[k]).as(SpatialRayTest.name(o, d, kind, row)).isCloseTo(truth[k], within(1e-3));
            }
        }
        // The others start inside, meet an edge or graze.
        assertThat(checked).isGreaterThan(540);
    }

    /** The plan of an upright leaf is that of the leaf in space, met on the level. */
    @ParameterizedTest
    @EnumSource(names = {"UPRIGHT_BOX", "UPRIGHT_CYLINDER", "SPHERE", "PRISM", "UPRIGHT_CAPSULE"})
    void aPlanHasTheNormalsOfTheLevel(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(20 + kind.ordinal());
        int checked = 0;
        for (int i = 0; i < 500; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double y = kind == LeafKind.PRISM ? (row[8] + row[9]) / 2 : row[1];
            double[] o = {random.nextDouble(-4, 4), y, random.nextDouble(-4, 4)};
            double[] d = {random.nextDouble(-1, 1) - o[0], 0, random.nextDouble(-1, 1) - o[2]};
            double t = ray(o, d, kind, row);
            if (Double.isInfinite(t) || t == 0) {
                continue;
            }
            checked++;
            double[] p = plus(o, SpatialRayTest.unit(d), t);
            at(p, d, kind, row, Dimension.SPATIAL);
            double[] truth = normal.clone();
            at(new double[] {p[0], 77, p[2]}, new double[] {d[0], -5, d[2]}, kind, row, Dimension.PLANAR);
            assertThat(normal).containsExactly(truth, within(1e-15));
        }
        assertThat(checked).isGreaterThan(60);
    }

    /** Against the extreme points of the projection: nothing of it is beyond the tangent at the place that was hit. */
    @ParameterizedTest
    @EnumSource(names = {"BOX", "CYLINDER", "TRIANGLE", "CAPSULE"})
    void nothingOfAPlanIsBeyondItsTangent(LeafKind kind) {
        SplittableRandom random = new SplittableRandom(40 + kind.ordinal());
        int left = 0;
        int right = 0;
        for (int i = 0; i < 300; i++) {
            double[] row = Leaves.random(kind, random, 1);
            double angle = random.nextDouble(0, 2 * Math.PI);
            double[] n = {StrictMath.cos(angle), 0, StrictMath.sin(angle)};
            double[] p = extreme(kind, row, n);
            // Coming in a little aside, as at a corner only the face that is met has a normal.
            double[] aim = new double[] {-n[0] + random.nextDouble(-0.3, 0.3), 0, -n[2] + random.nextDouble(-0.3, 0.3)};
            at(p, aim, kind, row, Dimension.PLANAR);
            assertThat(VectorMath.length(normal[0], normal[1], normal[2])).isCloseTo(1, within(1e-14));
            assertThat(normal[1]).isZero();
            assertThat(aim[0] * normal[0] + aim[2] * normal[2])
                    .as("against the ray")
                    .isNegative();
            double[] farthest = extreme(kind, row, normal);
            double beyond = (farthest[0] - p[0]) * normal[0] + (farthest[2] - p[2]) * normal[2];
            double side = n[0] * normal[2] - n[2] * normal[0];
            left += side < -1e-3 ? 1 : 0;
            right += side > 1e-3 ? 1 : 0;
            assertThat(beyond)
                    .as(SpatialRayTest.name(p, aim, kind, row) + " " + normal[0] + " " + normal[2])
                    .isCloseTo(0, within(1e-12));
        }
        // At a corner either face is met about as often; an oval has no corners.
        assertThat(List.of(left, right))
                .allSatisfy(count -> assertThat(count).isBetween(kind.isRound() ? 0 : 100, kind.isRound() ? 0 : 200));
    }

    @Test
    void aStartInsideGetsTheOppositeOfTheRay() {
        double[] box = {0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
        for (LeafKind kind : new LeafKind[] {
            LeafKind.UPRIGHT_BOX,
            LeafKind.BOX,
            LeafKind.UPRIGHT_CYLINDER,
            LeafKind.SPHERE,
            LeafKind.UPRIGHT_CAPSULE,
            LeafKind.CAPSULE
        }) {
            at(new double[] {.25, .25, 0}, new double[] {3, 4, 0}, kind, box, Dimension.SPATIAL);
            assertThat(normal).containsExactly(new double[] {-.6, -.8, 0}, within(1e-15));
            at(new double[] {.25, 9, 0}, new double[] {3, 9, 4}, kind, box, Dimension.PLANAR);
            assertThat(normal).containsExactly(new double[] {-.6, 0, -.8}, within(1e-15));
        }
    }

    @Test
    void aTriangleTurnsItsSideToTheRay() {
        double[] triangle = {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
        double[] p = {.25, 0, .25};
        at(p, new double[] {1, -5, 1}, LeafKind.TRIANGLE, triangle, Dimension.SPATIAL);
        assertThat(normal).containsExactly(0, 1, 0);
        at(p, new double[] {1, 5, 1}, LeafKind.TRIANGLE, triangle, Dimension.SPATIAL);
        assertThat(normal).containsExactly(0, -1, 0);
        double[] segment = {0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        at(new double[] {1, 0, 0}, new double[] {7, -2, 0}, LeafKind.TRIANGLE, segment, Dimension.SPATIAL);
        assertThat(normal).containsExactly(0, 1, 0);
        at(new double[] {0, 0, 0}, new double[] {7, 0, 0}, LeafKind.TRIANGLE, segment, Dimension.SPATIAL);
        assertThat(normal).containsExactly(-1, 0, 0);
        at(new double[] {0, 0, 0}, new double[] {7, 0, 0}, LeafKind.TRIANGLE, segment, Dimension.PLANAR);
        assertThat(normal).containsExactly(-1, 0, 0);
    }

    private void at(double[] p, double[] d, LeafKind kind, double[] row, Dimension dimension) {
        normals.at(new BeamAxis().line(p[0], p[1], p[2], d[0], d[1], d[2]), 0, kind, row, 0, normal, dimension);
    }

    /** A point of a leaf that is not near its edges. */
    private static double[] pointOf(LeafKind kind, double[] row, SplittableRandom random) {
        double[] p = {row[0], row[1], row[2]};
        double[] s = Leaves.vector(random, 0.5);
        if (kind == LeafKind.TRIANGLE) {
            for (int k = 0; k < 3; k++) {
                p[k] = 0.5 * row[k] + (0.25 + s[0] / 4) * row[3 + k] + (0.25 - s[0] / 4) * row[6 + k];
            }
            return p;
        }
        for (int k = 0; k < 3; k++) {
            if (kind == LeafKind.PRISM) {
                int at = new int[] {0, 8, 2}[k];
                p[k] = (row[at] + row[at + 1]) / 2 + s[k] * (row[at + 1] - row[at]) / 2;
            } else if (kind == LeafKind.SPHERE) {
                p[k] += s[k] * row[3];
            } else if (kind == LeafKind.UPRIGHT_CYLINDER || kind == LeafKind.UPRIGHT_CAPSULE) {
                p[k] += s[k] * row[k == 1 ? 4 : 3];
            } else {
                double[] half =
                        kind.isRound() ? new double[] {row[3], row[4], row[3]} : new double[] {row[3], row[4], row[5]};
                for (int own = 0; own < 3; own++) {
                    p[k] += s[own] * half[own] * row[6 + 3 * k + own];
                }
            }
        }
        return p;
    }

    // The point of a leaf that is farthest along a level direction.
    private static double[] extreme(LeafKind kind, double[] row, double[] n) {
        double[] p = {row[0], 0, row[2]};
        if (kind == LeafKind.TRIANGLE) {
            for (int i = 3; i < 9; i += 3) {
                if (row[i] * n[0] + row[i + 2] * n[2] > p[0] * n[0] + p[2] * n[2]) {
                    p = new double[] {row[i], 0, row[i + 2]};
                }
            }
            return p;
        }
        double[] along = new double[3];
        for (int i = 0; i < 3; i++) {
            along[i] = row[6 + i] * n[0] + row[12 + i] * n[2];
        }
        if (kind == LeafKind.CAPSULE) {
            double end = Math.copySign(row[4], along[1]);
            return new double[] {p[0] + end * row[7] + row[3] * n[0], 0, p[2] + end * row[13] + row[3] * n[2]};
        }
        double round = Math.hypot(along[0], along[2]);
        for (int i = 0; i < 3; i++) {
            double share = kind == LeafKind.BOX
                    ? Math.copySign(row[3 + i], along[i])
                    : i == 1 ? Math.copySign(row[4], along[1]) : row[3] * along[i] / round;
            p[0] += share * row[6 + i];
            p[2] += share * row[12 + i];
        }
        return p;
    }

    private double ray(double[] o, double[] d, LeafKind kind, double[] row) {
        return SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
    }

    private static double[] plus(double[] o, double[] d, double t) {
        return new double[] {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]};
    }
}
