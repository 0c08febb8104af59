package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.MeshObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** What the page on moves promises, by looking at many places along the way. */
@Tag("slow")
class MoveLawsTest {
    private static final double SIZE = 64;
    private static final int SAMPLES = 1000;

    private static Geometry world(Dimension dimension, List<? extends GeometryObject> objects) {
        Geometry world = new Geometry(SIZE, SIZE, SIZE, dimension, Accuracy.EXACT);
        objects.forEach(object -> assertThat(world.addObjectUnchecked(object)).isTrue());
        return world;
    }

    private static String text(GeometryObject object) {
        if (object instanceof MeshObject mesh) {
            return mesh + " " + mesh.vertices() + java.util.Arrays.deepToString(mesh.faces());
        }
        return object instanceof ObjectGroup group
                ? group + " " + group.members().stream().map(MoveLawsTest::text).toList()
                : object.toString();
    }

    /** Where a mover stands after a share of its translation along the world's axes and of its two turns about them. */
    private static GeometryObject after(GeometryObject mover, Move move, double way, double yaw, double tip) {
        Point c = mover.center();
        return mover.movedTo(new Point(c.x() + way * move.x(), c.y() + way * move.y(), c.z() + way * move.z()))
                .oriented(turned(mover, tip * move.rx(), yaw * move.ry()));
    }

    private static double[] turned(GeometryObject mover, double rx, double ry) {
        if (mover.rotation()[4] == 1 && rx == 0) {
            return mover.turned(0, ry).rotation();
        }
        double[] r = mover.rotation();
        double[] yaw = new SphereObject(new Point(), 1).turned(0, ry).rotation();
        double[] tip = new SphereObject(new Point(), 1).turned(rx, 0).rotation();
        return product(tip, product(yaw, r));
    }

    private static double[] product(double[] a, double[] b) {
        double[] product = new double[9];
        for (int k = 0; k < 9; k++) {
            int row = k / 3 * 3;
            product[k] = a[row] * b[k % 3] + a[row + 1] * b[3 + k % 3] + a[row + 2] * b[6 + k % 3];
        }
        return product;
    }

    private static Move move(Dimension dimension, SplittableRandom random, int k) {
        double far = k % 3 == 1 ? 0 : random.nextDouble(k % 5 == 0 ? 12 : 2);
        double yaw = k % 3 == 0 ? 0 : random.nextDouble(-1, 1) * (k % 4 == 0 ? 400 : 90);
        double tip = k % 6 == 5 && dimension == Dimension.SPATIAL ? random.nextDouble(-90, 90) : 0;
        return new Move(
                far * random.nextDouble(-1, 1),
                far * random.nextDouble(-0.3, 0.3),
                far * random.nextDouble(-1, 1),
                tip,
                yaw);
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void nothingIsTouchedAnywhereOnTheWay(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(21 + dimension.ordinal());
        RandomObjects objects = new RandomObjects(random, 4);
        int made = 0;
        int refused = 0;
        int cases = Effort.cases(240);
        for (int k = 0; k < cases; k++) {
            List<GeometryObject> others = new ArrayList<>();
            for (int n = random.nextInt(4, 12); n > 0; n--) {
                others.add(objects.next());
            }
            GeometryObject mover = objects.next().moveable("mover");
            // What it overlaps at the start is a matter of another test.
            others.removeIf(other -> world(dimension, List.of(other)).testObject(mover));
            Geometry rest = world(dimension, others);
            Geometry world = world(dimension, others);
            assertThat(world.addObject(mover)).isTrue();
            Move move = move(dimension, random, k);
            MoveResult result = world.moveGlobal("mover", move);
            String what = dimension + " " + text(mover) + "\n by " + move + "\n beside "
                    + others.stream().map(MoveLawsTest::text).toList() + "\n " + result;
            if (result.allowed()) {
                made++;
                assertThat(result.obstacle()).isNull();
                wholeWayIsFree(rest, mover, move, what);
            } else {
                refused++;
                assertThat(world.getObject("mover")).as(what).isEqualTo(mover);
                shareIsFree(rest, mover, move, result, what);
            }
        }
        assertThat(made).isBetween(cases / 4, cases * 19 / 20);
        assertThat(refused).isBetween(cases / 16, cases * 3 / 4);
    }

    private static void wholeWayIsFree(Geometry rest, GeometryObject mover, Move move, String what) {
        for (int s = 0; s <= SAMPLES; s++) {
            double share = s / (double) SAMPLES;
            if (move.x() != 0 || move.z() != 0) {
                free(rest, after(mover, move, share, 0, 0), what, share);
            }
            if (move.ry() != 0) {
                free(rest, after(mover, move, 1, share, 0), what, share);
            }
            if (move.rx() != 0) {
                free(rest, after(mover, move, 1, 1, share), what, share);
            }
        }
    }

    private static void free(Geometry rest, GeometryObject there, String what, double share) {
        if (rest.testObject(there)) {
            assertThat(rest.testObject(there)).as("at " + share + ": " + what).isFalse();
        }
    }

    /** The share that is free is free all the way, and just beyond it something is met. */
    private static void shareIsFree(Geometry rest, GeometryObject mover, Move move, MoveResult result, String what) {
        double way = result.fraction();
        double turn = result.turnFraction();
        boolean twice = move.rx() != 0 && move.ry() != 0;
        double yaw = twice ? Math.min(1, 2 * turn) : move.ry() != 0 ? turn : 0;
        double tip = twice ? Math.max(0, 2 * turn - 1) : move.rx() != 0 ? turn : 0;
        for (int s = 0; s <= 200; s++) {
            free(rest, after(mover, move, way * (s / 200.0), 0, 0), what, s);
            free(rest, after(mover, move, way, yaw * (s / 200.0), 0), what, s);
            free(rest, after(mover, move, way, yaw, tip * (s / 200.0)), what, s);
        }
        if (result.obstacle() == null) {
            return; // the border
        }
        boolean met = false;
        for (double more = 0x1p-50; more < 0x1p-14 && !met; more *= 2) {
            met = way < 1
                    ? rest.testObject(after(mover, move, way + more, 0, 0))
                    : tip > 0 || (yaw == 1 && move.rx() != 0)
                            ? rest.testObject(after(mover, move, 1, 1, tip + more))
                            : rest.testObject(after(mover, move, 1, yaw + more, 0));
        }
        assertThat(met).as("met just beyond: " + result + what).isTrue();
    }

    /** Two convex pieces one in the other: whatever the depth, some direction is free, and it leads out. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void noPieceIsATrap(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(23);
        RandomObjects objects = new RandomObjects(random, 0.5);
        int trapped = 0;
        int blocked = 0;
        for (int k = 0; k < Effort.cases(150); k++) {
            GeometryObject piece = objects.primitive();
            GeometryObject mover = objects.primitive().moveable("mover");
            if (k % 10 == 0) {
                mover = mover.movedTo(piece.center()); // all directions tie, or nearly
            }
            if (!world(dimension, List.of(piece)).testObject(mover)) {
                continue;
            }
            trapped++;
            int ways = 0;
            for (int way = 0; way < 48; way++) {
                double angle = way * Math.PI / 24;
                Geometry world = world(dimension, List.of(piece, mover));
                String what = dimension + " " + mover + " in " + piece + " at " + angle;
                assertThat(world.move("mover", new Move()).allowed()).as(what).isTrue();
                double up = dimension == Dimension.SPATIAL && way % 3 == 0 ? (way % 2 == 0 ? 9 : -9) : 0;
                Move out = new Move(9 * StrictMath.cos(angle), up, 9 * StrictMath.sin(angle), 0, 0);
                MoveResult result = world.moveGlobal("mover", out);
                if (result.allowed()) {
                    ways++;
                    assertThat(world.getProximity("mover", 100)).as(what).isGreaterThan(0);
                    // They have come apart: back in is refused, and only what is as thin as a thread slips by.
                    Move back = new Move(-out.x(), -out.y(), -out.z(), 0, 0);
                    if (world.moveGlobal("mover", back).allowed()) {
                        assertThat(world.getProximity("mover", 100)).as(what).isGreaterThan(0);
                    }
                } else {
                    blocked++;
                    assertThat(result.fraction()).as(what).isEqualTo(0);
                    assertThat(world.getObject("mover")).isEqualTo(mover);
                }
            }
            assertThat(ways).as(dimension + " " + mover + " in " + piece).isGreaterThan(0);
        }
        assertThat(trapped).isGreaterThan(Effort.cases(60));
        assertThat(blocked).isGreaterThan(Effort.cases(500));
    }

    @ParameterizedTest
    @EnumSource(Dimension.class)
    void fromTouchAlongAndAwayAreFreeAndIntoIsNot(Dimension dimension) {
        List<GeometryObject> movers = List.of(
                new BoxObject(new Point(-1, 0, 0), 2, 1, 1).moveable("mover"),
                new CylinderObject(new Point(-1, 0, 0), 1, 1).moveable("mover"),
                new SphereObject(new Point(-1, 0, 0), 1).moveable("mover"),
                RandomObjects.meshOf(new BoxObject(new Point(-1, 0, 0), 2, 1, 1))
                        .moveable("mover"),
                new ObjectGroup(List.of(new SphereObject(new Point(-1, 0, 0), 1))).moveable("mover"));
        BoxObject wall = new BoxObject(new Point(2, 0, 0), 4, 20, 20);
        for (GeometryObject mover : movers) {
            for (GeometryObject other : List.of(wall, RandomObjects.meshOf(wall), RandomObjects.surfaceOf(wall))) {
                for (double size : new double[] {0x1p-40, 0.1, 1, 5}) {
                    String what = dimension + " " + mover + " on " + other + " by " + size;
                    assertThat(step(dimension, mover, other, 0, size).allowed())
                            .as("along " + what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, 0, -size).allowed())
                            .as("along " + what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, -size, 0).allowed())
                            .as("away " + what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, -size, size).allowed())
                            .as("off " + what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, size, 0).allowed())
                            .as("into " + what)
                            .isFalse();
                    MoveResult into = step(dimension, mover, other, size, size);
                    assertThat(into.allowed()).as("into " + what).isFalse();
                    assertThat(into.fraction()).as("into " + what).isEqualTo(0);
                    assertThat(into.obstacle()).isEqualTo(other);
                }
            }
        }
    }

    /** What is flat has two ways out: a disc is pushed to the side on which its middle is. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aThinWallLetsGoOnTheNearerSide(Dimension dimension) {
        BoxObject wall = new BoxObject(new Point(), 0, 20, 20);
        List<GeometryObject> walls = List.of(
                wall,
                new MeshObject(
                        List.of(new Point(0, -9, -9), new Point(0, 9, -9), new Point(0, 0, 9)),
                        new int[][] {{0, 1, 2}}));
        for (GeometryObject other : walls) {
            for (double x : new double[] {-1, -0.5, -0x1p-40, 0x1p-40, 0.5, 1}) {
                for (GeometryObject mover : List.of(
                        new SphereObject(new Point(x, 0, 0), 1).moveable("mover"),
                        new CylinderObject(new Point(x, 0, 0), 1, 1).moveable("mover"),
                        new BoxObject(new Point(x, 0, 0), 2, 1, 1).moveable("mover"))) {
                    double out = Math.signum(x) * 3;
                    String what = dimension + " " + mover + " in " + other;
                    assertThat(step(dimension, mover, other, out, 0).allowed())
                            .as(what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, out, 1).allowed())
                            .as(what)
                            .isTrue();
                    assertThat(step(dimension, mover, other, -out, 0).allowed())
                            .as(what)
                            .isFalse();
                    assertThat(step(dimension, mover, other, -out, 1).allowed())
                            .as(what)
                            .isFalse();
                }
            }
        }
    }

    private static MoveResult step(
            Dimension dimension, GeometryObject mover, GeometryObject other, double x, double z) {
        Geometry world = world(dimension, List.of(mover, other));
        assertThat(world.getProximity("mover", 1)).isEqualTo(0);
        return world.moveGlobal("mover", new Move(x, 0, z, 0, 0));
    }

    /** From an overlap on, nothing is overlapped that was not at the start. */
    @ParameterizedTest
    @EnumSource(Dimension.class)
    void aMoveOutOfSomethingLeadsIntoNothingElse(Dimension dimension) {
        SplittableRandom random = new SplittableRandom(25);
        RandomObjects objects = new RandomObjects(random, 2.5);
        int made = 0;
        int cases = Effort.cases(300);
        for (int k = 0; k < cases; k++) {
            List<GeometryObject> others = new ArrayList<>();
            for (int n = 0; n < 5; n++) {
                others.add(objects.next());
            }
            GeometryObject mover = objects.next().moveable("mover");
            Geometry world = world(dimension, others);
            assertThat(world.addObjectUnchecked(mover)).isTrue();
            Move move = move(dimension, random, k);
            if (!world.moveGlobal("mover", move).allowed()) {
                assertThat(world.getObject("mover")).isEqualTo(mover);
                continue;
            }
            made++;
            others.removeIf(other -> world(dimension, List.of(other)).testObject(mover));
            wholeWayIsFree(
                    world(dimension, others),
                    mover,
                    move,
                    dimension + " " + text(mover) + " by " + move + " beside "
                            + others.stream().map(MoveLawsTest::text).toList());
        }
        assertThat(made).isBetween(cases / 10, cases * 5 / 6);
    }
}
