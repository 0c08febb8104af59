package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.exact.BeamAxis;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.ray.SpatialRay;

/** Rays that other engines answered wrong; the letters are those of the project's list of hard cases. */
class SpatialRayHardCasesTest {
    private static final double MISS = Double.POSITIVE_INFINITY;
    private final Scratch scratch = new Scratch();

    @Test
    void e1BoxSeenFromItsEdge() {
        double[] o = {-2.027535, 1.32374, -4.894639};
        double[] d = {2.506727 + 2.027535, 1.292858 - 1.32374, -2.102663 + 4.894639};
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        double[] box = box(0, 2.024, -3, 2.024, 2.024, 2.024);
        assertThat(ray(o, d, LeafKind.UPRIGHT_BOX, box) / length).isCloseTo(.00077962, within(1e-8));
        assertThat(ray(o, d, LeafKind.BOX, box)).isEqualTo(ray(o, d, LeafKind.UPRIGHT_BOX, box));
    }

    @Test
    void e2CornersAndTheSharedDiagonalOfAQuad() {
        double[] first = triangle(-1, -1, 0, -1, 1, 0, 1, 1, 0);
        double[] second = triangle(-1, -1, 0, 1, 1, 0, 1, -1, 0);
        for (double at = -1; at <= 1; at += 0.125) {
            double[] o = {at, at, 1};
            assertThat(ray(o, v(0, 0, -1), LeafKind.TRIANGLE, first)).isEqualTo(1);
            assertThat(ray(o, v(0, 0, -1), LeafKind.TRIANGLE, second)).isEqualTo(1);
        }
        assertThat(ray(v(-1, 1, 1), v(0, 0, -1), LeafKind.TRIANGLE, first)).isEqualTo(1);
        assertThat(ray(v(1, -1, 1), v(0, -0.0, -1), LeafKind.TRIANGLE, second)).isEqualTo(1);
    }

    @Test
    void e3TheDiagonalOfAQuadAimedAtFromAbove() {
        double[] o = {0, 0, 10};
        double[] d = {.30458447, .30458447, -.9024725};
        double nearest = Math.min(
                ray(o, d, LeafKind.TRIANGLE, triangle(-5, -5, 0, 5, -5, 0, 5, 5, 0)),
                ray(o, d, LeafKind.TRIANGLE, triangle(-5, -5, 0, 5, 5, 0, -5, 5, 0)));
        assertThat(nearest / VectorMath.length(d[0], d[1], d[2])).isCloseTo(10 / .9024725, within(1e-14));
    }

    @Test
    void e4StraightDownOnAHeightfield() {
        double[] triangle = triangle(5, 0, 2.63113, 9.50162, 0, 0, 5, 1, 7);
        assertThat(ray(v(5, 10, 2.63113), v(0, -1, 0), LeafKind.TRIANGLE, triangle))
                .isEqualTo(10);
        double[] row = triangle(9.50162, 0, 5, 5, 0, 5, 7, 2, 5.25);
        assertThat(ray(v(9.50162, 10, 5), v(0, -1, 0), LeafKind.TRIANGLE, row)).isEqualTo(10);
    }

    @Test
    void e5ALongTriangleMetNearItsCorner() {
        double[] triangle = triangle(90, -150, 1077, 90, -120, 1109, 120, -150, 1076);
        double[] o = {90, -150, 1077.1};
        double[] d = {-0.0, .99503726, .099503726};
        double truth = RayOracle.distance(o, d, LeafKind.TRIANGLE, triangle).doubleValue();
        assertThat(truth).isCloseTo(.10396, within(1e-5));
        assertThat(ray(o, d, LeafKind.TRIANGLE, triangle)).isCloseTo(truth, within(2 * Math.ulp(1077.1)));
    }

    @Test
    void e6AWideWall() {
        assertThat(ray(v(0, 0, 0), v(0, 0, 1), LeafKind.UPRIGHT_BOX, box(0, 0, 550, 500, 500, 500)))
                .isEqualTo(50);
    }

    /** E7 and S7: the truth and the bound are those of SpatialRayTest, seen from a million and from 12 km away. */
    @Test
    void e7S7GrazingFromFarAway() {
        double[] cylinder = {0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        assertThat(ray(v(-1e6, 0, 1), v(1, 0, 0), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isEqualTo(1e6);
        assertThat(ray(v(-1e6, 1, 1), v(1, 0, 0), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isEqualTo(1e6);
        assertThat(ray(v(-1e6, 1, Math.nextUp(1)), v(1, 0, 0), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isEqualTo(MISS);
        assertThat(ray(v(-1e6, 0, 1), v(1, 0, 0), LeafKind.SPHERE, cylinder)).isEqualTo(1e6);
        assertThat(ray(v(-12000, 0, 0.6), v(1, 0, 0), LeafKind.SPHERE, cylinder))
                .isEqualTo(12000 - 0.8);
        assertThat(ray(v(-12000, 0, 0.6), v(1, 0, 0), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isEqualTo(12000 - 0.8);
    }

    @Test
    void g1ASegmentBesideTheRay() {
        double[] segment = triangle(100, 200, 300, 400, 500, 600, 400, 500, 600);
        assertThat(ray(v(10, 20, 30), v(0, -1, 0), LeafKind.TRIANGLE, segment)).isEqualTo(MISS);
    }

    @Test
    void g3ALongSliver() {
        double[] sliver = triangle(
                -.228017807,
                -28.1085911,
                .140446782,
                -.252283931,
                173.43692,
                .093847394,
                -.252283931,
                172.43692,
                .093847394);
        double[] middle = {-.24, 70, .117};
        double[] o = {middle[0] + 3, middle[1] + 1, middle[2] + 2};
        java.math.BigDecimal truth = RayOracle.distance(o, v(-3, -1, -2), LeafKind.TRIANGLE, sliver);
        assertThat(ray(o, v(-3, -1, -2), LeafKind.TRIANGLE, sliver))
                .isEqualTo(truth == null ? MISS : truth.doubleValue());
    }

    @Test
    void g4NearlyCollinear() {
        SplittableRandom random = new SplittableRandom(4);
        int hits = 0;
        for (int i = 0; i < 500; i++) {
            double x = random.nextDouble();
            double y = random.nextDouble();
            double[] flat = triangle(0, 0, 0, x, y, 0, 3 * x, 3 * y, 0);
            double share = random.nextDouble() * 3;
            double[] o = {share * x, share * y, 1};
            boolean truth = RayOracle.distance(o, v(0, 0, -1), LeafKind.TRIANGLE, flat) != null;
            hits += truth ? 1 : 0;
            assertThat(ray(o, v(0, 0, -1), LeafKind.TRIANGLE, flat)).isEqualTo(truth ? 1 : MISS);
        }
        assertThat(hits).isBetween(1, 400);
    }

    @Test
    void g8SegmentsAndPointsAreMet() {
        double[] doubled = triangle(0, 0, 0, 2, 4, 6, 2, 4, 6);
        double[] collinear = triangle(0, 0, 0, 2, 4, 6, 1, 2, 3);
        double[] point = triangle(1, 2, 3, 1, 2, 3, 1, 2, 3);
        for (double[] flat : List.of(doubled, collinear, point)) {
            assertThat(ray(v(1, 2, -4), v(0, 0, 2), LeafKind.TRIANGLE, flat)).isEqualTo(7);
            assertThat(ray(v(1, 2, 3), v(0, 0, 2), LeafKind.TRIANGLE, flat)).isZero();
            assertThat(ray(v(1, 2, 4), v(0, 0, 2), LeafKind.TRIANGLE, flat)).isEqualTo(MISS);
            assertThat(ray(v(1, Math.nextUp(2), -4), v(0, 0, 2), LeafKind.TRIANGLE, flat))
                    .isEqualTo(MISS);
            assertThat(ray(v(-1, -2, -3), v(1, 2, 3), LeafKind.TRIANGLE, flat))
                    .isEqualTo(flat == point ? Math.sqrt(56) : Math.sqrt(14));
        }
    }

    @Test
    void i1I2I3InsideIsAlwaysZero() {
        SplittableRandom random = new SplittableRandom(1);
        double[] cylinder = {0, 0, 0, 3, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        for (int i = 0; i < 20_000; i++) {
            double[] o = {random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2)};
            assertThat(ray(o, Leaves.vector(random, 1), LeafKind.UPRIGHT_CYLINDER, cylinder))
                    .isZero();
        }
        assertThat(ray(v(0, 0, 0), v(0, 1, 0), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isZero();
        assertThat(ray(v(0, 0, 0), v(0, 0, 1), LeafKind.UPRIGHT_CYLINDER, cylinder))
                .isZero();
        assertThat(ray(v(0, .5, 0), v(0, 1, 0), LeafKind.SPHERE, cylinder)).isZero();
    }

    @Test
    void i4StartOnACorner() {
        double[] triangle = triangle(60, 0, 1206, 90, 0, 1206, 60, 30, 1230);
        assertThat(ray(v(60, 0, 1206), v(1, 2, -3), LeafKind.TRIANGLE, triangle))
                .isZero();
        assertThat(ray(v(75, 0, 1206), v(0, -1, 0), LeafKind.TRIANGLE, triangle))
                .isZero();
    }

    @Test
    void i5LeavingATurnedBox() {
        double[] box = box(0, 0, 0, 1, 1, 1);
        box[6] = 0.6;
        box[8] = 0.8;
        box[12] = -0.8;
        box[14] = 0.6;
        // The stored columns are off 0.6 and 0.8 alike, so the corner's ray is not on the box: outside along it misses.
        double[] o = {0.6 * 1.000001, 0.25, -0.8 * 1.000001};
        assertThat(ray(o, v(0.6, 0, -0.8), LeafKind.UPRIGHT_BOX, box)).isEqualTo(MISS);
        assertThat(ray(o, v(0.6, 0, -0.8), LeafKind.BOX, box)).isEqualTo(MISS);
        assertThat(ray(o, v(-0.6, 0, 0.8), LeafKind.UPRIGHT_BOX, box)).isCloseTo(1e-6, within(1e-15));
    }

    @Test
    void n1ARayInsideABordersPlane() {
        double[] box = box(64, 0, 64, 32, 1, 32);
        assertThat(ray(v(16, 0, 32), v(224, 0, 0), LeafKind.UPRIGHT_BOX, box)).isEqualTo(16);
        assertThat(ray(v(16, 0, 32), v(224, 0, -0.0), LeafKind.BOX, box)).isEqualTo(16);
        assertThat(ray(v(16, 0, Math.nextDown(32)), v(224, 0, 0), LeafKind.BOX, box))
                .isEqualTo(MISS);
    }

    @Test
    void n2APointOfABox() {
        double[] point = box(5.693442e-39, -5000, 5000, 0, 0, 0);
        double[] d = {.70710677, .70710677, 0};
        assertThat(ray(v(-5000, -5000, 5000), d, LeafKind.UPRIGHT_BOX, point)).isEqualTo(MISS);
        assertThat(ray(v(-5000, -5000, 5000), v(1, 0, 0), LeafKind.UPRIGHT_BOX, point))
                .isEqualTo(5000);
    }

    @Test
    void n3N4RaysBesideBoxes() {
        double[] box = box(907.5, 318.5, 0, 7.5, 17.5, 1);
        assertThat(ray(v(531, 301, 0), v(16, 0, 0), LeafKind.UPRIGHT_BOX, box)).isEqualTo(900 - 531);
        assertThat(ray(v(6, 0, 0), v(0, 1, 0), LeafKind.UPRIGHT_BOX, box(22, 15, 0, 1, 1, 1)))
                .isEqualTo(MISS);
    }

    @Test
    void n5N6SignedZeros() {
        double[] box = box(0, 0, 5, 1, 1, 1);
        for (double x : new double[] {0.0, -0.0}) {
            for (double y : new double[] {0.0, -0.0}) {
                for (LeafKind kind : new LeafKind[] {LeafKind.UPRIGHT_BOX, LeafKind.BOX}) {
                    assertThat(ray(v(1, -1, 0), v(x, y, 1), kind, box)).isEqualTo(4);
                    assertThat(ray(v(x, y, 0), v(x, y, 1), kind, box)).isEqualTo(4);
                    assertThat(ray(v(1, -1, 0), v(x, y, -1), kind, box)).isEqualTo(MISS);
                }
            }
        }
    }

    /** A closed sphere of triangles a million away; rays at its corners, and from inside at the middles of its edges. */
    @Test
    void s10NothingGoesThroughAClosedMesh() {
        List<double[]> mesh = sphere(1e6, 12, 24);
        int rays = 0;
        for (double[] aimed : mesh) {
            for (int i = 0; i < 3; i++) {
                int a = 3 * i;
                int b = 3 * ((i + 1) % 3);
                double[] middle = {
                    (aimed[a] + aimed[b]) / 2 - 1e6,
                    (aimed[a + 1] + aimed[b + 1]) / 2 - 1e6,
                    (aimed[a + 2] + aimed[b + 2]) / 2 - 1e6
                };
                rays += 2;
                assertThat(nearest(v(1e6, 1e6, 1e6), middle, mesh)).isFinite();
                assertThat(nearest(v(0, 0, 0), v(aimed[a], aimed[a + 1], aimed[a + 2]), mesh))
                        .isFinite();
            }
        }
        assertThat(rays).isGreaterThan(3000);
    }

    private double nearest(double[] o, double[] d, List<double[]> mesh) {
        double nearest = MISS;
        for (double[] triangle : mesh) {
            nearest = Math.min(nearest, ray(o, d, LeafKind.TRIANGLE, triangle));
        }
        return nearest;
    }

    private static List<double[]> sphere(double far, int rings, int sectors) {
        List<double[]> mesh = new ArrayList<>();
        double[][][] at = new double[rings + 1][sectors][];
        for (int i = 0; i <= rings; i++) {
            for (int k = 0; k < sectors; k++) {
                double up = Math.PI * i / rings;
                double around = 2 * Math.PI * k / sectors;
                double s = i == 0 || i == rings ? 0 : StrictMath.sin(up);
                at[i][k] =
                        v(far + s * StrictMath.cos(around), far + StrictMath.cos(up), far + s * StrictMath.sin(around));
            }
        }
        for (int i = 0; i < rings; i++) {
            for (int k = 0; k < sectors; k++) {
                double[] a = at[i][k];
                double[] b = at[i][(k + 1) % sectors];
                double[] c = at[i + 1][(k + 1) % sectors];
                double[] d = at[i + 1][k];
                mesh.add(triangle(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]));
                mesh.add(triangle(a[0], a[1], a[2], c[0], c[1], c[2], d[0], d[1], d[2]));
            }
        }
        return mesh;
    }

    private double ray(double[] o, double[] d, LeafKind kind, double[] row) {
        return SpatialRay.distance(new BeamAxis().line(o[0], o[1], o[2], d[0], d[1], d[2]), kind, row, 0, scratch.ray);
    }

    private static double[] box(double x, double y, double z, double hx, double hy, double hz) {
        return new double[] {x, y, z, hx, hy, hz, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    }

    private static double[] triangle(double... corners) {
        return java.util.Arrays.copyOf(corners, Leaf.STRIDE);
    }

    private static double[] v(double x, double y, double z) {
        return new double[] {x, y, z};
    }
}
