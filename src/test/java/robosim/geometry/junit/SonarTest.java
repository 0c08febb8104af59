package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Point;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Step;
import robosim.geometry.world.WorldReader;

/** The sonars of the world's file, and cones. */
class SonarTest {
    private static final String XML = """
            <world xmlns="urn:robosim:world:1" width="20" height="2" length="20" unit="m">
              <box name="post" center="3 0 0.5" width="0.2" height="1" length="0.2"/>
              <box name="wall" center="0 0 -4" width="9" height="1" length="0.2"/>
              <cylinder name="r" moveable="true" center="0 0 0" radius="0.2" height="0.5">
                <sonar count="2" first="0" step="90" min="0.3" max="3.5" width="30"/>
                <sonar count="1" first="-90" min="0" max="2" width="0"/>
              </cylinder>
              <box name="bare" moveable="true" center="-6 0 6" width="1" height="1" length="1"/>
            </world>""";

    private static RobotWorld world() {
        try {
            return RobotWorld.from(
                    WorldReader.read(new ByteArrayInputStream(XML.getBytes(StandardCharsets.UTF_8)), "here", null));
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void whatTheSonarsOfTheFileRead() {
        Robot robot = world().robot("r");
        // The post is within the cone, though a line ahead passes it.
        assertThat(robot.sonar(0).reads()).isBetween(2.9, 3.0);
        assertThat(robot.range(0)).isInfinite();
        robot.sonar(0).isAtMost(3).sonar(0).isAtLeast(2.9);
        robot.sonar(0).isAtLeast(2.9).isAtMost(3).turns(0);
        assertThat(robot.sonar(1).direction()).isEqualTo(90);
        robot.sonar(1).readsNothing().sonar(2).readsNothing(); // the wall is 3.9 away
        assertThat(robot.sonars()).hasSize(3).endsWith(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        assertThatThrownBy(() -> robot.sonar(0).readsNothing())
                .isInstanceOf(AssertionFailedError.class)
                .hasMessageContaining("was to read nothing by its sonar 0, at 0 degrees, but it reads 2.9");
        assertThatThrownBy(() -> robot.sonar(1).isAtMost(1))
                .hasMessageContaining(
                        "was to read at most 1 by its sonar 1, at 90 degrees, but it reads nothing within its range of 3.5");
        assertThatThrownBy(() -> robot.sonar(0).isAtLeast(3)).hasMessageContaining("was to read at least 3");
    }

    @Test
    void whichSonarsThereAre() {
        RobotWorld world = world();
        assertThatThrownBy(() -> world.robot("r").sonar(3)).hasMessageContaining("number must be 0 to 2");
        assertThatThrownBy(() -> world.robot("r").sonar(-1)).hasMessageContaining("number must be 0 to 2");
        assertThatThrownBy(() -> world.robot("bare").sonar(0)).hasMessageContaining("must have a <sonar>");
        Geometry made = new Geometry(9, 9, 9);
        made.addObject(new BoxObject(new Point(), 1, 1, 1).moveable("r"));
        assertThat(RobotWorld.of(made).robot("r").sonars()).isEmpty();
    }

    @Test
    void cones() {
        Robot robot = world().robot("r");
        robot.senses(0, 3, 30).sensesNothing(0, 3, 5).sensesNothing(0, 2.8, 30);
        assertThat(robot.range(0, 30)).isEqualTo(robot.sonar(0).reads());
        assertThatThrownBy(() -> robot.senses(180, 9, 40))
                .hasMessageContaining(
                        "was to sense something within 9 in a cone of 40 degrees at 180 degrees, but nothing"
                                + " echoes there at any distance");
        assertThatThrownBy(() -> robot.sensesNothing(0, 3, 30)).hasMessageContaining("but the first echo is 2.9");
        assertThatThrownBy(() -> robot.senses(0, 1, 180)).hasMessageContaining("width must be 0 to below 180");
    }

    /** What was measured is in the scenario, bit for bit. */
    @Test
    void theyAreRecorded() {
        RobotWorld world = world();
        world.robot("r").sonars();
        world.robot("r").range(10, 33.3);
        Replay replay = new Replay(world.scenario("sonars").header().options());
        for (Step step : world.scenario("sonars").steps()) {
            assertThat(replay.step(step)).isNull();
        }
        assertThat(replay.compared()).isEqualTo(4);
    }
}
