package robosim.geometry.narrow.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Allocated;
import robosim.geometry.narrow.Projections;
import robosim.geometry.narrow.Rows;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.PlanarOverlap;
import robosim.geometry.narrow.overlap.SpatialOverlap;

class SpatialDistanceTest {
    private static final int PAIRS = 60;
    private static final LeafKind[] KINDS = {
        LeafKind.UPRIGHT_BOX,
        LeafKind.UPRIGHT_CYLINDER,
        LeafKind.SPHERE,
        LeafKind.BOX,
        LeafKind.CYLINDER,
        LeafKind.TRIANGLE
    };
    private final Scratch scratch = new Scratch();

    @Test
    void overlapDistanceContactAndDepthAgreeWithProjections() {
        SplittableRandom random = new SplittableRandom(21);
        for (LeafKind kindA : KINDS) {
            for (LeafKind kindB : KINDS) {
                int apart = 0;
                for (int n = 0; n < PAIRS; n++) {
                    double[] a = Rows.random(kindA, random, 1.3);
                    double[] b = Rows.random(kindB, random, 1.3);
                    apart += check(kindA, a, kindB, b) ? 1 : 0;
                }
                assertThat(apart).as(kindA + " " + kindB).isBetween(PAIRS / 20, PAIRS * 98 / 100);
            }
        }
    }

    private boolean check(LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
        boolean touch = SpatialOverlap.test(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.overlap);
        double distance = SpatialDistance.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), scratch.distance);
        double twin = Projections.distance(kindA, a, kindB, b, 1000);
        assertThat(SpatialOverlap.test(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0), scratch.overlap))
                .as(pair)
                .isEqualTo(touch);
        assertThat(SpatialDistance.between(new Leaf(kindB, b, 0), new Leaf(kindA, a, 0), scratch.distance))
                .as(pair)
                .isEqualTo(distance);
        assertThat(distance == 0).as(pair).isEqualTo(touch);
        assertThat(twin).as(pair).isBetween(distance - 1e-13, distance + 2e-3);
        leaves(pair, touch, distance, kindA, a, kindB, b);
        return !touch;
    }

    /** The normal separates: moved along it by the depth (and a little) the two are apart, by less still touching. */
    private void leaves(
            String pair, boolean touch, double distance, LeafKind kindA, double[] a, LeafKind kindB, double[] b) {
        double depth = scratch.gjk.penetration().spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
        double[] contact = new double[6];
        SpatialContact.between(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0), contact, scratch.distance);
        double length = Math.sqrt(contact[3] * contact[3] + contact[4] * contact[4] + contact[5] * contact[5]);
        assertThat(length).as(pair).isCloseTo(1, within(1e-14));
        double slack = 1e-9 + distance;
        assertThat(gapTo(kindA, a, contact)).as(pair).isLessThan(slack);
        assertThat(gapTo(kindB, b, contact)).as(pair).isLessThan(slack);
        if (!touch) {
            assertThat(-depth).as(pair).isCloseTo(distance, within(1e-9));
            return;
        }
        double[] moved = shifted(kindA, a, contact, depth + 1e-9);
        assertThat(SpatialOverlap.test(new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.overlap))
                .as(pair)
                .isFalse();
        moved = shifted(kindA, a, contact, depth - 1e-6);
        assertThat(depth < 1e-6
                        || SpatialOverlap.test(new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.overlap))
                .as(pair)
                .isTrue();
        SplittableRandom random = new SplittableRandom(Arrays.hashCode(a));
        for (int n = 0; n < 40; n++) {
            // No random direction gets it out on a shorter way.
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            double r = Math.sqrt(x * x + y * y + z * z);
            moved = shifted(kindA, a, new double[] {0, 0, 0, x / r, y / r, z / r}, depth * 0.999 - 1e-9);
            assertThat(depth < 1e-6
                            || SpatialOverlap.test(new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.overlap))
                    .as(pair + " depth " + depth)
                    .isTrue();
        }
    }

    private static double gapTo(LeafKind kind, double[] row, double[] p) {
        double[] near = Projections.nearest(kind, row, p);
        return Math.sqrt((near[0] - p[0]) * (near[0] - p[0])
                + (near[1] - p[1]) * (near[1] - p[1])
                + (near[2] - p[2]) * (near[2] - p[2]));
    }

    private static double[] shifted(LeafKind kind, double[] row, double[] contact, double way) {
        double[] moved = row.clone();
        for (int k = 0; k < (kind == LeafKind.TRIANGLE ? 9 : 3); k++) {
            moved[k] += way * contact[3 + k % 3];
        }
        return moved;
    }

    @Test
    void boxesFourApartAreThreeApart() { // FCL #508 said 3.16228 and 99.00505
        double[] a = Rows.box(0, 0, 0, 0.5, 0.5, 0.5, Rows.identity());
        for (double away : new double[] {4, 100}) {
            double[] b = Rows.box(0, away, 0, 0.5, 0.5, 0.5, Rows.identity());
            assertThat(SpatialDistance.between(
                            new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0), scratch.distance))
                    .isEqualTo(away - 1);
            assertThat(SpatialDistance.between(
                            new Leaf(LeafKind.UPRIGHT_BOX, a, 0),
                            new Leaf(LeafKind.UPRIGHT_BOX, b, 0),
                            scratch.distance))
                    .isEqualTo(away - 1);
        }
    }

    @Test
    void boxIsApartFromCylinder() { // FCL #319 threw
        double[] box = Rows.box(0.8, -0.385, 0.735, 0.025, 0.195, 0.735, new double[] {0, -1, 0, 1, 0, 0, 0, 0, 1});
        double[] cylinder = Rows.cylinder(0.4, -0.4, 0.93, 0.18, 0.09, new double[] {1, 0, 0, 0, 0, -1, 0, 1, 0});
        assertThat(SpatialDistance.between(
                        new Leaf(LeafKind.BOX, box, 0), new Leaf(LeafKind.CYLINDER, cylinder, 0), scratch.distance))
                .isCloseTo(0.025, within(1e-12));
    }

    @Test
    void cylinderIsInBoxByItsRadius() { // ncollide #157 had no contact
        double[] cylinder = Rows.cylinder(10.97, 0.925, 61.02, 0.5, 0.925, Rows.identity());
        double[] box = Rows.box(11.5, 0.75, 60.5, 0.05, 0.75, 0.5, Rows.identity());
        assertThat(scratch.gjk
                        .penetration()
                        .spatial(new Leaf(LeafKind.CYLINDER, cylinder, 0), new Leaf(LeafKind.BOX, box, 0)))
                .isCloseTo(0.5 - Math.hypot(0.48, 0.02), within(1e-9));
    }

    @Test
    void cubesOverlapByATenthAlongZ() { // libccd #25: depth 0, direction NaN
        double[] a = Rows.box(0, 0, 0, 1, 1, 1, Rows.identity());
        double[] b = Rows.box(0, 0, 1.9, 1, 1, 1, Rows.identity());
        double[] contact = new double[6];
        SpatialContact.between(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0), contact, scratch.distance);
        assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isCloseTo(0.1, within(1e-15));
        assertThat(new double[] {contact[3], contact[4], contact[5]}).containsExactly(0, 0, -1);
        assertThat(contact[2]).isBetween(0.9, 1.0);
    }

    @Test
    void depthStaysWhereBothGrow() { // FCL #628: jumps from 1 to 0 when both are doubled in z
        for (double z : new double[] {0.5, 1}) {
            double[] a = Rows.box(0.5, 0.5, z, 0.5, 0.5, z, Rows.identity());
            double[] b = Rows.box(0.5, 0.9, z, 0.5, 0.1, z, Rows.identity());
            assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                    .isCloseTo(0.2, within(1e-15));
        }
    }

    @Test
    void bigAndSmallBoxTouchWhereTheSmallOneIs() { // libccd #17
        double[] big = Rows.box(0, 0, 0, 2.5, 2.5, 2.5, Rows.identity());
        double[] small = Rows.box(1, 2.59, 1, 0.1, 0.1, 0.1, Rows.identity());
        double[] contact = new double[6];
        SpatialContact.between(
                new Leaf(LeafKind.BOX, small, 0), new Leaf(LeafKind.BOX, big, 0), contact, scratch.distance);
        assertThat(contact[0]).isBetween(0.9, 1.1);
        assertThat(contact[1]).isBetween(2.49, 2.5);
        assertThat(contact[2]).isBetween(0.9, 1.1);
        assertThat(new double[] {contact[3], contact[4], contact[5]}).containsExactly(0, 1, 0);
    }

    @Test
    void allTiesAreTold() {
        double[] a = Rows.box(0, 0, 0, 1, 1, 1, Rows.identity());
        double[] b = Rows.box(2, 2, 0, 1, 1, 1, Rows.identity()); // along an edge
        assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isZero();
        assertThat(scratch.gjk.penetration().count()).isEqualTo(2);
        b[2] = 2; // at a corner
        assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isZero();
        assertThat(scratch.gjk.penetration().count()).isEqualTo(3);
        assertThat(scratch.gjk.penetration().planar(new Leaf(LeafKind.BOX, a, 0), new Leaf(LeafKind.BOX, b, 0)))
                .isZero();
        assertThat(scratch.gjk.penetration().count()).isEqualTo(2);
        double[] ball = Rows.sphere(0, 0, 0, 0.5); // in the middle
        assertThat(scratch.gjk.penetration().spatial(new Leaf(LeafKind.SPHERE, ball, 0), new Leaf(LeafKind.BOX, a, 0)))
                .isEqualTo(1.5);
        assertThat(scratch.gjk.penetration().count()).isEqualTo(6);
    }

    @Test
    void standingCylindersPushEachOtherAlongTheirCentres() {
        double[] a = Rows.cylinder(0, 0, 0, 3, 5, Rows.identity());
        double[] b = Rows.cylinder(3, 1, 4, 2, 5, Rows.identity());
        assertThat(scratch.gjk
                        .penetration()
                        .spatial(new Leaf(LeafKind.UPRIGHT_CYLINDER, a, 0), new Leaf(LeafKind.UPRIGHT_CYLINDER, b, 0)))
                .isCloseTo(0, within(1e-14));
        assertThat(scratch.gjk.penetration().count()).isEqualTo(1);
        assertThat(scratch.gjk.penetration().nx(0)).isEqualTo(-0.6);
        assertThat(scratch.gjk.penetration().ny(0)).isZero();
        assertThat(scratch.gjk.penetration().nz(0)).isEqualTo(-0.8);
    }

    /** In the plane too no direction of a ring gets a out sooner, and the one told does. */
    @Test
    void planarDepthsAreTheLeast() {
        SplittableRandom random = new SplittableRandom(23);
        for (LeafKind kindA : KINDS) {
            for (LeafKind kindB : KINDS) {
                int deep = 0;
                for (int n = 0; n < 60; n++) {
                    double[] a = Rows.random(kindA, random, 1);
                    double[] b = Rows.random(kindB, random, 1);
                    double depth = scratch.gjk.penetration().planar(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
                    if (depth < 1e-6) {
                        continue;
                    }
                    deep++;
                    String pair = kindA + " " + Arrays.toString(a) + " with " + kindB + " " + Arrays.toString(b);
                    double[] way = {
                        0,
                        0,
                        0,
                        scratch.gjk.penetration().nx(0),
                        0,
                        scratch.gjk.penetration().nz(0)
                    };
                    double[] moved = shifted(kindA, a, way, depth + 1e-9);
                    assertThat(PlanarOverlap.test(new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.overlap))
                            .as(pair)
                            .isFalse();
                    for (int k = 0; k < 64; k++) {
                        double t = k * Math.PI / 32;
                        way = new double[] {0, 0, 0, Math.cos(t), 0, Math.sin(t)};
                        moved = shifted(kindA, a, way, depth * 0.9999);
                        assertThat(PlanarOverlap.test(
                                        new Leaf(kindA, moved, 0), new Leaf(kindB, b, 0), scratch.overlap))
                                .as(pair)
                                .isTrue();
                    }
                }
                assertThat(deep).as(kindA + " " + kindB).isGreaterThan(6);
            }
        }
    }

    @Test
    void nothingIsAllocated() {
        SplittableRandom random = new SplittableRandom(22);
        double[][] rows = new double[KINDS.length * 2][];
        for (int k = 0; k < rows.length; k++) {
            rows[k] = Rows.random(KINDS[k / 2], random, 1.5);
        }
        double[] contact = new double[6];
        double[] sum = new double[1];
        Leaf one = new Leaf();
        Leaf two = new Leaf();
        int questions = 20 * rows.length * rows.length;
        long allocated = Allocated.everyTime(() -> {
            for (int n = 0; n < questions; n++) {
                int k = n % rows.length;
                int m = n / rows.length % rows.length;
                if (k / 2 == m / 2) {
                    continue; // a leaf with itself may need exact numbers
                }
                one.set(KINDS[k / 2], rows[k], 0);
                two.set(KINDS[m / 2], rows[m], 0);
                sum[0] += SpatialDistance.between(one, two, scratch.distance);
                SpatialContact.between(one, two, contact, scratch.distance);
                sum[0] += contact[0];
            }
        });
        assertThat(sum[0]).isNotZero();
        assertThat(allocated).isLessThan(questions);
    }
}
