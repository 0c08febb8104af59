package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.Effort;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;

/** A fraction that a refused move reports is accepted when a caller multiplies the move by it, by every call. */
@Tag("slow")
class FractionTest {
    /** What blocked, in which frame. */
    private enum Regime {
        OWN_TRANSLATION,
        OWN_TURN,
        OWN_SECOND_TURN,
        GLOBAL_TRANSLATION,
        GLOBAL_TURN,
        GLOBAL_SECOND_TURN
    }

    private SplittableRandom random = new SplittableRandom(0);
    private RandomObjects objects = new RandomObjects(random, 3);
    private final Map<Regime, Integer> counts = new EnumMap<>(Regime.class);
    private Snapshot start = new Geometry().snapshot();
    private Supplier<String> scene = () -> "";
    private int edges;
    private int poses;

    @ParameterizedTest
    @CsvSource({
        "PLANAR, EXACT, 3000", "SPATIAL, EXACT, 4000", "PLANAR, DOP, 600", "SPATIAL, DOP, 600", "PLANAR, OBB, 600",
        "SPATIAL, OBB, 800", "PLANAR, AABB, 600", "SPATIAL, AABB, 600", "PLANAR, SPHERE, 600", "SPATIAL, SPHERE, 600"
    })
    void canBeUsed(Dimension dimension, Accuracy accuracy, int full) {
        random = new SplittableRandom(36 + 10 * dimension.ordinal() + accuracy.ordinal());
        objects = new RandomObjects(random, 3);
        for (Regime regime : Regime.values()) {
            counts.put(regime, 0);
        }
        int cases = Effort.costly(full, 120);
        for (int k = 0; k < cases; k++) {
            Geometry world = world(dimension, accuracy);
            for (int step = 0; step < 6; step++) {
                start = world.snapshot();
                boolean isGlobal = random.nextBoolean();
                Move move = move(dimension == Dimension.PLANAR && isGlobal);
                MoveResult result = isGlobal ? world.moveGlobal("r", move) : world.move("r", move);
                if (!result.allowed()) {
                    scene = () -> "%s %s, %s by %s, %s -> %s"
                            .formatted(
                                    dimension,
                                    accuracy,
                                    isGlobal ? "global" : "own",
                                    move,
                                    start.toGeometry().objects(),
                                    result);
                    check(move, result, isGlobal);
                    world.moveToContact("r", new Move(move.x(), move.y(), move.z(), 0, 0), 0);
                }
            }
        }
        assertThat(counts.get(Regime.OWN_TRANSLATION)).isGreaterThan(cases / 2);
        assertThat(counts.get(Regime.GLOBAL_TRANSLATION)).isGreaterThan(cases / 2);
        assertThat(counts.get(Regime.OWN_TURN)).isGreaterThan(cases / 12);
        assertThat(counts.get(Regime.GLOBAL_TURN)).isGreaterThan(cases / 20);
        assertThat(counts.get(Regime.OWN_SECOND_TURN)).isGreaterThan(cases / 50);
        assertThat(edges).isGreaterThan(accuracy == Accuracy.EXACT ? cases / 3 : -1);
        assertThat(poses).isGreaterThan(cases / 3);
    }

    /** A little more than the fraction of a translation is refused. */
    @ParameterizedTest
    @CsvSource({"PLANAR", "SPATIAL"})
    void isNotNeedlesslySmall(Dimension dimension) {
        random = new SplittableRandom(4 + dimension.ordinal());
        objects = new RandomObjects(random, 3);
        int count = 0;
        for (int k = 0; k < Effort.cases(4000); k++) {
            Geometry world = world(dimension, Accuracy.EXACT);
            Point by = objects.place();
            Move move = new Move(by.x(), by.y(), by.z(), 0, 0);
            MoveResult result = world.moveGlobal("r", move);
            Point normal = result.normal();
            double share = result.fraction();
            if (result.allowed() || normal == null || share == 0) {
                continue;
            }
            double closing = -(by.x() * normal.x() + by.y() * normal.y() + by.z() * normal.z());
            double more = share + 0x1p-37 / closing;
            if (closing > 0.01 && more <= 1) {
                count++;
                assertThat(world.moveGlobal("r", new Move(more * by.x(), more * by.y(), more * by.z(), 0, 0)))
                        .as(() -> "%s by %s of %s, %s".formatted(world.objects(), more, by, result))
                        .extracting(MoveResult::allowed)
                        .isEqualTo(false);
            }
        }
        assertThat(count).isGreaterThan(Effort.cases(4000) / 8);
    }

    /** A little more than the fraction of a turn of an upright object is refused. */
    @ParameterizedTest
    @CsvSource({"PLANAR", "SPATIAL"})
    void turnsAreNotNeedlesslyShort(Dimension dimension) {
        random = new SplittableRandom(14 + dimension.ordinal());
        objects = new RandomObjects(random, 3);
        int count = 0;
        int tooShort = 0;
        for (int k = 0; k < Effort.cases(4000); k++) {
            Geometry world = new Geometry(20, 8, 20, dimension, Accuracy.EXACT);
            world.addObject(objects.upright());
            world.addObject(objects.upright());
            if (!world.addObject(new BoxObject(objects.place(), 3, 2, 0.4).moveable("r"))) {
                continue;
            }
            double angle = random.nextDouble(-300, 300);
            MoveResult result = world.moveGlobal("r", new Move(0, 0, 0, 0, angle));
            double more = result.turnFraction() + 1e-9;
            if (!result.allowed() && more < 1) {
                count++;
                tooShort += world.simpleTurn("r", more * angle) ? 1 : 0;
            }
        }
        assertThat(count).isGreaterThan(Effort.cases(4000) / 16);
        // A turn that is stopped by contact may be told a little short.
        assertThat(tooShort).isLessThanOrEqualTo(1 + count / 500);
    }

    /** A robot that goes as far as it is told, again and again, is never refused. */
    @ParameterizedTest
    @CsvSource({"PLANAR, EXACT", "SPATIAL, EXACT", "PLANAR, AABB", "SPATIAL, SPHERE", "SPATIAL, OBB"})
    void inALoop(Dimension dimension, Accuracy accuracy) {
        random = new SplittableRandom(50 + 5 * dimension.ordinal() + accuracy.ordinal());
        objects = new RandomObjects(random, 3);
        int blocked = 0;
        for (int k = 0; k < Effort.cases(200); k++) {
            Geometry world = world(dimension, accuracy);
            for (int step = 0; step < 50; step++) {
                Move move = move(true);
                boolean isGlobal = random.nextBoolean();
                MoveResult result = isGlobal ? world.moveGlobal("r", move) : world.move("r", move);
                if (!result.allowed()) {
                    blocked++;
                    Move part = part(move, result);
                    String at = "step " + step;
                    assertThat(isGlobal ? world.moveGlobal("r", part) : world.move("r", part))
                            .as(() -> "%s, %s: %s of %s".formatted(world.objects(), at, part, move))
                            .extracting(MoveResult::allowed)
                            .isEqualTo(true);
                }
            }
        }
        assertThat(blocked).isGreaterThan(Effort.cases(200) * 10);
    }

    private Geometry world(Dimension dimension, Accuracy accuracy) {
        Geometry world = new Geometry(12, 8, 12, dimension, accuracy);
        for (int n = random.nextInt(1, 5); n > 0; n--) {
            world.addObjectUnchecked(objects.next());
        }
        if (random.nextInt(4) == 0) {
            world.addObjectUnchecked(RandomGrids.next(random, random.nextBoolean() ? 0 : objects.heading()));
        }
        GeometryObject robot = random.nextBoolean() ? objects.upright() : objects.next();
        for (int tries = 0; tries < 30 && !world.addObject(robot.moveable("r")); tries++) {
            robot = random.nextBoolean() ? objects.upright() : objects.next();
        }
        if (!world.hasObject("r")) {
            world.addObjectUnchecked(robot.movedTo(new Point()).moveable("r"));
        }
        return world;
    }

    private Move move(boolean isFlat) {
        int kind = random.nextInt(6);
        Point by =
                random.nextInt(3) == 0 ? new Point(random.nextInt(-3, 4), 0, random.nextInt(-3, 4)) : objects.place();
        boolean goes = kind < 3 || kind == 5;
        double ry = kind == 0 || kind == 1 ? 0 : angle();
        double rx = isFlat || kind == 0 || kind == 1 || kind == 3 ? 0 : angle();
        return goes
                ? new Move(by.x(), by.y(), by.z(), rx, ry)
                : new Move(0, 0, 0, rx, kind == 4 && random.nextBoolean() ? 0 : ry);
    }

    private double angle() {
        return random.nextInt(3) == 0 ? 45 * random.nextInt(-8, 9) : random.nextDouble(-200, 200);
    }

    /** What a caller asks for who is told that a share of a move is free. */
    private static Move part(Move asked, MoveResult result) {
        double share = result.fraction();
        if (share < 1) {
            return new Move(share * asked.x(), share * asked.y(), share * asked.z(), 0, 0);
        }
        double turn = result.turnFraction();
        if (asked.rx() == 0 || asked.ry() == 0) {
            return new Move(asked.x(), asked.y(), asked.z(), turn * asked.rx(), turn * asked.ry());
        }
        return turn < 0.5
                ? new Move(asked.x(), asked.y(), asked.z(), 0, 2 * turn * asked.ry())
                : new Move(asked.x(), asked.y(), asked.z(), (2 * turn - 1) * asked.rx(), asked.ry());
    }

    private void check(Move asked, MoveResult result, boolean isGlobal) {
        boolean isStraight = result.fraction() < 1;
        boolean isSecond = asked.rx() != 0 && asked.ry() != 0 && result.turnFraction() >= 0.5;
        Regime regime = Regime.values()[(isGlobal ? 3 : 0) + (isStraight ? 0 : isSecond ? 2 : 1)];
        counts.merge(regime, 1, Integer::sum);
        if (isStraight) {
            assertThat(result.turnFraction()).as(scene).isEqualTo(0);
        }
        Move part = part(asked, result);
        Geometry world = start.toGeometry();
        accepted(
                "again",
                isGlobal
                        ? world.moveGlobal("r", part).allowed()
                        : world.move("r", part).allowed());
        if (!isGlobal) {
            Geometry docked = start.toGeometry();
            docked.moveToContact("r", asked, 0);
            accepted(
                    "to contact",
                    docked.getObject("r").pose().equals(world.getObject("r").pose()));
            accepted(
                    "all of it to contact",
                    start.toGeometry().moveToContact("r", part, 0).allowed());
            if (isStraight) {
                accepted("simpleMove", start.toGeometry().simpleMove("r", part.x(), part.y(), part.z()));
            }
        } else if (part.rx() == 0) {
            if (part.x() == 0 && part.y() == 0 && part.z() == 0) {
                accepted("simpleTurn", start.toGeometry().simpleTurn("r", part.ry()));
            }
            double length = Math.abs(part.x()) + Math.abs(part.y()) + Math.abs(part.z());
            if (length == 0 || length > 1e-9) {
                places(part);
            }
        }
    }

    private void places(Move part) {
        GeometryObject robot = start.toGeometry().getObject("r");
        Point c = robot.center();
        double[] here = {c.x(), c.y(), c.z(), robot.heading()};
        double[] there = {c.x() + part.x(), c.y() + part.y(), c.z() + part.z(), robot.heading() + part.ry()};
        double[] edge = Arrays.copyOf(here, 8);
        System.arraycopy(there, 0, edge, 4, 4);
        long[] bits = new long[1];
        if (start.accuracy() == Accuracy.EXACT
                && (part.ry() == 0 || (part.x() == 0 && part.z() == 0 && part.y() == 0))) {
            edges++;
            accepted("freeEdges", start.toGeometry().freeEdges("r", edge, bits) == 1);
        }
        if (start.toGeometry().freePoses("r", here, bits) == 1) {
            poses++;
            accepted("freePoses", start.toGeometry().freePoses("r", there, bits) == 1);
            if (robot.pose().isUpright()) {
                Point end = new Point(there[0], there[1], there[2]);
                accepted("placeObject", start.toGeometry().placeObject("r", end, there[3]));
            }
        }
    }

    private void accepted(String call, boolean isAccepted) {
        assertThat(isAccepted).as(() -> call + ": " + scene.get()).isTrue();
    }
}
