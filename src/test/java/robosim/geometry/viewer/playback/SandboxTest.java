package robosim.geometry.viewer.playback;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.viewer.Talk;

class SandboxTest {
    private static Sandbox sandbox(Accuracy accuracy, GeometryObject... objects) {
        Geometry geometry = new Geometry(20, 5, 10, Dimension.PLANAR, accuracy);
        for (GeometryObject object : objects) {
            assertThat(geometry.addObjectUnchecked(object)).isTrue();
        }
        Frame.Setting setting = Frame.Setting.of(geometry, Colours.NONE);
        return Sandbox.of(setting, setting.movers(), WorldSonars.NONE);
    }

    private static Sandbox sandbox() {
        return sandbox(Accuracy.EXACT, Talk.WALL, Talk.DRUM);
    }

    private static Point drum(Sandbox sandbox) {
        return sandbox.movers().get(0).object().center();
    }

    @Test
    void aRobotGoesWhereItMayStand() {
        Sandbox sandbox = sandbox();
        sandbox.push("drum", 5, 3, Sandbox.Push.PLACE); // behind the wall
        assertThat(sandbox.refused()).isNull();
        assertThat(drum(sandbox)).isEqualTo(new Point(5, 0, 3));
    }

    @Test
    void whereItMayNotStandItIsToldWhy() {
        Sandbox sandbox = sandbox();
        sandbox.push("drum", 1.2, 0, Sandbox.Push.PLACE);
        assertThat(drum(sandbox)).isEqualTo(new Point(-5, 0, 0));
        Sandbox.Refused refused = sandbox.refused();
        assertThat(refused).isNotNull();
        assertThat(refused.obstacles()).containsExactly(Talk.WALL);
        assertThat(refused.ghost().center()).isEqualTo(new Point(1.2, 0, 0));
        assertThat(refused.words()).isEqualTo("wall");
        sandbox.push("drum", 9.8, 0, Sandbox.Push.PLACE);
        assertThat(sandbox.refused().obstacles()).isEmpty();
        assertThat(sandbox.refused().words()).isEqualTo("the border of the world");
    }

    @Test
    void allThatIsInTheWayIsFound() {
        GeometryObject second = new CylinderObject(new Point(1, 0, 3), 1, 1).named("pole");
        Sandbox sandbox = sandbox(Accuracy.EXACT, Talk.WALL, second, Talk.DRUM);
        sandbox.push("drum", 1.5, 2, Sandbox.Push.PLACE);
        assertThat(sandbox.refused().obstacles()).containsExactly(Talk.WALL, second);
        assertThat(sandbox.refused().words()).isEqualTo("wall and 1 more");
    }

    @Test
    void aMoveNeedsItsWay() {
        Sandbox sandbox = sandbox();
        sandbox.push("drum", 5, 0, Sandbox.Push.MOVE);
        assertThat(drum(sandbox)).isEqualTo(new Point(-5, 0, 0));
        assertThat(sandbox.refused().obstacles()).containsExactly(Talk.WALL);
        sandbox.push("drum", 0, 0, Sandbox.Push.MOVE);
        assertThat(drum(sandbox)).isEqualTo(new Point(0, 0, 0));
    }

    @Test
    void aTurnMayBeRefusedToo() {
        GeometryObject bar = new BoxObject(new Point(0, 0, 0), 4, 1, 0.2).moveable("bar");
        GeometryObject post = new CylinderObject(new Point(1, 0, 1), 0.2, 1).named("post");
        Sandbox sandbox = sandbox(Accuracy.EXACT, post, bar);
        sandbox.turn("bar", -90); // over the post
        assertThat(sandbox.refused().obstacles()).containsExactly(post);
        assertThat(sandbox.movers().get(0).object().heading()).isZero();
        sandbox.turn("bar", 60);
        assertThat(sandbox.refused()).isNull();
        assertThat(sandbox.movers().get(0).object().heading()).isEqualTo(60);
    }

    @Test
    void aTippedRobotStaysTipped() {
        GeometryObject tipped =
                new CylinderObject(new Point(-5, 0, 0), 0.5, 2).turned(90, 0).moveable("drum");
        Sandbox sandbox = sandbox(Accuracy.EXACT, Talk.WALL, tipped);
        sandbox.push("drum", -4, 1, Sandbox.Push.PLACE);
        assertThat(drum(sandbox)).isEqualTo(new Point(-4, 0, 1));
        assertThat(sandbox.movers().get(0).object().pose().isUpright()).isFalse();
    }

    @Test
    void coarseWorldsAreAskedAsTheyAre() {
        // The boxes around a turned box and the drum touch; they themselves do not.
        GeometryObject turned =
                new BoxObject(new Point(2, 0, 0), 4, 1, 0.2).turned(0, 45).named("turned");
        Sandbox coarse = sandbox(Accuracy.AABB, turned, Talk.DRUM);
        coarse.push("drum", 3, 1, Sandbox.Push.PLACE);
        assertThat(coarse.refused().obstacles())
                .extracting(GeometryObject::name)
                .isEqualTo(List.of("turned"));
        Sandbox exact = sandbox(Accuracy.EXACT, turned, Talk.DRUM);
        exact.push("drum", 3, 1, Sandbox.Push.PLACE);
        assertThat(exact.refused()).isNull();
    }
}
