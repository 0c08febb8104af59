package robosim.geometry.narrow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.lang.management.ManagementFactory;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.PivotTurn;
import robosim.geometry.narrow.sweep.PlanarSweep;
import robosim.geometry.narrow.sweep.SpatialSweep;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.WayTruth;

/** Motions that other engines got wrong, and those at the edges of the contract. */
class HardMovesTest {
    private static final double FREE = Double.POSITIVE_INFINITY;

    private static final LeafKind[] EXACT = Arrays.stream(Leaves.KINDS)
            .filter(kind -> kind != LeafKind.CYLINDER && !kind.isEnclosure())
            .toArray(LeafKind[]::new);

    private final Scratch scratch = new Scratch();
    private final Leaf mover = new Leaf();
    private final Leaf rest = new Leaf();
    private final PivotTurn turn = new PivotTurn();
    private final SplittableRandom random = new SplittableRandom(20055);

    private double planar(LeafKind kindA, double[] a, double dx, double dz, LeafKind kindB, double[] b) {
        return PlanarSweep.translation(mover.set(kindA, a, 0), dx, 0, dz, rest.set(kindB, b, 0), scratch.sweep);
    }

    private double spatial(LeafKind kindA, double[] a, double dx, double dy, double dz, LeafKind kindB, double[] b) {
        return SpatialSweep.translation(mover.set(kindA, a, 0), dx, dy, dz, rest.set(kindB, b, 0), scratch.sweep);
    }

    private double turn(LeafKind kindA, double[] a, double px, double pz, double degrees, LeafKind kindB, double[] b) {
        return PlanarSweep.turn(
                mover.set(kindA, a, 0),
                turn.about(px, 0, pz).by(0, 1, 0, degrees),
                rest.set(kindB, b, 0),
                scratch.sweep);
    }

    @Test
    void nothingTunnelsThroughAThinWall() {
        double[] wall = SweepRows.uprightBox(0, 0, 0, 0, 5, 10, 0);
        for (double far = 1; far < 0x1p60; far *= 8) {
            double[] disc = SweepRows.disc(-far, 0, 0.3, 0x1p-20, 1);
            double[] box = SweepRows.uprightBox(-far, 0, 0.3, 0x1p-20, 1, 0x1p-20, 0);
            double[] dot = SweepRows.triangle(-far, 0, 0, -far, 0, 0, -far, 0, 0);
            double[] leaning = SweepRows.cylinder(-far, 0, 0, 0x1p-20, 0x1p-20, 0, 30, 0);
            assertThat(planar(LeafKind.UPRIGHT_CYLINDER, disc, 2 * far, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
            assertThat(planar(LeafKind.UPRIGHT_BOX, box, 2 * far, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
            assertThat(spatial(LeafKind.UPRIGHT_BOX, box, 2 * far, 0, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
            assertThat(spatial(LeafKind.UPRIGHT_CYLINDER, disc, 2 * far, 0, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
            assertThat(spatial(LeafKind.SPHERE, disc, 2 * far, 0, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
            assertThat(spatial(LeafKind.TRIANGLE, dot, 2 * far, 0, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isEqualTo(0.5);
            assertThat(planar(LeafKind.TRIANGLE, dot, 2 * far, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isEqualTo(0.5);
            assertThat(spatial(LeafKind.CYLINDER, leaning, 2 * far, 0, 0, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.49, 0.5);
        }
    }

    @Test
    void touchingAtTheEndIsAHit() {
        double[] box = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, SweepRows.disc(-4, 0, 0, 1, 1), 2, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(1);
        assertThat(planar(
                        LeafKind.UPRIGHT_BOX,
                        SweepRows.uprightBox(-4, 0, 0, 1, 1, 1, 0),
                        2,
                        0,
                        LeafKind.UPRIGHT_BOX,
                        box))
                .isEqualTo(1);
        assertThat(planar(
                        LeafKind.UPRIGHT_CYLINDER,
                        SweepRows.disc(-4, 0, 0, 1, 1),
                        Math.nextDown(2.0),
                        0,
                        LeafKind.UPRIGHT_BOX,
                        box))
                .isEqualTo(FREE);
        // Corner to rim: 3, 4, 5.
        assertThat(planar(
                        LeafKind.UPRIGHT_CYLINDER,
                        SweepRows.disc(-4 - 8, 0, -5, 5, 1),
                        8,
                        0,
                        LeafKind.UPRIGHT_BOX,
                        box))
                .isEqualTo(1);
        assertThat(spatial(
                        LeafKind.UPRIGHT_CYLINDER, SweepRows.disc(0, 4, 0, 1, 1), 0, -2, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(1);
        assertThat(spatial(
                        LeafKind.UPRIGHT_CYLINDER,
                        SweepRows.disc(0, 4, 0, 1, 1),
                        0,
                        -1.75,
                        0,
                        LeafKind.UPRIGHT_BOX,
                        box))
                .isEqualTo(FREE);
    }

    @Test
    void grazingInPassingIsAHitAndSlidingFromContactIsNot() {
        double[] box = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        double[] disc = SweepRows.disc(-5, 0, 2, 1, 1);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, disc, 10, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(Math.nextDown(0.4)); // the double 0.4 is above 2/5
        assertThat(planar(
                        LeafKind.UPRIGHT_CYLINDER,
                        SweepRows.disc(-5, 0, Math.nextUp(2.0), 1, 1),
                        10,
                        0,
                        LeafKind.UPRIGHT_BOX,
                        box))
                .isEqualTo(FREE);
        double[] touching = SweepRows.disc(0.5, 0, 2, 1, 1);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, touching, 3, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, touching, 0, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, touching, 3, 1e-300, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_CYLINDER, touching, 3, -1e-300, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(0);
        double[] square = SweepRows.uprightBox(2, 0, 0.5, 1, 1, 1, 0);
        assertThat(planar(LeafKind.UPRIGHT_BOX, square, 0, 3, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_BOX, square, -1e-300, 3, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(0);
        assertThat(planar(LeafKind.UPRIGHT_BOX, square, 1e-300, 3, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        // Corner on corner: two least ways out, only against both is into.
        double[] corner = SweepRows.uprightBox(2, 0, 2, 1, 1, 1, 0);
        assertThat(planar(LeafKind.UPRIGHT_BOX, corner, -1, 1, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_BOX, corner, -1, 0, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        assertThat(planar(LeafKind.UPRIGHT_BOX, corner, -1, -1, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(0);
    }

    @Test
    void standingOnAFloorHindersNoLevelMotion() {
        double[] floor = SweepRows.uprightBox(0, -1, 0, 50, 1, 50, 30);
        double[] robot = SweepRows.disc(3, 0.5, 4, 0.3, 0.5);
        double[] cart = SweepRows.uprightBox(3, 0.5, 4, 0.3, 0.5, 0.2, 12);
        for (int k = 0; k < 100; k++) {
            double dx = random.nextDouble(-9, 9);
            double dz = random.nextDouble(-9, 9);
            double degrees = random.nextDouble(-900, 900);
            assertThat(spatial(LeafKind.UPRIGHT_CYLINDER, robot, dx, 0, dz, LeafKind.UPRIGHT_BOX, floor))
                    .isEqualTo(FREE);
            assertThat(spatial(LeafKind.UPRIGHT_BOX, cart, dx, 0, dz, LeafKind.UPRIGHT_BOX, floor))
                    .isEqualTo(FREE);
            assertThat(spatial(LeafKind.UPRIGHT_CYLINDER, robot, dx, 0.1, dz, LeafKind.UPRIGHT_BOX, floor))
                    .isEqualTo(FREE);
            assertThat(spatial(LeafKind.UPRIGHT_BOX, cart, dx, -0.1, dz, LeafKind.UPRIGHT_BOX, floor))
                    .isEqualTo(0);
            assertThat(spatial(LeafKind.UPRIGHT_CYLINDER, robot, dx, -1e-9, dz, LeafKind.UPRIGHT_BOX, floor))
                    .isEqualTo(0);
            assertThat(SpatialSweep.turn(
                            new Leaf(LeafKind.UPRIGHT_BOX, cart, 0),
                            new PivotTurn().about(3, 0.5, 4).by(0, 1, 0, degrees),
                            new Leaf(LeafKind.UPRIGHT_BOX, floor, 0),
                            scratch.sweep))
                    .isEqualTo(FREE);
        }
    }

    @Test
    void noConvexPieceTrapsAMover() {
        for (int k = 0; k < 400; k++) {
            LeafKind kindA = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            LeafKind kindB = Leaves.KINDS[random.nextInt(Leaves.KINDS.length)];
            double[] a = SweepRows.random(kindA, 0.3, random);
            double[] b = SweepRows.random(kindB, 0.3, random);
            int free = 0;
            int into = 0;
            for (int m = 0; m < 26; m++) {
                double[] d = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
                double time = spatial(kindA, a, d[0], d[1], d[2], kindB, b);
                double back = spatial(kindA, a, -d[0], -d[1], -d[2], kindB, b);
                if (time != 0 && back != 0 && time <= 1) {
                    free = 1; // apart to begin with
                    break;
                }
                free += time == FREE ? 1 : 0;
                into += time == 0 && back == 0 ? 1 : 0;
            }
            assertThat(free).as("kinds %s, %s", kindA, kindB).isPositive();
            assertThat(into).as("kinds %s, %s", kindA, kindB).isZero();
        }
    }

    @Test
    void parryCase180SquareFallsOnASegment() {
        double[] square = SweepRows.uprightBox(15.689465, 0, 54.00709, 2, 1, 2, 0);
        double[] ground = SweepRows.triangle(1, 0, 1, 124, 0, 1, 124, 0, 1);
        double time = planar(LeafKind.UPRIGHT_BOX, square, 0.0081385 * 64, -0.999966 * 64, LeafKind.TRIANGLE, ground);
        assertThat(time * 64).isBetween(51.0088, 51.0089);
    }

    @Test
    void ncollideCase4BallAtABlock() {
        double[] ball = SweepRows.disc(784.470154 - 1e3, 0, 0, 15, 1);
        double[] block = SweepRows.uprightBox(820 - 1e3, 0, 0, 20, 1, 20, 0);
        double time = planar(LeafKind.SPHERE, ball, 0.630261 * 100, 0, LeafKind.UPRIGHT_BOX, block);
        assertThat(time * 100).isBetween(0.840676, 0.840679);
    }

    @Test
    void box2dCase115ManyTurnsAreNotReduced() {
        double[] post = SweepRows.disc(3, 0, 0, 0.5, 1);
        double[] arm = SweepRows.uprightBox(0, 0, 0, 4, 1, 0.1, 90);
        for (double turns = 1; turns < 1e9; turns *= 10) {
            assertThat(turn(LeafKind.UPRIGHT_BOX, arm, 0, 0, 360 * turns, LeafKind.UPRIGHT_CYLINDER, post))
                    .isPositive()
                    .isLessThan(0.25 / turns);
            assertThat(turn(LeafKind.UPRIGHT_BOX, arm, 0, 0, -360 * turns, LeafKind.UPRIGHT_CYLINDER, post))
                    .isPositive()
                    .isLessThan(0.25 / turns);
            assertThat(turn(
                            LeafKind.UPRIGHT_BOX,
                            arm,
                            0,
                            0,
                            360 * turns,
                            LeafKind.UPRIGHT_CYLINDER,
                            SweepRows.disc(9, 0, 0, 0.5, 1)))
                    .isEqualTo(FREE);
        }
    }

    /** A box as thin as 3e-11: which way its short side goes is known to 1e-6 only, beside a disc of 0.7. */
    @Test
    void aThinBoxThatStopsShortOfADiscIsFree() {
        double[] box = new double[Leaf.STRIDE];
        double[] numbers = {
            -0.4520917945561488,
            0,
            0.9190414800219684,
            1.723272222690831E-11,
            1,
            0.9587533202454728,
            0.7944327876230206,
            0,
            -0.6073520774225742,
            0,
            1,
            0,
            0.6073520774225742,
            0,
            0.7944327876230206
        };
        System.arraycopy(numbers, 0, box, 0, numbers.length);
        double[] disc = SweepRows.disc(-1.8648802081807432, 0, 2.2666946041694307, 0.7004127975969017, 1);
        double dx = -0.40508976883743814;
        double dz = 0.029557661789241907;
        assertThat(PlanarTwin.exactly(
                        n -> WayTruth.planar(n, Form.UPRIGHT_BOX, box, dx, dz, Form.UPRIGHT_CYLINDER, disc)))
                .isFalse();
        assertThat(planar(LeafKind.UPRIGHT_BOX, box, dx, dz, LeafKind.UPRIGHT_CYLINDER, disc))
                .isEqualTo(FREE);
    }

    @Test
    void tinyTurnsAreSeen() {
        double[] arm = SweepRows.uprightBox(0, 0, 0, 1, 1, 0.25, 0);
        for (double gap = 0x1p-10; gap > 0x1p-40; gap /= 4) {
            // The arm's far corner goes down by about its length times the angle.
            double[] wall = SweepRows.uprightBox(0, 0, 1.25 + gap, 9, 1, 1, 0);
            double degrees = -Math.toDegrees(gap);
            assertThat(turn(LeafKind.UPRIGHT_BOX, arm, 0, 0, 0.9 * degrees, LeafKind.UPRIGHT_BOX, wall))
                    .isEqualTo(FREE);
            assertThat(turn(LeafKind.UPRIGHT_BOX, arm, 0, 0, -0.9 * degrees, LeafKind.UPRIGHT_BOX, wall))
                    .isEqualTo(FREE);
            assertThat(turn(LeafKind.UPRIGHT_BOX, arm, 0, 0, 1.1 * degrees, LeafKind.UPRIGHT_BOX, wall))
                    .isBetween(0.85, 0.95);
        }
    }

    @Test
    void aTurnFromContactIsJudgedByWhereItGoes() {
        double[] wall = SweepRows.uprightBox(0, 0, 2, 9, 1, 1, 0);
        // Flush with the wall: one corner goes in, whichever way.
        double[] flush = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        assertThat(turn(LeafKind.UPRIGHT_BOX, flush, 0, 0, 1, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
        assertThat(turn(LeafKind.UPRIGHT_BOX, flush, 0, 0, -1, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
        // Hinged at the corner that touches: free towards the open side.
        double[] hinged = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        assertThat(turn(LeafKind.UPRIGHT_BOX, hinged, 1, 1, 80, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
        assertThat(turn(LeafKind.UPRIGHT_BOX, hinged, 1, 1, -80, LeafKind.UPRIGHT_BOX, wall))
                .isEqualTo(FREE);
        // A disc about its own centre never gets anywhere.
        double[] disc = SweepRows.disc(0, 0, 0.5, 1, 1);
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, disc, 0, 0.5, 1e9, LeafKind.UPRIGHT_BOX, wall))
                .isEqualTo(FREE);
        // Off its centre, touching at the nearest point of its circle: away both ways; from the far side, in.
        double[] swung = SweepRows.disc(0, 0, 0, 1, 1);
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, 0, -3, 40, LeafKind.UPRIGHT_BOX, wall))
                .isEqualTo(FREE);
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, 0, -3, -40, LeafKind.UPRIGHT_BOX, wall))
                .isEqualTo(FREE);
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, 0, 3, 40, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, 0, 3, -40, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
        // In contact sideways: one way is in, the other out.
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, -3, 0, 10, LeafKind.UPRIGHT_BOX, wall))
                .isEqualTo(FREE);
        assertThat(turn(LeafKind.UPRIGHT_CYLINDER, swung, -3, 0, -10, LeafKind.UPRIGHT_BOX, wall))
                .isZero();
    }

    @Test
    void answersScaleByPowersOfTwo() {
        for (int k = 0; k < 300; k++) {
            LeafKind kindA = EXACT[random.nextInt(EXACT.length)];
            LeafKind kindB = EXACT[random.nextInt(EXACT.length)];
            double[] a = SweepRows.random(kindA, 2, random);
            double[] b = SweepRows.random(kindB, 2, random);
            double dx = random.nextDouble(-3, 3);
            double dz = random.nextDouble(-3, 3);
            double time = planar(kindA, a, dx, dz, kindB, b);
            double share = turn(kindA, a, 0.25, 0.5, 200, kindB, b);
            for (int power : new int[] {-300, -40, 40}) {
                double f = Math.scalb(1.0, power);
                double[] p = scaled(kindA, a, f);
                double[] q = scaled(kindB, b, f);
                double scaledTime = planar(kindA, p, dx * f, dz * f, kindB, q);
                double scaledShare = turn(kindA, p, 0.25 * f, 0.5 * f, 200, kindB, q);
                if (power == -300) { // exact arithmetic throughout, or less rounding
                    assertThat(scaledTime > 1).isEqualTo(time > 1);
                    assertThat(Math.min(2, scaledTime)).isCloseTo(Math.min(2, time), within(0x1p-38));
                    assertThat(Math.min(2, scaledShare)).isCloseTo(Math.min(2, share), within(0x1p-38));
                } else {
                    assertThat(scaledTime).isEqualTo(time);
                    assertThat(scaledShare).isEqualTo(share);
                }
            }
        }
    }

    private static double[] scaled(LeafKind kind, double[] row, double f) {
        double[] out = row.clone();
        int sizes = kind == LeafKind.TRIANGLE ? 9 : kind == LeafKind.PRISM ? 10 : 6;
        for (int k = 0; k < sizes; k++) {
            out[k] *= f;
        }
        return out;
    }

    /** Level motions past a box that is a last bit away, or touched in passing: no gap closes, and doubles cannot tell. */
    @Test
    void slidingPastWithinALastBitIsFreeAndTouchingInPassingIsNot() {
        int free = 0;
        int count = 400;
        for (int n = 0; n < count; n++) {
            double[] a = Rows.box(0, 0, 0, 0.5, random.nextDouble(0.1, 1), random.nextDouble(0.1, 1), Rows.identity());
            double[] b = Rows.box(4, 0, 0, 0.5, random.nextDouble(0.1, 1), random.nextDouble(0.1, 1), Rows.identity());
            int across = n % 2 == 0 ? 2 : 1;
            double reach = a[3 + across] + b[3 + across];
            b[across] = reach + random.nextInt(-1, 3) * Math.ulp(reach);
            BigDecimal gap = new BigDecimal(b[across])
                    .subtract(new BigDecimal(a[3 + across]))
                    .subtract(new BigDecimal(b[3 + across]));
            boolean isFree = gap.signum() > 0;
            String text = Arrays.toString(a) + " past " + Arrays.toString(b);
            if (across == 2) {
                double planar = PlanarSweep.translation(
                        new Leaf(LeafKind.UPRIGHT_BOX, a, 0),
                        8,
                        0,
                        0,
                        new Leaf(LeafKind.UPRIGHT_BOX, b, 0),
                        scratch.sweep);
                assertThat(planar == Double.POSITIVE_INFINITY).as(text).isEqualTo(isFree);
            }
            for (LeafKind kind : new LeafKind[] {LeafKind.UPRIGHT_BOX, LeafKind.BOX}) {
                double time =
                        SpatialSweep.translation(new Leaf(kind, a, 0), 8, 0, 0, new Leaf(kind, b, 0), scratch.sweep);
                assertThat(time == Double.POSITIVE_INFINITY).as(text).isEqualTo(isFree);
            }
            free += isFree ? 1 : 0;
        }
        assertThat(free).isBetween(count * 3 / 10, count * 7 / 10);
    }

    @Test
    void slidingAlongAnObliqueWallIsNeverBlocked() {
        double yaw = 30;
        double[] wall = SweepRows.uprightBox(0, 0, 0, 2000, 1, 0.5, yaw);
        double ux = wall[6];
        double uz = wall[12];
        double[] robot = new double[Leaf.STRIDE];
        double[] cart = SweepRows.uprightBox(0, 0, 0, 0.5, 1, 0.4, yaw);
        double clearance = 1e-9;
        double[][] movers = {SweepRows.disc(0, 0, 0, 0.4, 1), cart};
        LeafKind[] kinds = {LeafKind.UPRIGHT_CYLINDER, LeafKind.UPRIGHT_BOX};
        for (int mover = 0; mover < 2; mover++) {
            System.arraycopy(movers[mover], 0, robot, 0, Leaf.STRIDE);
            robot[0] = -1000 * ux + wall[8] * (0.9 + clearance);
            robot[2] = -1000 * uz + wall[14] * (0.9 + clearance);
            for (int k = 0; k < 100_000; k++) {
                double time = planar(kinds[mover], robot, 0.02 * ux, 0.02 * uz, LeafKind.UPRIGHT_BOX, wall);
                if (time != FREE) {
                    throw new AssertionError("blocked at step " + k + ": " + time);
                }
                robot[0] += 0.02 * ux;
                robot[2] += 0.02 * uz;
            }
        }
    }

    @Test
    void nothingIsAllocatedOnTheWay() {
        double[] disc = SweepRows.disc(-2, 0, 0.3, 0.5, 1);
        double[] box = SweepRows.uprightBox(0, 0, 0, 1, 1, 2, 33);
        double[] other = SweepRows.uprightBox(-3, 0, 0, 0.6, 1, 0.5, 12);
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        double sum = 0;
        long before = 0;
        for (int k = 0; k < 60_000; k++) {
            if (k == 10_000) {
                before = threads.getCurrentThreadAllocatedBytes();
            }
            double angle = k * 1e-4;
            double dx = 3 * StrictMath.cos(angle);
            double dz = 3 * StrictMath.sin(angle);
            sum += Math.min(2, planar(LeafKind.UPRIGHT_CYLINDER, disc, dx, dz, LeafKind.UPRIGHT_BOX, box));
            sum += Math.min(2, planar(LeafKind.UPRIGHT_BOX, other, dx, dz, LeafKind.UPRIGHT_BOX, box));
            sum += Math.min(2, turn(LeafKind.UPRIGHT_BOX, other, -2, 1, angle * 20, LeafKind.UPRIGHT_BOX, box));
        }
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        assertThat(sum).isPositive();
        // A few in ten thousand graze so closely that they are decided exactly. From JDK 21 on StrictMath
        // itself, which is written in Java there, makes an array of two doubles a call; a turn asks for a
        // dozen sines and angles.
        assertThat(bytes / 150_000.0).isLessThan(Runtime.version().feature() < 21 ? 4 : 512);
    }
}
