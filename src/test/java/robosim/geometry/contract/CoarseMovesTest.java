package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

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
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;

/** A coarser level never allows what the exact one refuses: things that stand apart, and then turn or tip. */
@Tag("slow")
class CoarseMovesTest {
    private static final Dimension[] DIMENSIONS = Dimension.values();

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void noLevelAllowsWhatTheExactOneRefuses(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(77);
        int count = Effort.cases(1500);
        int refused = 0;
        int allowed = 0;
        for (int k = 0; k < count; k++) {
            GeometryObject mover = thing(random, k).turned(k % 5 == 0 ? 40 : 0, random.nextDouble(360));
            GeometryObject wall = thing(random, k + 1)
                    .movedTo(new Point(random.nextDouble(-6, 6), 0, random.nextDouble(-6, 6)))
                    .turned(0, random.nextDouble(360));
            double side = random.nextDouble(6, 30);
            Move move = new Move(0, 0, 0, random.nextDouble(-180, 180), k % 3 == 0 ? random.nextDouble(-90, 90) : 0);
            Dimension dimension = DIMENSIONS[k % 2];
            Geometry coarse = new Geometry(side, 30, side, dimension, accuracy);
            Geometry exact = new Geometry(side, 30, side, dimension, Accuracy.EXACT);
            if (!coarse.addObject(wall)
                    || !coarse.addObject(mover.moveable("mover"))
                    || !exact.addObject(wall)
                    || !exact.addObject(mover.moveable("mover"))) {
                continue;
            }
            boolean isFree = exact.move("mover", move).allowed();
            boolean made = coarse.move("mover", move).allowed();
            assertThat(!made || isFree)
                    .as("%s %s: %s by %s beside %s in %s", accuracy, dimension, mover, move, wall, side)
                    .isTrue();
            refused += isFree ? 0 : 1;
            allowed += made ? 1 : 0;
        }
        assertThat(refused).isGreaterThan(count / 150);
        assertThat(allowed).isGreaterThan(count / 60);
    }

    /**
     * What turns away from its middle, with little things about it: they stand beside the enclosure, but within the box of
     * the bounds about it.
     */
    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void noLevelTurnsThroughLittleThings(Accuracy accuracy) {
        SplittableRandom random = new SplittableRandom(5);
        int count = Effort.cases(1000);
        int refused = 0;
        int allowed = 0;
        for (int k = 0; k < count; k++) {
            Dimension dimension = DIMENSIONS[k % 2];
            WorldLayout layout = k % 4 < 2 ? WorldLayout.GROUPS : WorldLayout.MESHES;
            GeometryObject mover =
                    layout.next(random, List.of()).movedTo(new Point()).moveable("mover");
            Point near =
                    new Point(random.nextDouble(-1.2, 1.2), random.nextDouble(-0.5, 0.5), random.nextDouble(-1.2, 1.2));
            GeometryObject thing =
                    WorldLayout.HUGE_AMONG_TINY.next(random, List.of()).movedTo(near);
            Move move = new Move(0, 0, 0, k % 3 == 0 ? random.nextDouble(-180, 180) : 0, random.nextDouble(-180, 180));
            Geometry coarse = new Geometry(64, 64, 64, dimension, accuracy);
            Geometry exact = new Geometry(64, 64, 64, dimension, Accuracy.EXACT);
            if (!coarse.addObject(thing) || !coarse.addObject(mover)) {
                continue;
            }
            assertThat(exact.addObject(thing) && exact.addObject(mover)).isTrue();
            boolean isFree = exact.move("mover", move).allowed();
            boolean made = coarse.move("mover", move).allowed();
            assertThat(!made || isFree)
                    .as("%s %s: %s by %s beside %s", accuracy, dimension, Paste.of(mover), move, Paste.of(thing))
                    .isTrue();
            refused += isFree ? 0 : 1;
            allowed += made ? 1 : 0;
        }
        assertThat(refused).isGreaterThan(count / 55);
        assertThat(allowed).isGreaterThan(count / 4);
    }

    /** A mover beside a wall, where its enclosure and that of the wall overlap, crosses the wall or turns into it. */
    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void noLevelGoesThroughAWallFromWithinItsEnclosure(Accuracy accuracy) {
        BoxObject wall = new BoxObject(new Point(), 10, 1, 0.2);
        BoxObject cart = new BoxObject(new Point(3, 0, -0.5), 0.3, 0.3, 0.3);
        BoxObject beam = new BoxObject(new Point(0, 0, 0.4), 2, 1, 0.2);
        SphereObject ball = new SphereObject(new Point(), 0.1);
        for (Dimension dimension : DIMENSIONS) {
            refuses(dimension, accuracy, wall, ball.movedTo(new Point(4.5, 0, 0.6)), new Move(0.2, 0, -1.2, 0, 0));
            refuses(dimension, accuracy, wall, beam, new Move(0, 0, 0, 0, 90));
            refuses(dimension, accuracy, wall.turned(0, 30), cart, new Move(0, 0, -4, 0, 0));
            refuses(
                    dimension,
                    accuracy,
                    wall.turned(0, 45),
                    ball.movedTo(new Point(3, 0, -1)),
                    new Move(0, 0, -4, 0, 0));
        }
    }

    private static void refuses(
            Dimension dimension, Accuracy accuracy, GeometryObject wall, GeometryObject mover, Move move) {
        Geometry coarse = new Geometry(100, 100, 100, dimension, accuracy);
        Geometry exact = new Geometry(100, 100, 100, dimension, Accuracy.EXACT);
        for (Geometry world : List.of(coarse, exact)) {
            world.addObjectUnchecked(wall);
            assertThat(world.testObject(mover, Accuracy.EXACT)).isFalse();
            world.addObjectUnchecked(mover.moveable("mover"));
        }
        MoveResult result = coarse.move("mover", move);
        MoveResult truth = exact.move("mover", move);
        String as = "%s %s: %s by %s".formatted(dimension, accuracy, mover, move);
        assertThat(truth.allowed() || result.allowed()).as(as).isFalse();
        assertThat(result.fraction()).as(as).isLessThanOrEqualTo(truth.fraction());
        assertThat(result.turnFraction()).as(as).isLessThanOrEqualTo(truth.turnFraction());
        assertThat(result.obstacle()).as(as).isEqualTo(wall);
        if (result.fraction() == truth.fraction() && result.turnFraction() == truth.turnFraction()) {
            assertThat(result.normal()).as(as).isEqualTo(truth.normal());
        }
    }

    private static GeometryObject thing(SplittableRandom random, int k) {
        return k % 2 == 0
                ? new BoxObject(new Point(), 0.2, random.nextDouble(1, 10), random.nextDouble(0.1, 1))
                : new CylinderObject(new Point(), random.nextDouble(0.1, 0.6), random.nextDouble(1, 10));
    }
}
