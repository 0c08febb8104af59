package robosim.geometry.narrow.overlap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.sat.ExactCapsule;
import robosim.geometry.narrow.sat.ExactCylinder;
import robosim.geometry.narrow.sat.ExactPolytope;

class SpatialOverlapTest {
    private final Scratch scratch = new Scratch();

    @Test
    void trianglesInAllOrdersOfCorners() { // axom #152: 6 of 36 orders say no
        double[] a = {76.648, 54.6752, 15.0012, 76.648, 54.6752, 14.5542, 76.582, 54.6752, 14.7879};
        double[] b = {76.6252, 54.6752, 14.892, 76.582, 54.6752, 14.7879, 76.5617, 54.6752, 14.7929};
        trianglesInAllOrders(a, b, true);
    }

    @Test
    void trianglesThatThePublishedTestMisses() { // LokiResearch #3
        trianglesInAllOrders(
                new double[] {-1, 0, 0, 2, 0, -2, 2, 0, 2},
                new double[] {.551, 0, -.796, 1.224, 0, .326, 3.469, 0, 1},
                true);
        trianglesInAllOrders(new double[] {0, 0, 0, 0, 0, 8, 8, 0, 0}, new double[] {2, 0, 2, 1, 0, 4, 9, 0, 0}, true);
    }

    @Test
    void trianglesOnNearlyOnePlane() { // Geogram #10: assertion
        trianglesInAllOrders(
                new double[] {1898.68, 775, 1158.48, 2000, 775, 1166.7, 1898.68, 675, 1148.6},
                new double[] {1966.41, 675, 1163.79, 1971.63, 675, 1166.95, 1967.56, 684.554, 1166.67},
                false);
    }

    private void trianglesInAllOrders(double[] a, double[] b, boolean truth) {
        int[][] orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (int[] p : orders) {
            for (int[] q : orders) {
                both(LeafKind.TRIANGLE, ordered(a, p), LeafKind.TRIANGLE, ordered(b, q), truth);
            }
        }
    }

    private static double[] ordered(double[] corners, int[] order) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 3; k++) {
            System.arraycopy(corners, 3 * order[k], row, 3 * k, 3);
        }
        return row;
    }

    @Test
    void nearlyParallelBeamsHalfAUnitApart() { // ifc-lite PR #2536: clash of 55 mm
        for (double tilt : new double[] {1e-3, 1e-8, 1e-12, 1e-16}) {
            double[] a = Rows.box(0, 0, 0, 20, 0.1, 0.1, Rows.yaw(0.3));
            double[] turned = Rows.yaw(0.3 + tilt);
            turned[1] = tilt; // not quite upright either
            double[] b = Rows.box(0, 0.7, 0, 20, 0.1, 0.1, turned);
            both(LeafKind.BOX, a, LeafKind.BOX, b, false);
            b[1] = 0.2 - 1e-9;
            both(LeafKind.BOX, a, LeafKind.BOX, b, true);
        }
    }

    @Test
    void boxesThatEndedOutsideThePolytope() { // FCL #399 and #493: exceptions
        double c = 0.099432387353076273628;
        double s = 0.99504432079443971837;
        double[] first = {-c, s, 0, -s, -c, 0, 0, 0, 1};
        double[] a = Rows.box(
                0.29526406526565551758,
                -0.013230856508016586304,
                0,
                0.23768037557601928711 / 2,
                0.15702305734157562256 / 2,
                0.125,
                first);
        c = 0.99506598442099225554;
        s = 0.099215354901756730444;
        double[] b = Rows.box(
                0.22759585694545214629,
                0.14974093549228112421,
                0,
                0.010000000000000000208 / 2,
                0.78165709972381591797 / 2,
                0.125,
                new double[] {c, s, 0, -s, c, 0, 0, 0, 1});
        both(LeafKind.BOX, a, LeafKind.BOX, b, true);
        assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isBetween(3.38e-5, 3.382e-5);
        double[] r = {
            0.96193976625564348026,
            0.15401279915737359216,
            0.22572537250328919556,
            -0.19134171618254486313,
            0.96936494951283913579,
            0.15401279915737359216,
            -0.19509032201612822033,
            -0.19134171618254486313,
            0.96193976625564348026
        };
        a = Rows.box(2.0770063995786869349, 0.48468247475641951239, 1.1543291419087275962, 0.25, 0.25, 0.25, r);
        b = Rows.box(2, 0, 1.25, 0.25, 0.25, 0.25, r);
        both(LeafKind.BOX, a, LeafKind.BOX, b, true); // by 3.8e-17
    }

    @Test
    void boxesApartByLessThanAnUlp() { // FCL #495: one solver says touching, the other apart
        double[] r = {
            0.94096063217417758029,
            0.29296840037289501035,
            0.16959541586174811667,
            -0.23569836841299879326,
            0.92661523595848427348,
            -0.29296840037289506586,
            -0.2429801799032638987,
            0.23569836841299884878,
            0.94096063217417758029
        };
        double[] a =
                Rows.box(0.073242100093223821977, 0.2316538089896212349, 1.3089245921032497399, 0.125, 0.125, 0.125, r);
        double[] b = Rows.box(0, 0, 1.25, 0.125, 0.125, 0.125, r);
        both(LeafKind.BOX, a, LeafKind.BOX, b, false); // by 1.81e-16
        assertThat(Rows.touch(LeafKind.BOX, a, LeafKind.BOX, b)).isFalse();
    }

    @Test
    void turnedBoxesCornerOnCorner() { // MathGeoLib #12: not touching even with 1e-7
        double s = .86602540378444;
        double[] a = Rows.box(0.5, 0.5, 0.5, 0.5, 0.5, 0.5, Rows.identity());
        double[] r = {0, 0, 1, -.5, s, 0, -s, -.5, 0};
        double[] b = Rows.box(1, -.5 + s, -s - .5, 1, 1, 1, r);
        both(LeafKind.BOX, a, LeafKind.BOX, b, Rows.touch(LeafKind.BOX, a, LeafKind.BOX, b));
        b[2] = Math.nextUp(b[2] + 1e-15);
        both(LeafKind.BOX, a, LeafKind.BOX, b, Rows.touch(LeafKind.BOX, a, LeafKind.BOX, b));
    }

    @Test
    void exactlyParallelBoxesHaveNoAxisOfNoise() { // naver/anny #24
        double[] r = Rows.rotation(new SplittableRandom(5));
        double[] a = Rows.box(0, 0, 0, 0.125, 0.125, 0.125, r);
        double[] b = Rows.box(0.0732421, 0.2316538, 0.0589246, 0.125, 0.125, 0.125, r); // FCL #495's offset
        both(LeafKind.BOX, a, LeafKind.BOX, b, Rows.touch(LeafKind.BOX, a, LeafKind.BOX, b));
        both(LeafKind.BOX, a, LeafKind.BOX, a.clone(), true);
    }

    @Test
    void aBoxInsideASurfaceTouchesNoneOfIt() { // FCL #492: a matter of meaning; a triangle is a surface
        double[] triangle = Rows.triangle(-5, 2, -5, 5, 2, -5, 0, 2, 9);
        both(LeafKind.BOX, Rows.box(0, 0, 0, 1, 1, 1, Rows.identity()), LeafKind.TRIANGLE, triangle, false);
        both(LeafKind.BOX, Rows.box(0, 1, 0, 1, 1, 1, Rows.identity()), LeafKind.TRIANGLE, triangle, true);
    }

    @Test
    void whatIsDeepInsideASolidCollides() { // panda3d #1335, mujoco #1800
        double[] box = Rows.box(0, 0, 0, 5, 5, 5, Rows.identity());
        double[] r = Rows.rotation(new SplittableRandom(6));
        both(LeafKind.BOX, box, LeafKind.SPHERE, Rows.sphere(0.1, 0.2, 0.3, 0.01), true);
        both(LeafKind.BOX, box, LeafKind.SPHERE, Rows.sphere(0.1, 0.2, 0.3, 0), true);
        both(LeafKind.BOX, box, LeafKind.CYLINDER, Rows.cylinder(0.1, 0.2, 0.3, 0.01, 0.02, r), true);
        both(LeafKind.BOX, box, LeafKind.BOX, Rows.box(1, 1, 1, 0.65, 0.48, 0.04, r), true);
        both(
                LeafKind.CYLINDER,
                Rows.cylinder(0, 0, 0, 5, 5, r),
                LeafKind.TRIANGLE,
                Rows.triangle(1, 0, 0, 0, 1, 0, 0, 0, 1),
                true);
    }

    @Test
    void aBallBesideAThinTriangleMisses() { // Jolt #886
        double[] triangle = Rows.triangle(
                14.5536213,
                10.5973721,
                -.0060005188,
                14.5536213,
                10.5969315,
                -3.18638134,
                14.5536213,
                10.5969315,
                -5.18637228);
        both(LeafKind.TRIANGLE, triangle, LeafKind.SPHERE, Rows.sphere(14.831459, 8.1905508, -4.30825043, .2), false);
    }

    /** Spheres on all features of a box and a triangle at Pythagorean distances, and an ulp less. */
    @Test
    void spheresTouchExactly() {
        double[] box = Rows.box(0, 0, 0, 1, 2, 3, Rows.identity());
        touches(LeafKind.BOX, box, Rows.sphere(5, 0.5, 0.25, 4));
        touches(LeafKind.BOX, box, Rows.sphere(4, 6, 1, 5)); // 3, 4 from an edge
        touches(LeafKind.BOX, box, Rows.sphere(2, 4, 5, 3)); // 1, 2, 2 from a corner
        double[] triangle = Rows.triangle(0, 0, 0, 4, 0, 0, 0, 0, 4);
        touches(LeafKind.TRIANGLE, triangle, Rows.sphere(1, 2, 1, 2));
        touches(LeafKind.TRIANGLE, triangle, Rows.sphere(2, 4, -3, 5));
        touches(LeafKind.TRIANGLE, triangle, Rows.sphere(-1, 2, -2, 3));
        double[] upright = Rows.cylinder(0, 0, 0, 5, 2, Rows.identity());
        touches(LeafKind.UPRIGHT_CYLINDER, upright, Rows.sphere(6, 0.5, 8, 5)); // beside: 10 from the axis
        touches(LeafKind.UPRIGHT_CYLINDER, upright, Rows.sphere(1, 5, 1, 3)); // above
        touches(LeafKind.UPRIGHT_CYLINDER, upright, Rows.sphere(8, 6, 0, 5)); // 3, 4 from the rim
        touches(LeafKind.SPHERE, Rows.sphere(0, 0, 0, 2), Rows.sphere(2, 4, 4, 4));
    }

    private void touches(LeafKind kind, double[] row, double[] sphere) {
        both(kind, row, LeafKind.SPHERE, sphere, true);
        double[] less = sphere.clone();
        less[3] = Math.nextDown(less[3]);
        both(kind, row, LeafKind.SPHERE, less, false);
    }

    /** An axis (3, 4, 0)/8 is stored exactly, and so are touching places beside it: (-4, 3, 0) t is 5 t away. */
    @Test
    void turnedCylindersTouchExactly() {
        double[] r = {0.5, 0.375, 0, -0.375, 0.5, 0, 0, 0, 0.625};
        double[] cylinder = Rows.cylinder(0, 0, 0, 5, 8, r); // from -(3, 4, 0) to (3, 4, 0)
        touches(LeafKind.CYLINDER, cylinder, Rows.sphere(-8, 6, 0, 5));
        touches(LeafKind.CYLINDER, cylinder, Rows.sphere(9, 12, 0, 10));
        // A triangle's corner, its edge and its side at (-4, 3, 0), each just touching or drawn off by the least step.
        tangent(cylinder, Rows.triangle(-4, 3, 0, -8, 6, 1, -8, 6, -1));
        tangent(cylinder, Rows.triangle(-4, 3, 4, -4, 3, -4, -8, 6, 0));
        tangent(cylinder, Rows.triangle(-7, -1, 7, -7, -1, -7, -1, 7, 0));
        // At the cap's middle, and a box with a corner on the side.
        tangent(cylinder, Rows.triangle(3, 4, 0, 6, 9, 1, 6, 9, -1));
        double[] box = Rows.box(-5, 4, 0, 1, 1, 1, Rows.identity());
        both(LeafKind.CYLINDER, cylinder, LeafKind.BOX, box, true);
        box[0] = Math.nextDown(box[0]);
        both(LeafKind.CYLINDER, cylinder, LeafKind.BOX, box, false);
    }

    private void tangent(double[] cylinder, double[] triangle) {
        both(LeafKind.CYLINDER, cylinder, LeafKind.TRIANGLE, triangle, true);
        double[] off = triangle.clone();
        double away = triangle[0] + triangle[3] + triangle[6] < 0 ? -0x1p-50 : 0x1p-50;
        for (int k = 0; k < 9; k += 3) {
            off[k] += away;
        }
        both(LeafKind.CYLINDER, cylinder, LeafKind.TRIANGLE, off, false);
    }

    /** Exact numbers and GJK agree wherever the latter is certain; random pairs almost always are. */
    @Test
    void exactNumbersAgreeWithCertainOnes() {
        SplittableRandom random = new SplittableRandom(31);
        int certain = 0;
        int hits = 0;
        int asked = 0;
        for (int n = 0; n < 300; n++) {
            for (LeafKind kind : new LeafKind[] {LeafKind.BOX, LeafKind.TRIANGLE}) {
                double[] cylinder = Rows.random(LeafKind.CYLINDER, random, 1);
                double[] b = Rows.random(kind, random, 1);
                double[] ball = Rows.random(LeafKind.SPHERE, random, 1);
                String pair =
                        Arrays.toString(cylinder) + " with " + kind + " " + Arrays.toString(b) + Arrays.toString(ball);
                ExactPolytope polytope = new ExactPolytope(new Leaf(kind, b, 0));
                ExactCylinder exact = new ExactCylinder(new Leaf(LeafKind.CYLINDER, cylinder, 0));
                ExactCapsule sphere = new ExactCapsule(new Leaf(LeafKind.SPHERE, ball, 0));
                boolean[] truths = {
                    exact.touchesPolytope(polytope), sphere.touchesPolytope(polytope), sphere.sphereTouches(exact)
                };
                for (int k = 0; k < 3; k++) {
                    asked++;
                    hits += truths[k] ? 1 : 0;
                    scratch.gjk.pair.spatial(
                            k == 0 ? new Leaf(LeafKind.CYLINDER, cylinder, 0) : new Leaf(LeafKind.SPHERE, ball, 0),
                            k == 2 ? new Leaf(LeafKind.CYLINDER, cylinder, 0) : new Leaf(kind, b, 0));
                    if (scratch.gjk.pair.lower() > 0 || scratch.gjk.pair.isDeep()) {
                        certain++;
                        assertThat(scratch.gjk.pair.isDeep()).as(pair + k).isEqualTo(truths[k]);
                    }
                }
            }
        }
        assertThat(hits).isBetween(asked * 3 / 10, asked * 8 / 10);
        assertThat(certain).isGreaterThan(asked * 95 / 100);
    }

    /** An octagon whose slanting sides cut nothing off is a box: it meets all that the box meets, to the last bit. */
    @Test
    void prismsMissNoPolytope() {
        SplittableRandom random = new SplittableRandom(32);
        int hits = 0;
        int near = 0;
        int apart = 0;
        int count = 2000;
        for (int n = 0; n < count; n++) {
            LeafKind kind = n % 2 == 0 ? LeafKind.BOX : LeafKind.TRIANGLE;
            double[] other = Rows.random(kind, random, 1);
            for (int k = 0; k < 9; k++) { // on a grid, so that the box's corner is a double too
                other[k] = Math.rint(other[k] * 0x1p20) * 0x1p-20;
                other[k + 6] = kind == LeafKind.BOX ? Math.rint(other[k + 6] * 0x1p20) * 0x1p-20 : other[k + 6];
            }
            double[] box = Rows.box(0, 0, 0, 0.5, 0.25, 0.75, Rows.identity());
            double[] corner = kind == LeafKind.TRIANGLE ? other : ownCorner(other);
            for (int k = 0; k < 3; k++) { // the two meet at a corner, or nearly
                box[k] = Math.rint(corner[k] * 0x1p48) * 0x1p-48 + (random.nextBoolean() ? box[3 + k] : -box[3 + k]);
            }
            box[n % 3] += random.nextInt(-1, 2) * 0x1p-48;
            boolean truth = SpatialOverlap.test(
                    new Leaf(LeafKind.UPRIGHT_BOX, box, 0), new Leaf(kind, other, 0), scratch.overlap);
            scratch.gjk.pair.spatial(new Leaf(LeafKind.UPRIGHT_BOX, box, 0), new Leaf(kind, other, 0));
            near += scratch.gjk.pair.lower() > 0 || scratch.gjk.pair.isDeep() ? 0 : 1;
            if (truth) {
                both(LeafKind.PRISM, prism(box), kind, other, true);
            }
            box[n % 3] += box[n % 3] > corner[n % 3] ? 0x1p-20 : -0x1p-20;
            if (!SpatialOverlap.test(
                    new Leaf(LeafKind.UPRIGHT_BOX, box, 0), new Leaf(kind, other, 0), scratch.overlap)) {
                both(LeafKind.PRISM, prism(box), kind, other, false);
                apart++;
            }
            hits += truth ? 1 : 0;
        }
        assertThat(hits).isBetween(count / 10, count * 9 / 10);
        assertThat(near).isGreaterThan(count / 10);
        assertThat(apart).isGreaterThan(count / 10);
    }

    private static double[] ownCorner(double[] box) {
        double[] corner = new double[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = box[k];
            for (int m = 0; m < 3; m++) {
                corner[k] += box[3 + m] * box[6 + 3 * k + m];
            }
        }
        return corner;
    }

    private static double[] prism(double[] box) {
        double[] row = new double[Leaf.STRIDE];
        for (int k = 0; k < 2; k++) {
            double side = k == 0 ? -1 : 1;
            row[k] = box[0] + side * box[3];
            row[2 + k] = box[2] + side * box[5];
            row[4 + k] = side * 100;
            row[6 + k] = side * 100;
            row[8 + k] = box[1] + side * box[4];
        }
        return row;
    }

    private void both(LeafKind kindA, double[] a, LeafKind kindB, double[] b, boolean truth) {
        String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
        assertThat(SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap))
                .as(pair)
                .isEqualTo(truth);
        assertThat(SpatialOverlap.test(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0), scratch.overlap))
                .as(pair + " swapped")
                .isEqualTo(truth);
    }
}
