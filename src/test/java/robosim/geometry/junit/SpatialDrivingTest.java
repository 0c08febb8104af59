package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.Step;

/** Robots that are driven where heights count, by tests that say nothing of bodies, drives or friction. */
class SpatialDrivingTest {
    /** A platform on the ground, which is the border of the world; on it a cart and a crate. */
    private static Geometry arena() {
        Geometry world = new Geometry(20, 6, 20, Dimension.SPATIAL, Accuracy.EXACT);
        world.addObject(new BoxObject(new Point(0, -2, 0), 12, 1.5, 8).named("platform"));
        world.addObject(new BoxObject(new Point(2, -1, 0), 0.6, 0.48, 0.4).moveable("cart"));
        world.addObject(new BoxObject(new Point(4, -0.9, 0), 0.6, 0.6, 0.6).moveable("crate"));
        world.addObject(new CylinderObject(new Point(-4, -1, 3), 0.3, 0.48).moveable("drum"));
        return world;
    }

    @Test
    void aRobotDrivesAlongItsArc() {
        RobotWorld world = RobotWorld.of(arena());
        world.robot("drum").drives(0.5, 0.1).forSeconds(10);
        // A second passes until it stands and has its speed, of which friction gives it half a g.
        world.robot("drum").endsNear(0.95, 2.96, 0.08).hits("platform");
        assertThat(world.robot("drum").heading()).isBetween(0.8, 1.0);
        assertThat(world.robot("drum").center().y()).isCloseTo(-1.01, org.assertj.core.data.Offset.offset(1e-6));
        world.clock().advance(5);
        double stands = world.robot("drum").center().x();
        world.clock().advance(5);
        assertThat(world.robot("drum").center().x()).isEqualTo(stands);
    }

    @Test
    void itPushesWhatHasAMassOverTheEdgeAndTheRecordingRepeatsIt() throws IOException {
        RobotWorld world = RobotWorld.of(arena());
        world.object("crate").hasMass(5);
        world.robot("cart").drives(1, 0).forSeconds(6).isBumpedBy("crate");
        // Over the edge at x = 6, and down on the ground at -3.
        assertThat(world.object("crate").object().center().x()).isGreaterThan(6);
        assertThat(world.object("crate").object().center().y())
                .isCloseTo(-2.7, org.assertj.core.data.Offset.offset(1e-3));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        world.scenario("over the edge").write(bytes);
        List<Step> steps = new ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(bytes.toByteArray()), "file")) {
            for (Step step = reader.next(); step != null; step = reader.next()) {
                steps.add(step);
            }
        }
        Scenario read = new Scenario(world.scenario("over the edge").header(), steps);
        assertThat(Replay.of(read)).isEmpty();
        assertThat(read.steps().stream()
                        .filter(step -> step.expected() != null
                                && Objects.requireNonNull(step.expected()).bundle() instanceof StepBundle.Answer answer
                                && answer.contacts().stream()
                                        .anyMatch(contact -> contact.phase() == ContactAnswer.Phase.END)))
                .isNotEmpty();
    }
}
