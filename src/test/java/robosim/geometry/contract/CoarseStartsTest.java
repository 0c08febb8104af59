package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
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
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/**
 * Whatever EXACT refuses, every level refuses at the same fraction or before, from every kind of start; some two
 * thousand motions for each level in an ordinary build, a million under {@code -Pstress}.
 *
 * <p>The system properties {@code stress.levels} and {@code stress.seed} are how many motions there are for each level and
 * where they start.
 */
@Tag("slow")
class CoarseStartsTest {
    private static final int CASES = Integer.getInteger("stress.levels", Effort.cases(8_000));
    private static final long SEED = Long.getLong("stress.seed", 20_261_126);
    private static final int ASKED = 20;
    private static final Dimension[] DIMENSIONS = Dimension.values();

    /** How the mover begins beside the others. */
    enum Start {
        APART,
        /** Only the enclosures overlap. */
        ENCLOSED,
        /** Just before what a motion was stopped by. */
        DOCKED,
        /** Flush with a side, to the bit. */
        FLUSH,
        OVERLAPPING
    }

    /** What is asked. */
    enum Kind {
        MOVE,
        TURN,
        BOTH,
        GLOBAL,
        DOCK,
        SLIDE
    }

    /** A mover and what stands about it, in a world at EXACT and in one at a level. */
    private static final class Scene {
        final Accuracy level;
        final SplittableRandom random;
        final Dimension dimension;
        final List<GeometryObject> others = new ArrayList<>();
        final Geometry exact;
        final Geometry coarse;
        GeometryObject mover;
        final Start start;
        final boolean isFreeAtLevel;

        /** Whether there are primitives only, which are quicker to ask about. */
        final boolean isPlain;

        Scene(Accuracy level, SplittableRandom random, int number) {
            this.level = level;
            this.random = random;
            dimension = DIMENSIONS[number % 2];
            RandomObjects objects = new RandomObjects(random, 2.5);
            isPlain = random.nextInt(4) != 0;
            boolean isFlush = number / 2 % 4 == 0;
            GeometryObject body = isFlush ? upright() : robot(objects, number);
            mover = body.moveable("mover");
            if (isFlush) {
                others.add(flush(body));
            }
            for (int k = random.nextInt(isFlush ? 2 : 3); k >= 0; k--) {
                others.add(obstacle(objects));
            }
            double side = random.nextInt(6) == 0 ? 8 : 64;
            exact = new Geometry(side, 64, side, dimension, Accuracy.EXACT);
            coarse = new Geometry(side, 64, side, dimension, level);
            others.removeIf(other -> !exact.addObjectUnchecked(other));
            others.forEach(coarse::addObjectUnchecked);
            if (!exact.addObjectUnchecked(mover)) {
                mover = new SphereObject(new Point(), 0.25).moveable("mover");
                exact.addObjectUnchecked(mover);
            }
            exact.removeObject("mover");
            boolean touches = exact.testObject(mover);
            boolean isDocked = !touches && number / 2 % 4 == 1;
            if (isDocked) {
                exact.addObjectUnchecked(mover);
                exact.moveToContact("mover", translation(4), random.nextBoolean() ? 0 : 0x1p-40);
                mover = exact.getObject("mover");
            }
            isFreeAtLevel = !coarse.testObject(mover);
            reset(exact);
            reset(coarse);
            start = touches
                    ? isFlush ? Start.FLUSH : Start.OVERLAPPING
                    : isDocked ? Start.DOCKED : isFreeAtLevel ? Start.APART : Start.ENCLOSED;
        }

        private GeometryObject robot(RandomObjects objects, int number) {
            return switch (number % 3) {
                case 0 -> isPlain ? objects.primitive() : objects.next();
                case 1 -> objects.upright();
                default ->
                    new BoxObject(objects.place(), 0.2, random.nextDouble(0.2, 1), random.nextDouble(0.1, 3))
                            .turned(random.nextInt(3) == 0 ? 30 : 0, objects.heading());
            };
        }

        private GeometryObject obstacle(RandomObjects objects) {
            return switch (random.nextInt(6)) {
                case 0, 1 ->
                    new BoxObject(objects.place(), random.nextDouble(4, 10), 1, 0.2).turned(0, objects.heading());
                case 2 -> isPlain ? objects.upright() : RandomGrids.next(random, objects.heading());
                default -> isPlain ? objects.primitive() : objects.next();
            };
        }

        /** A body whose sides lie at multiples of an eighth. */
        private GeometryObject upright() {
            Point center = new Point(eighths(-8, 8), eighths(-8, 8), eighths(-8, 8));
            double size = eighths(1, 6);
            return switch (random.nextInt(3)) {
                case 0 ->
                    new BoxObject(center, 2 * size, 2 * size, 2 * eighths(1, 8)).turned(0, 90 * random.nextInt(4));
                case 1 -> new CylinderObject(center, size, 2 * size);
                default -> new SphereObject(center, size);
            };
        }

        /** What touches a body in a plane: a floor below it, or a wall beside it. */
        private GeometryObject flush(GeometryObject body) {
            Point c = body.center();
            double y = body instanceof BoxObject box ? box.height() / 2 : radius(body);
            if (dimension == Dimension.SPATIAL && random.nextBoolean()) {
                BoxObject floor = new BoxObject(
                        new Point(c.x() + eighths(-4, 4), c.y() - y - 0.25, c.z()), eighths(1, 32), 0.5, 4);
                return random.nextBoolean() ? floor : RandomObjects.surfaceOf(floor);
            }
            double x = body instanceof BoxObject box
                    ? (Math.abs(box.heading()) == 90 ? box.length() : box.width()) / 2
                    : radius(body);
            BoxObject wall =
                    new BoxObject(new Point(c.x() + x + 0.125, c.y(), c.z() + eighths(-8, 8)), 0.25, 2, eighths(1, 40));
            return random.nextBoolean() ? wall : RandomObjects.surfaceOf(wall);
        }

        private static double radius(GeometryObject body) {
            return body instanceof CylinderObject cylinder ? cylinder.radius() : ((SphereObject) body).radius();
        }

        private double eighths(int least, int most) {
            return random.nextInt(least, most + 1) / 8.0;
        }

        Move translation(double far) {
            double length = random.nextInt(4) == 0 ? 0.01 : far;
            double x = random.nextDouble(-length, length);
            double y = random.nextInt(3) == 0 ? random.nextDouble(-length, length) / 4 : 0;
            double z = random.nextDouble(-length, length);
            return switch (random.nextInt(6)) {
                case 0 -> new Move(x, 0, 0, 0, 0);
                case 1 -> new Move(0, 0, z, 0, 0);
                case 2 -> new Move(0, dimension == Dimension.SPATIAL ? x : 0, 0, 0, 0);
                default -> new Move(x, y, z, 0, 0);
            };
        }

        Move move(Kind kind) {
            Move way = kind == Kind.TURN ? new Move() : translation(5);
            double most = random.nextInt(4) == 0 ? 2 : 180;
            double ry = random.nextInt(4) == 0 ? 0 : random.nextDouble(-most, most);
            double rx = random.nextInt(3) == 0 || ry == 0 ? random.nextDouble(-most, most) : 0;
            return kind == Kind.MOVE || (kind != Kind.TURN && kind != Kind.BOTH && random.nextBoolean())
                    ? way
                    : new Move(way.x(), way.y(), way.z(), rx, ry);
        }

        /** Puts the mover back to its start. */
        void reset(Geometry world) {
            world.removeObject("mover");
            world.addObjectUnchecked(mover);
        }

        String asText(Move move) {
            return "%s %s %s: %s by %s beside\n    %s"
                    .formatted(
                            level,
                            dimension,
                            start,
                            Paste.of(mover),
                            move,
                            others.stream().map(CoarseStartsTest::text).toList());
        }
    }

    private static String text(GeometryObject object) {
        return object.kind() == GeometryObject.Kind.GRID ? object.toString() : Paste.of(object);
    }

    /** How many motions there were, how many of them EXACT refused, and how many the level allowed. */
    private static final class Count {
        int asked;
        int refused;
        int allowed;

        Count add(Count more) {
            asked += more.asked;
            refused += more.refused;
            allowed += more.allowed;
            return this;
        }

        @Override
        public String toString() {
            return asked + " asked, " + refused + " refused at EXACT, " + allowed + " allowed at the level";
        }
    }

    @ParameterizedTest
    @EnumSource(names = "EXACT", mode = EnumSource.Mode.EXCLUDE)
    void whatExactRefusesEveryLevelRefuses(Accuracy level) {
        SplittableRandom random = new SplittableRandom(SEED + level.ordinal());
        Count[][] counts = new Count[Start.values().length][Kind.values().length];
        for (Count[] row : counts) {
            Arrays.setAll(row, k -> new Count());
        }
        Count plain = new Count();
        for (int k = 0; k < CASES; k += ASKED) {
            Scene scene = new Scene(level, random, k / ASKED);
            for (int q = 0; q < ASKED; q++) {
                Kind kind = Kind.values()[random.nextInt(Kind.values().length)];
                Count count = new Count();
                ask(scene, kind, count);
                counts[scene.start.ordinal()][kind.ordinal()].add(count);
                plain.add(scene.isPlain ? count : new Count());
            }
        }
        report(level, counts);
        for (Start start : Start.values()) {
            for (Kind kind : Kind.values()) {
                Count count = counts[start.ordinal()][kind.ordinal()];
                String regime = level + " " + start + " " + kind + ": " + count;
                assertThat(count.asked).as(regime).isGreaterThan(CASES / 400);
                // A sphere sweeps next to nothing when it turns about its middle.
                boolean isRare = level == Accuracy.SPHERE && start == Start.APART && kind == Kind.TURN;
                assertThat(count.refused).as(regime).isGreaterThan(isRare ? -1 : count.asked / 200);
                assertThat(count.allowed).as(regime).isGreaterThan(count.asked / 200);
            }
        }
        Count all = Stream.of(counts).flatMap(Stream::of).reduce(new Count(), Count::add);
        assertThat(plain.asked).as("%s of %s", plain, all).isBetween(CASES * 6 / 10, CASES * 8 / 10);
        assertThat(plain.refused).as("%s of %s", plain, all).isBetween(all.refused / 3, all.refused * 4 / 5);
        assertThat(plain.allowed).as("%s of %s", plain, all).isBetween(all.allowed / 3, all.allowed * 19 / 20);
    }

    private static void report(Accuracy level, Count[][] counts) {
        if (!Boolean.getBoolean("robosim.stress")) {
            return;
        }
        for (Start start : Start.values()) {
            for (Kind kind : Kind.values()) {
                System.out.println(level + " " + start + " " + kind + ": " + counts[start.ordinal()][kind.ordinal()]);
            }
        }
    }

    private static void ask(Scene scene, Kind kind, Count count) {
        Move move = scene.move(kind);
        count.asked++;
        if (kind == Kind.SLIDE) {
            slide(scene, move, count);
            return;
        }
        double clearance = scene.random.nextBoolean() ? 0 : scene.random.nextDouble(0.2);
        MoveResult truth = made(scene.exact, kind, move, clearance);
        MoveResult result = made(scene.coarse, kind, move, clearance);
        if (!result.allowed() || !truth.allowed()) {
            assertThat(result.allowed()).as(() -> scene.asText(move)).isFalse();
            assertThat(result.fraction()).as(() -> scene.asText(move)).isLessThanOrEqualTo(truth.fraction());
            if (truth.fraction() == result.fraction()) {
                assertThat(result.turnFraction())
                        .as(() -> scene.asText(move))
                        .isLessThanOrEqualTo(truth.turnFraction());
            }
        }
        count.refused += truth.allowed() ? 0 : 1;
        count.allowed += result.allowed() ? 1 : 0;
        GeometryObject end = scene.coarse.getObject("mover");
        scene.reset(scene.exact);
        scene.reset(scene.coarse);
        if (result.allowed() && scene.isFreeAtLevel) {
            scene.coarse.removeObject("mover");
            assertThat(scene.coarse.testObject(end))
                    .as(() -> scene.asText(move))
                    .isFalse();
            scene.reset(scene.coarse);
        }
        askWithoutFractions(scene, kind, move, truth, result);
    }

    private static MoveResult made(Geometry world, Kind kind, Move move, double clearance) {
        return switch (kind) {
            case MOVE, TURN, BOTH, SLIDE -> world.move("mover", move);
            case GLOBAL -> world.moveGlobal("mover", move);
            case DOCK -> world.moveToContact("mover", move, clearance);
        };
    }

    /** The interfaces that only say whether all of it is free. */
    private static void askWithoutFractions(Scene scene, Kind kind, Move move, MoveResult truth, MoveResult result) {
        if (kind == Kind.MOVE) {
            boolean made = scene.coarse.simpleMove("mover", move.x(), move.y(), move.z());
            assertThat(made).as(() -> scene.asText(move)).isEqualTo(result.allowed());
            scene.reset(scene.coarse);
        }
        if (kind == Kind.TURN) {
            boolean made = scene.coarse.simpleTurn("mover", move.ry());
            assertThat(made && !scene.exact.simpleTurn("mover", move.ry()))
                    .as(() -> scene.asText(move))
                    .isFalse();
            scene.reset(scene.exact);
            scene.reset(scene.coarse);
        }
        if (kind == Kind.GLOBAL && move.rx() == 0) {
            Point c = scene.mover.center();
            double heading = scene.mover.heading();
            double[] edge = {
                c.x(), c.y(), c.z(), heading, c.x() + move.x(), c.y() + move.y(), c.z() + move.z(), heading + move.ry()
            };
            boolean free = scene.coarse.freeEdges("mover", edge, new long[1]) == 1;
            assertThat(free && scene.exact.freeEdges("mover", edge, new long[1]) == 0)
                    .as(() -> scene.asText(move))
                    .isFalse();
        }
    }

    /** A slide ends where nothing is touched that was not at its start. */
    private static void slide(Scene scene, Move move, Count count) {
        boolean isBlocked = !scene.exact.move("mover", move).allowed();
        scene.reset(scene.exact);
        scene.coarse.moveAndSlide("mover", move, scene.random.nextInt(3) * 0.05, 4);
        GeometryObject end = scene.coarse.getObject("mover");
        boolean isMoved = !end.equals(scene.mover);
        scene.reset(scene.coarse);
        if (scene.start == Start.APART || scene.start == Start.ENCLOSED || scene.start == Start.DOCKED) {
            scene.exact.removeObject("mover");
            assertThat(scene.exact.testObject(end)).as(() -> scene.asText(move)).isFalse();
            scene.reset(scene.exact);
        }
        count.refused += isBlocked ? 1 : 0;
        count.allowed += isMoved ? 1 : 0;
    }
}
