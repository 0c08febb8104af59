package robosim.geometry.narrow.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.SweepRows;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.leaf.PivotTurn;

/** Turns that pass closely: the gap that is let through, and how close a turn comes that is stopped. */
class TurnAdvancementTest {
    /** The documented bound, as a share of the mover's radius; what is as large as it is itself adds little here. */
    private static final double BOUND = 0x1p-30;

    /** More steps than any turn in here takes; a turn that is given up takes a thousand. */
    private static final int FEW = 60;

    private final Scratch scratch = new Scratch();
    private final Gjk gjk = new Gjk();
    private final SplittableRandom random = new SplittableRandom(1611);

    /** A rod that tips onto a capsule, as held across the edges of both, comes to it where it would come to a cylinder. */
    @Test
    void aRodTipsOntoACapsule() {
        double[] rod = {0, 0, 0, 0.32, 0.69, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        double[] post = {0.45, -1.16, -1.27, 0.74, 0.83, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        for (LeafKind mover : new LeafKind[] {LeafKind.UPRIGHT_CYLINDER, LeafKind.UPRIGHT_CAPSULE}) {
            for (LeafKind still : new LeafKind[] {LeafKind.UPRIGHT_CYLINDER, LeafKind.UPRIGHT_CAPSULE}) {
                assertThat(turn(mover, rod, 1, 0, 0, 49, still, post) * 49)
                        .as(mover + " onto " + still)
                        .isBetween(24.0, 32.0);
            }
        }
    }

    @Test
    void edgesOnTheRulingsOfAHyperboloidPassEachOther() {
        for (double slope : new double[] {1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 0.1, 1, 3}) {
            for (double gap = 0.1; gap > 2e-9; gap /= 2) {
                // Least gap at the waist: some gap * slope / sqrt(1 + slope^2) of a radius up to sqrt(2 + slope^2).
                double[] still = SweepRows.triangle(1 + gap, -1, slope, 1 + gap, 1, -slope, 3, 0, 0);
                double[] mover =
                        turned(-60, LeafKind.TRIANGLE, SweepRows.triangle(1, -1, -slope, 1, 1, slope, 0, 0, 0));
                String what = "slope " + slope + ", gap " + gap;
                assertThat(turn(LeafKind.TRIANGLE, mover, 0, 1, 0, 120, LeafKind.TRIANGLE, still))
                        .as(what)
                        .isInfinite();
                assertThat(scratch.sweep.sweep().turning.steps()).as(what).isLessThan(FEW);
                // Through the waist, where the edges cross, and no further.
                double[] cut = SweepRows.triangle(1 - gap, -1, slope, 1 - gap, 1, -slope, 3, 0, 0);
                assertThat(turn(LeafKind.TRIANGLE, mover, 0, 1, 0, 120, LeafKind.TRIANGLE, cut))
                        .as(what)
                        .isLessThan(1);
            }
        }
    }

    @Test
    void theSameInAWorld() {
        for (double gap : new double[] {1e-3, 1e-5, 1e-8}) {
            Geometry world = new Geometry(16, 16, 16);
            MeshObject still = new MeshObject(
                    List.of(new Point(1 + gap, -1, 1), new Point(1 + gap, 1, -1), new Point(3, 0, 0)),
                    new int[][] {{0, 1, 2}});
            MeshObject mover = new MeshObject(
                            List.of(new Point(1, -1, -1), new Point(1, 1, 1), new Point(0, 0, 0)),
                            new int[][] {{0, 1, 2}})
                    .turned(0, -60)
                    .moveable("m");
            assertThat(world.addObject(still)).isTrue();
            assertThat(world.addObject(mover)).isTrue();
            assertThat(world.move("m", new Move(0, 0, 0, 0, 120)).allowed())
                    .as("gap " + gap)
                    .isTrue();
        }
    }

    @Test
    void thinRodsOnTheRulingsPassEachOther() {
        for (double radius : new double[] {0, 1e-9, 1e-6, 1e-3}) {
            for (double gap = 0.05; gap > 4e-9; gap /= 3) {
                double[] still = rod(1 + gap + 2 * radius * Math.sqrt(2), -1, radius);
                double[] mover = turned(-50, LeafKind.CYLINDER, rod(1, 1, radius));
                String what = "radius " + radius + ", gap " + gap;
                double share = turn(LeafKind.CYLINDER, mover, 0, 1, 0, 100, LeafKind.CYLINDER, still);
                if (radius < gap) {
                    assertThat(share).as(what).isInfinite();
                }
                assertThat(scratch.sweep.sweep().turning.steps()).as(what).isLessThan(FEW);
            }
        }
    }

    @Test
    void aTippedCylinderTurnsBesideAPost() {
        int passed = 0;
        for (int k = 0; k < 400; k++) {
            double radius = random.nextDouble(0.1, 0.5);
            double half = random.nextDouble(0.1, 1);
            double pitch = random.nextDouble(-80, 80);
            double[] mover = SweepRows.cylinder(0, 0, 0, radius, half, random.nextDouble(-180, 180), pitch, 0);
            double post = random.nextDouble(0.05, 0.5);
            double gap =
                    Math.sqrt(radius * radius + half * half) * BOUND * StrictMath.pow(2, random.nextDouble(0.5, 20));
            double away = reach(radius, half, mover[10]) + post + gap;
            double angle = random.nextDouble(-3, 3);
            double[] still = SweepRows.disc(away * Math.cos(angle), 0, away * Math.sin(angle), post, 3);
            String what = "%s by 360 degrees beside %s".formatted(Arrays.toString(mover), Arrays.toString(still));
            assertThat(turn(LeafKind.CYLINDER, mover, 0, 1, 0, 360, LeafKind.UPRIGHT_CYLINDER, still))
                    .as(what)
                    .isInfinite();
            assertThat(turn(LeafKind.CYLINDER, mover, 0, -1, 0, 1000, LeafKind.UPRIGHT_CYLINDER, still))
                    .as(what)
                    .isInfinite();
            passed++;
            still[3] += 2 * gap;
            assertThat(turn(LeafKind.CYLINDER, mover, 0, 1, 0, 360, LeafKind.UPRIGHT_CYLINDER, still))
                    .as(what)
                    .isLessThan(1);
        }
        assertThat(passed).isEqualTo(400);
    }

    @Test
    void whatWasStoppedIsWithinTheBoundAndGoesNoFurther() {
        LeafKind[] kinds = {
            LeafKind.BOX,
            LeafKind.UPRIGHT_BOX,
            LeafKind.TRIANGLE,
            LeafKind.CYLINDER,
            LeafKind.UPRIGHT_CYLINDER,
            LeafKind.SPHERE
        };
        int stopped = 0;
        int most = 0;
        double[] pose = new double[Leaf.STRIDE];
        for (int k = 0; k < 40_000; k++) {
            LeafKind kindA = kinds[random.nextInt(kinds.length)];
            LeafKind kindB = kinds[random.nextInt(kinds.length)];
            double[] a = SweepRows.random(kindA, 1, random);
            double[] b = SweepRows.random(kindB, 1, random);
            double[] about = SweepRows.random(LeafKind.BOX, 1, random);
            gjk.spatial(new Leaf(kindA, a, 0), new Leaf(kindB, b, 0));
            if (!(gjk.lower() > 0)) {
                continue;
            }
            double degrees = random.nextDouble(-180, 180);
            double share = SpatialSweep.turn(
                    new Leaf(kindA, a, 0),
                    new PivotTurn().about(0.1, 0.2, 0.3).by(about[6], about[9], about[12], degrees),
                    new Leaf(kindB, b, 0),
                    scratch.sweep);
            most = Math.max(most, scratch.sweep.sweep().turning.steps());
            if (share > 1) {
                continue;
            }
            stopped++;
            double angle = Math.toRadians(degrees * share);
            MovedLeaf.turned(
                    new Leaf(kindA, a, 0),
                    new PivotTurn().about(0.1, 0.2, 0.3).by(about[6], about[9], about[12], 0),
                    StrictMath.cos(angle),
                    StrictMath.sin(angle),
                    new Leaf(LeafKind.SPHERE, pose, 0));
            gjk.spatial(new Leaf(MovedLeaf.turnedKind(kindA), pose, 0), new Leaf(kindB, b, 0));
            String what = "kind %s %s about %s by %s, kind %s %s"
                    .formatted(kindA, Arrays.toString(a), Arrays.toString(about), degrees, kindB, Arrays.toString(b));
            // The mover reaches at least as far as its centre.
            double radius =
                    Math.sqrt((a[0] - 0.1) * (a[0] - 0.1) + (a[1] - 0.2) * (a[1] - 0.2) + (a[2] - 0.3) * (a[2] - 0.3));
            assertThat(gjk.upper()).as(what).isLessThan(BOUND * Math.max(0.1, radius));
        }
        assertThat(stopped).isGreaterThan(5_000);
        assertThat(most).isLessThan(FEW);
    }

    /** The cap's normal is the cylinder's axis to rounding: how fast its rim rises means nothing. */
    @Test
    void aSphereThatTouchesACapDoesNotTurnIntoIt() {
        double[] sphere =
                SweepRows.disc(-0.05837435919179524, 0.1083799971012655, 0.06536207446435689, 0.8509156130571618, 0);
        double[] cylinder = {
            -0.25505953392790837,
            1.4674325477449421,
            -0.04694441228822171,
            0.12412468652957352,
            0.525167050443683,
            0.16435416845111883,
            0.9670515158083892,
            -0.18078670067690478,
            0.1792415538625347,
            0.15576846587547777,
            0.9770793259332206,
            0.14509367964416459,
            -0.20136422425916878,
            -0.11239288096780235,
            0.9730469102238908,
            0
        };
        double share = turn(
                LeafKind.SPHERE,
                sphere,
                0.26691504496058993,
                -0.8844885351469147,
                -0.3826700797911318,
                30.94734570503472,
                LeafKind.CYLINDER,
                cylinder);
        assertThat(share).isLessThan(1e-13);
    }

    private double turn(
            LeafKind kindA, double[] a, double wx, double wy, double wz, double degrees, LeafKind kindB, double[] b) {
        return SpatialSweep.turn(
                new Leaf(kindA, a, 0),
                new PivotTurn().about(0, 0, 0).by(wx, wy, wz, degrees),
                new Leaf(kindB, b, 0),
                scratch.sweep);
    }

    private static double[] turned(double degrees, LeafKind kind, double[] row) {
        double[] out = new double[Leaf.STRIDE];
        double cos = StrictMath.cos(Math.toRadians(degrees));
        double sin = StrictMath.sin(Math.toRadians(degrees));
        MovedLeaf.turned(
                new Leaf(kind, row, 0),
                new PivotTurn().about(0, 0, 0).by(0, 1, 0, 0),
                cos,
                sin,
                new Leaf(LeafKind.SPHERE, out, 0));
        return out;
    }

    /** A cylinder along (0, 1, way) through (x, 0, 0). */
    private static double[] rod(double x, int way, double radius) {
        double[] row = SweepRows.disc(x, 0, 0, radius, 1);
        double s = Math.sqrt(0.5);
        row[6] = 1;
        row[10] = s;
        row[13] = way * s;
        row[11] = -way * s;
        row[14] = s;
        return row;
    }

    /** How far a cylinder at the origin reaches from the vertical, its axis having a vertical part. */
    private static double reach(double radius, double half, double upright) {
        double level = Math.sqrt(Math.max(0, 1 - upright * upright));
        double best = 0;
        // The square is convex towards the ends but for one top: (half level + radius sin)^2 + (radius cos)^2.
        for (int k = 0; k <= 4000; k++) {
            double angle = Math.PI * (k / 4000.0 - 0.5);
            double out = half * level + radius * Math.abs(upright) * Math.sin(angle);
            double side = radius * Math.cos(angle);
            best = Math.max(best, out * out + side * side);
        }
        // d/dangle = 0 where sin = half level |upright| / (radius level^2).
        double sine = level == 0 ? 1 : half * Math.abs(upright) / (radius * level);
        if (sine < 1) {
            double out = half * level + radius * Math.abs(upright) * sine;
            best = Math.max(best, out * out + radius * radius * (1 - sine * sine));
        }
        return Math.sqrt(best);
    }
}
