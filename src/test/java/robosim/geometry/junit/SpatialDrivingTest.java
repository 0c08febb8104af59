package robosim.geometry.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
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
@Tag("slow")
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
    void aFailureSaysWhyARobotWasStopped() {
        Geometry arena = arena();
        arena.addObjectUnchecked(new BoxObject(new Point(-2, -1.1, 0), 0.6, 0.48, 0.4).moveable("sunk"));
        RobotWorld world = RobotWorld.of(arena);
        Robot sunk = world.robot("sunk").drives(1, 0).forSeconds(1);
        assertThatThrownBy(() -> sunk.endsNear(-1, 0, 0.1))
                .hasMessageContaining("; step 10 stopped \"sunk\" (OVERLAP by \"platform\")");
        Robot cart = world.robot("cart").drives(1, 0).forSeconds(0.1);
        assertThatThrownBy(() -> cart.endsNear(-1, 0, 0.1)).message().doesNotContain("stopped");
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

    private static Geometry floor(boolean isThere) {
        Geometry world = new Geometry(20, 4, 20, Dimension.SPATIAL, Accuracy.EXACT);
        if (isThere) {
            world.addObject(new BoxObject(new Point(0, -0.0625, 0), 20, 0.125, 20).named("ground_plane"));
        }
        world.addObject(new BoxObject(new Point(3, 0.5, 0), 0.1, 0.9, 8).named("wall"));
        world.addObjectUnchecked(new CylinderObject(new Point(0, 0.1, 0), 0.2, 0.2).moveable("scout"));
        return world;
    }

    /** On a floor a robot hits a wall, and without one it drives below: neither is nothing. */
    @Test
    void aFloorIsNothingAndAFallIsNot() {
        RobotWorld there = RobotWorld.of(floor(true));
        there.robot("scout").neverTouchesAnything().drives(0.5, 0).forSeconds(4);
        there.robot("scout").hitsNothing();
        assertThat(there.robot("scout").center().y()).isCloseTo(0.1, org.assertj.core.data.Offset.offset(1e-6));
        RobotWorld missing = RobotWorld.of(floor(false));
        missing.robot("scout").drives(0.5, 0).forSeconds(4);
        assertThatThrownBy(() -> missing.robot("scout").hitsNothing())
                .isInstanceOf(AssertionError.class)
                .hasMessageContainingAll("the lower border of the world after a fall of 2", "add one to the world");
        assertThatThrownBy(() -> missing.robot("scout").neverTouchesAnything())
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("after a fall of 2");
        there.robot("scout").drives(0.5, 0);
        assertThatThrownBy(() -> there.clock().advance(60))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("it met box \"wall\"");
    }

    /** From a table onto a floor it has fallen too, and hits it. */
    @Test
    void aFallOntoAFloorIsAHit() {
        Geometry world = floor(true);
        world.addObjectUnchecked(new BoxObject(new Point(-4, 0.25, 0), 2, 0.5, 2).named("table"));
        world.addObjectUnchecked(new CylinderObject(new Point(-4, 0.6, 0), 0.2, 0.2).moveable("drum"));
        RobotWorld fallen = RobotWorld.of(world);
        fallen.robot("drum").drives(0.5, 0).forSeconds(1);
        fallen.robot("drum").hitsNothing();
        fallen.robot("drum").drives(0.5, 0);
        fallen.clock().advance(40);
        assertThat(fallen.robot("drum").center().y()).isLessThan(0.3);
        assertThatThrownBy(() -> fallen.robot("drum").hitsNothing()).hasMessageContaining("\"ground_plane\"");
    }
}
