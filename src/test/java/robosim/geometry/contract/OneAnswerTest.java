package robosim.geometry.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
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

/**
 * What is free of a move, and who is named, does not depend on what else is in the world: of each obstacle its own share, of
 * all of them the least. These worlds gave two answers once.
 */
class OneAnswerTest {
    private static MoveResult move(
            Dimension dimension, Accuracy accuracy, Move move, GeometryObject mover, GeometryObject... others) {
        Geometry world = new Geometry(32, 32, 32, dimension, accuracy);
        for (GeometryObject other : others) {
            assertThat(world.addObjectUnchecked(other)).isTrue();
        }
        assertThat(world.addObjectUnchecked(mover)).isTrue();
        return world.move(String.valueOf(mover.name()), move);
    }

    /** Beside either alone and beside both: one share each, and the least is answered, with its contact. */
    private static void areOne(
            Dimension dimension,
            Accuracy accuracy,
            Move move,
            GeometryObject mover,
            GeometryObject one,
            GeometryObject other) {
        MoveResult first = move(dimension, accuracy, move, mover, one);
        MoveResult second = move(dimension, accuracy, move, mover, other);
        MoveResult both = move(dimension, accuracy, move, mover, one, other);
        MoveResult swapped = move(dimension, accuracy, move, mover, other, one);
        boolean isTie = first.fraction() == second.fraction() && first.turnFraction() == second.turnFraction();
        boolean isFirst = first.fraction() < second.fraction()
                || (first.fraction() == second.fraction() && first.turnFraction() < second.turnFraction());
        assertThat(both).isEqualTo(isFirst || isTie ? first : second);
        assertThat(swapped).isEqualTo(isFirst ? first : second);
    }

    @Test
    void twoTilesMetWithinAnUlp() {
        GeometryObject one = new BoxObject(new Point(-0.95, -1, -0.95), 1.9, 2, 1.9).named("one");
        GeometryObject other = new BoxObject(new Point(-0.95, -1, 0.95), 1.9, 2, 1.9).named("other");
        GeometryObject roller = new CylinderObject(new Point(), 0.26648444218728795, 0.7239837375740199)
                .movedTo(new Point(0.7049600222152002, 0.5, -0.1845423093491796))
                .oriented(new double[] {-1, 0, 0, 0, 0, 1, 0, 1, 0})
                .moveable("roller");
        areOne(Dimension.PLANAR, Accuracy.EXACT, new Move(1, 0, -1.0273044057535794, 0, 90), roller, one, other);
    }

    /** Both are met at the start of the turn, and a place a little farther touched the other only. */
    @Test
    void twoPostsMetByATurnOfAnEnclosure() {
        GeometryObject post = new CylinderObject(new Point(), 0.47464046008549365, 1.6019641259346376)
                .movedTo(new Point(2.5, 1, 0.8683629543833078))
                .named("post");
        GeometryObject ball = new SphereObject(
                        new Point(3.684319218904953 - 0.3503550374877221, 1.4017771657722656, 0.62630515635319918),
                        0.2145828369251001)
                .named("ball");
        GeometryObject box = new BoxObject(new Point(), 0.9223136557003228, 0.7949793732222208, 1.2661037891465294)
                .movedTo(new Point(2.836652685038672, 0.922530823774852, -0.25))
                .oriented(new double[] {
                    0.8718665969137323,
                    0.1938464017726999,
                    0.4497468284555706,
                    -1.2744409706483569E-17,
                    -0.9183315008828213,
                    0.39581214545072346,
                    0.4897434401664482,
                    -0.3450953882712455,
                    -0.8006625605133856
                })
                .moveable("box");
        areOne(Dimension.SPATIAL, Accuracy.DOP, new Move(0, 0, 0, 0, -153.7029816038226), box, post, ball);
    }

    /** A group whose enclosure meets two others within rounding of each other, on the way back from the second one. */
    @Test
    void twoEnclosuresMetWithinTheirRounding() {
        GeometryObject mover = new ObjectGroup(List.of(
                        new BoxObject(new Point(1, 0, 1), 3, 2, 1).oriented(new double[] {0, 0, -1, 0, 1, 0, 1, 0, 0}),
                        new CylinderObject(new Point(-1, 0, 0), 1, 1),
                        new BoxObject(new Point(0, -1, -1), 2, 2, 2)))
                .movedTo(new Point(5, -2, -5))
                .oriented(new double[] {-1, 0, 0, 0, 1, 0, 0, 0, -1})
                .moveable("mover");
        GeometryObject ball = new SphereObject(new Point(3, 0, -2), 1).named("ball");
        BoxObject cube = new BoxObject(new Point(), 4, 4, 4);
        MeshObject mesh = RandomObjects.surfaceOf(cube).movedTo(new Point(-2, -1, 0));
        GeometryObject group = new ObjectGroup(List.of(
                        mesh,
                        new CylinderObject(new Point(1, 0, -2), 1, 2)
                                .oriented(new double[] {0, 0, 1, 0, 1, 0, -1, 0, 0}),
                        new SphereObject(new Point(1, 1, 2), 1)))
                .movedTo(new Point(2, 2, 0))
                .named("group");
        areOne(Dimension.PLANAR, Accuracy.DOP, new Move(2.5, 0, -1, 0, 0), mover, ball, group);
    }

    /** Far from the origin an enclosure is rounded outward by more: what a level's sweep allows, its test finds apart. */
    @Test
    void aMoveAllowedEndsApart() {
        // Their sides in the direction x + z, which the move does not change, are as far apart as rounding.
        GeometryObject still = new BoxObject(new Point(4.75, 0, -3.3357864376264375), 1, 1, 1)
                .turned(0, 45)
                .named("still");
        GeometryObject mover =
                new BoxObject(new Point(1, 0, -1), 1, 1, 1).turned(0, 45).moveable("mover");
        Geometry world = new Geometry(32, 32, 32, Dimension.SPATIAL, Accuracy.DOP);
        assertThat(world.addObject(still)).isTrue();
        assertThat(world.addObject(mover)).isTrue();
        MoveResult result = world.moveGlobal("mover", new Move(3, 0, -3, 0, 0));
        assertThat(result.allowed()).isFalse();
        assertThat(result.fraction()).isBetween(0.1, Math.nextDown(1.0));
        assertThat(result.obstacle()).isEqualTo(still);
        assertThat(world.getObject("mover")).isEqualTo(mover);
        // So far it may go, and is apart there.
        double most = result.fraction();
        assertThat(world.moveGlobal("mover", new Move(3 * most, 0, -3 * most, 0, 0))
                        .allowed())
                .isTrue();
        GeometryObject end = world.getObject("mover");
        assertThat(world.removeObject("mover")).isTrue();
        assertThat(world.testObject(end)).isFalse();
    }
}
