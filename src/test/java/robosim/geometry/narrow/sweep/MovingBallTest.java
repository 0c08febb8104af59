package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Effort;
import robosim.geometry.narrow.RimTwin;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.reference.PlanarTwin;
import robosim.geometry.reference.Truth;
import robosim.geometry.reference.Truth.Form;
import robosim.geometry.reference.WayTruth;

/** Spheres that move straight on, in space: exact where a root tells when, and within a bound on rims. */
class MovingBallTest {
    private static final double FREE = Double.POSITIVE_INFINITY;

    private final Scratch scratch = new Scratch();
    private final SplittableRandom random = new SplittableRandom(30052);
    private int hits;
    private int misses;
    private int inDoubles;

    private double time(double[] ball, double[] d, LeafKind kindB, double[] b) {
        return SpatialSweep.translation(
                new Leaf(LeafKind.SPHERE, ball, 0), d[0], d[1], d[2], new Leaf(kindB, b, 0), scratch.sweep);
    }

    @Test
    void timesAreRoundedDownToTheNextDouble() {
        LeafKind[] kinds = {LeafKind.UPRIGHT_BOX, LeafKind.BOX, LeafKind.TRIANGLE, LeafKind.SPHERE};
        int count = Effort.cases(320, 80);
        for (int k = 0; k < count; k++) {
            LeafKind kind = kinds[k % 4];
            double[] b = SweepRows.random(kind, 1, random);
            double[] ball = SweepRows.random(LeafKind.SPHERE, 2.5, random);
            if (k % 3 == 0) {
                ball[3] = Math.scalb(random.nextDouble(), -random.nextInt(50));
            }
            double[] d = towards(ball, b);
            if (k % 5 == 0) { // to contact, and then across
                double first = time(ball, d, kind, b);
                if (first <= 1) {
                    MovedLeaf.moved(
                            new Leaf(LeafKind.SPHERE, ball.clone(), 0),
                            first * d[0],
                            first * d[1],
                            first * d[2],
                            new Leaf(LeafKind.SPHERE, ball, 0));
                    d = new double[] {d[1], -d[0], d[2]};
                }
            }
            double scale = Math.scalb(1.0, new int[] {0, -40, 40}[k % 3]);
            double far = k % 7 == 0 ? 1e6 * scale : 0;
            for (int m = 0; m < 3; m++) {
                d[m] *= scale;
            }
            check(placed(LeafKind.SPHERE, ball, scale, far), d, kind, placed(kind, b, scale, far));
        }
        assertThat(hits).isGreaterThan(count / 6);
        assertThat(misses).isGreaterThan(count / 6);
        // Both stages are needed.
        assertThat(inDoubles).isBetween(hits / 3, hits - 1);
    }

    @Test
    void endsExactlyInContactOrOneUlpShort() {
        double[] box = SweepRows.uprightBox(0, 0, 0, 1, 1, 1, 0);
        double[] b = SweepRows.disc(-4, 0, 0, 1, 0);
        assertThat(time(b, new double[] {2, 0, 0}, LeafKind.UPRIGHT_BOX, box)).isEqualTo(1);
        assertThat(time(b, new double[] {Math.nextDown(2.0), 0, 0}, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        // An edge, 3, 4, 5; a corner, 2, 3, 6, 7.
        double[] edge = SweepRows.disc(-12, 0, -5, 5, 0);
        assertThat(time(edge, new double[] {8, 0, 0}, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(1);
        assertThat(time(edge, new double[] {Math.nextDown(8.0), 0, 0}, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        double[] corner = SweepRows.disc(-17, 3, 4, 7, 0);
        assertThat(time(corner, new double[] {10, 0, 0}, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(1);
        assertThat(time(corner, new double[] {Math.nextDown(10.0), 0, 0}, LeafKind.UPRIGHT_BOX, box))
                .isEqualTo(FREE);
        // Grazing a face, an edge and another ball in passing, and one ulp beside.
        for (double height : new double[] {2, Math.nextUp(2.0)}) {
            double[] passing = SweepRows.disc(-9, height, 0.5, 1, 0);
            double[] slab = SweepRows.triangle(-1, 1, -1, 1, 1, -1, 0, 1, 8);
            double[] other = SweepRows.disc(0, 0.5, 0.5, 0.5, 0);
            double[] d = {16, 0, 0};
            assertThat(time(passing, d, LeafKind.UPRIGHT_BOX, box) <= 1).isEqualTo(height == 2);
            assertThat(time(passing, d, LeafKind.TRIANGLE, slab) <= 1).isEqualTo(height == 2);
            assertThat(time(passing, d, LeafKind.SPHERE, other) <= 1).isEqualTo(height == 2);
        }
    }

    @Test
    void contactAtTheStartIsJudgedByTheNearestPoint() {
        double[] box = SweepRows.uprightBox(0, 0, 0, 2, 3, 1, 0);
        double[] half = {2, 3, 1};
        int into = 0;
        int free = 0;
        for (int k = 0; k < 4000; k++) {
            double[] ball = SweepRows.disc(
                    random.nextInt(-4, 5), random.nextInt(-5, 6), random.nextInt(-3, 4), random.nextInt(1, 4), 0);
            double[] d = {random.nextInt(-1, 2), random.nextInt(-1, 2), random.nextInt(-1, 2)};
            double square = 0;
            double inward = 0;
            double least = Double.POSITIVE_INFINITY;
            boolean against = true;
            for (int m = 0; m < 3; m++) {
                double beyond = Math.max(0, Math.abs(ball[m]) - half[m]) * Math.signum(ball[m]);
                square += beyond * beyond;
                inward -= beyond * d[m];
                for (int sign = -1; sign <= 1; sign += 2) {
                    double depth = half[m] - sign * ball[m];
                    if (depth < least) {
                        least = depth;
                        against = true;
                    }
                    against &= depth > least || sign * d[m] < 0;
                }
            }
            if (square > ball[3] * ball[3]) {
                continue;
            }
            boolean deeper = square > 0 ? inward > 0 : against;
            String what = Arrays.toString(ball) + " by " + Arrays.toString(d);
            assertThat(time(ball, d, LeafKind.UPRIGHT_BOX, box)).as(what).isEqualTo(deeper ? 0 : FREE);
            assertThat(SpatialSweep.translation(
                            new Leaf(LeafKind.UPRIGHT_BOX, box, 0),
                            -d[0],
                            -d[1],
                            -d[2],
                            new Leaf(LeafKind.SPHERE, ball, 0),
                            scratch.sweep))
                    .as(what)
                    .isEqualTo(deeper ? 0 : FREE);
            into += deeper ? 1 : 0;
            free += deeper ? 0 : 1;
        }
        assertThat(into).isGreaterThan(300);
        assertThat(free).isGreaterThan(300);
    }

    @Test
    void parryCase429BallAtEverLargerCuboids() {
        for (double half : new double[] {5, 50, 500}) {
            double[] cuboid = SweepRows.box(0, 0, 0, half, half, half, 20, 30, 40);
            double[] ball = SweepRows.disc(2 * half, half, -3 * half, 0.5166, 0);
            check(ball, new double[] {-2 * half, -half, 3 * half}, LeafKind.BOX, cuboid);
            double[] straight = SweepRows.disc(3 * half, 0.25 * half, 0, 0.5166, 0);
            check(
                    straight,
                    new double[] {-3 * half, 0, 0},
                    LeafKind.UPRIGHT_BOX,
                    SweepRows.uprightBox(0, 0, 0, half, half, half, 0));
        }
        assertThat(hits).isEqualTo(6);
    }

    @Test
    void ncollideCase4BallAtABlockInSpace() {
        double[] ball = SweepRows.disc(784.470154 - 1e3, 0, 0, 15, 0);
        double[] block = SweepRows.uprightBox(820 - 1e3, 0, 0, 20, 20, 20, 0);
        assertThat(time(ball, new double[] {63.0261, 0, 0}, LeafKind.UPRIGHT_BOX, block) * 100)
                .isBetween(0.840676, 0.840679);
    }

    @Test
    void joltCase2103BallAtACylinderFromTheSide() {
        // The capsule's end as a ball: it touches the side, where the engine reported 7 m of penetration.
        double[] cylinder = SweepRows.disc(0, 0, 0, 0.4975, 0.3);
        double[] ball = SweepRows.disc(2.5, 0.1, 0.25, 2.0311, 0);
        double[] d = {-0.00244140625, -0.0068359375, 0.0029296875};
        RimTwin twin = new RimTwin(ball, d, LeafKind.UPRIGHT_CYLINDER, cylinder);
        double time = time(ball, d, LeafKind.UPRIGHT_CYLINDER, cylinder);
        assertThat(twin.gap(twin.nearest()).signum()).isEqualTo(time <= 1 ? -1 : 1);
    }

    @Test
    void aSideOrCapOfAnUprightCylinderIsMetToTheNextDouble() {
        int caps = 0;
        int sides = 0;
        for (int k = 0; k < 60; k++) {
            double[] cylinder = SweepRows.random(LeafKind.UPRIGHT_CYLINDER, 0.5, random);
            cylinder[3] += 2;
            cylinder[4] += 2;
            double[] ball = SweepRows.random(LeafKind.SPHERE, 0.5, random);
            double[] d = {random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)};
            if (k % 2 == 0) {
                ball[1] += 6;
                d[1] = -7;
            } else {
                ball[0] += 6;
                d[0] = -7;
            }
            double time = time(ball, d, LeafKind.UPRIGHT_CYLINDER, cylinder);
            RimTwin twin = new RimTwin(ball, d, LeafKind.UPRIGHT_CYLINDER, cylinder);
            assertThat(time).isBetween(0.0, 1.0);
            assertThat(twin.gap(new BigDecimal(time)).signum()).isNotNegative();
            assertThat(twin.gap(new BigDecimal(Math.nextUp(time))).signum()).isNotPositive();
            double across = Math.hypot(ball[0] + time * d[0] - cylinder[0], ball[2] + time * d[2] - cylinder[2]);
            boolean above = Math.abs(ball[1] + time * d[1] - cylinder[1]) > cylinder[4];
            caps += across < cylinder[3] && above ? 1 : 0;
            sides += across > cylinder[3] && !above ? 1 : 0;
        }
        // Half of the balls come from above and half from the side; none of them meets the rim.
        assertThat(caps).isEqualTo(30);
        assertThat(sides).isEqualTo(30);
    }

    @Test
    void rimsAndTurnedCylindersAreMetWithinTheBound() {
        double worst = 0;
        for (int k = 0; k < 60; k++) {
            LeafKind kind = k % 2 == 0 ? LeafKind.CYLINDER : LeafKind.UPRIGHT_CYLINDER;
            double[] cylinder = SweepRows.random(kind, 1, random);
            double[] ball = SweepRows.random(LeafKind.SPHERE, 2.5, random);
            double[] d = towards(ball, cylinder);
            RimTwin twin = new RimTwin(ball, d, kind, cylinder);
            if (k % 3 == 0 && twin.gap(twin.nearest()).doubleValue() > -0.9 * ball[3]) {
                // So large that it grazes, or misses by little.
                ball[3] += twin.gap(twin.nearest()).doubleValue() + (k % 2 - 0.5) * 1e-12;
                twin = new RimTwin(ball, d, kind, cylinder);
            }
            if (twin.gap(BigDecimal.ZERO).signum() <= 0) {
                continue;
            }
            double size = 0;
            for (int m = 0; m < 3; m++) {
                size += Math.abs(ball[m]) + Math.abs(cylinder[m]) + Math.abs(d[m]);
            }
            size += ball[3] + cylinder[3] + cylinder[4];
            String what = Arrays.toString(ball) + " by " + Arrays.toString(d) + " at " + Arrays.toString(cylinder);
            double time = time(ball, d, kind, cylinder);
            BigDecimal nearest = twin.nearest();
            boolean meets = twin.gap(nearest).signum() <= 0;
            if (time > 1) {
                assertThat(meets).as(what).isFalse();
                misses++;
                continue;
            }
            hits++;
            double gap = twin.gap(new BigDecimal(time)).doubleValue() / size;
            assertThat(gap).as(what).isLessThan(TranslationAdvancement.EARLY);
            worst = Math.max(worst, gap);
            if (meets) {
                assertThat(new BigDecimal(time).compareTo(twin.contact(nearest)) <= 0)
                        .as(what)
                        .isTrue();
            }
        }
        assertThat(hits).isGreaterThan(10);
        assertThat(misses).isGreaterThan(10);
        assertThat(worst).isGreaterThan(TranslationAdvancement.EARLY / 1000);
    }

    private void check(double[] ball, double[] d, LeafKind kind, double[] b) {
        String what = "ball %s by %s, kind %s %s"
                .formatted(Arrays.toString(ball), Arrays.toString(d), kind, Arrays.toString(b));
        double time = time(ball, d, kind, b);
        assertThat(SpatialSweep.translation(
                        new Leaf(kind, b, 0), -d[0], -d[1], -d[2], new Leaf(LeafKind.SPHERE, ball, 0), scratch.sweep))
                .as(what + " the other way round")
                .isEqualTo(time);
        Form form = Form.valueOf(kind.name());
        if (PlanarTwin.exactly(n -> Truth.spatial(n, Form.SPHERE, ball, form, b))) {
            assertThat(time).as(what).isIn(0.0, FREE);
        } else if (PlanarTwin.exactly(n -> WayTruth.ball(n, ball, d, form, b))) {
            hits++;
            double next = Math.nextUp(time);
            assertThat(PlanarTwin.exactly(n -> WayTruth.ballBy(n, ball, d, time, time * 0x1p-200, form, b)))
                    .as(what)
                    .isFalse();
            assertThat(PlanarTwin.exactly(n -> WayTruth.ballBy(n, ball, d, next, 0, form, b)))
                    .as(what)
                    .isTrue();
            double held = scratch.sweep
                    .sweep()
                    .move
                    .time(
                            false,
                            new Leaf(LeafKind.SPHERE, ball, 0),
                            d[0],
                            d[1],
                            d[2],
                            new Leaf(kind, b, 0),
                            scratch.overlap);
            double found = scratch.sweep
                    .sweep()
                    .ball
                    .time(new Leaf(LeafKind.SPHERE, ball, 0), d[0], d[1], d[2], new Leaf(kind, b, 0), held);
            inDoubles += Double.isNaN(found) ? 0 : 1;
        } else {
            misses++;
            assertThat(time).as(what).isEqualTo(FREE);
        }
    }

    private double[] towards(double[] ball, double[] b) {
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            d[k] = 1.5 * (b[k] - ball[k] + random.nextDouble(-1.5, 1.5));
        }
        if (random.nextInt(3) == 0) {
            d[random.nextInt(3)] = 0;
        }
        return d;
    }

    private static double[] placed(LeafKind kind, double[] row, double scale, double far) {
        double[] out = row.clone();
        int sizes = kind == LeafKind.TRIANGLE ? 9 : 6;
        for (int k = 0; k < sizes; k++) {
            out[k] *= scale;
        }
        double[] moved = new double[Leaf.STRIDE];
        MovedLeaf.moved(new Leaf(kind, out, 0), far, 0, -far, new Leaf(LeafKind.SPHERE, moved, 0));
        return moved;
    }
}
