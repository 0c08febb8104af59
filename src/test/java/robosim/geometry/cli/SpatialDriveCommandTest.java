package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.scenario.Scenario;

/** The command that drives robots, and what repeats it, in a world in which heights count. */
@Tag("slow")
class SpatialDriveCommandTest {
    private static final String WORLD = "worlds/ramp.xml";

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Commands.run(new PrintWriter(out), new PrintWriter(err), arguments);
    }

    @Test
    void aCartClimbsPushesAndFalls(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("out.scenario.jsonl");
        assertThat(run("drive", WORLD, "--tell", "cart=0.8", "--seconds", "11", "--record", file.toString()))
                .as(err.toString())
                .isLessThan(2);
        assertThat(out.toString())
                .containsPattern("\"cart\" at \\([-0-9.]+, [-0-9.]+, [-0-9.]+\\).*met .*\"ramp\".*\"deck\".*\"crate\"");
        Scenario scenario = Scenario.read(file);
        double highest = -9;
        StepBundle.Answer last = null;
        for (var step : scenario.steps()) {
            if (step.expected() != null && step.expected().bundle() instanceof StepBundle.Answer answer) {
                last = answer;
                highest = Math.max(highest, cart(answer).center().y());
            }
        }
        // Up on the deck, whose top is 0.62 m above the floor, and in the end on the floor beyond it.
        assertThat(highest).isBetween(-0.24, -0.15);
        assertThat(cart(Objects.requireNonNull(last)).center().y()).isLessThan(-0.7);
        assertThat(cart(last).center().x()).isGreaterThan(3.5);
        assertThat(run("check", WORLD)).as(out.toString()).isZero();
        Path page = folder.resolve("out.html");
        assertThat(run("export", file.toString(), page.toString()))
                .as(err.toString())
                .isZero();
        assertThat(Files.size(page)).isGreaterThan(10_000);
    }

    @Test
    void whatHasNoNameIsToldByWhatItIs(@TempDir Path folder) throws IOException {
        Path world = Files.writeString(folder.resolve("hall.xml"), """
                <world xmlns="urn:robosim:world:1" width="8" height="4" length="8" unit="m">
                  <box center="1.5 -1 0" width="1" height="2" length="2"/>
                  <cylinder name="cart" moveable="true" center="0 -1.7 0" radius="0.2" height="0.5"/>
                  <cylinder name="mule" moveable="true" center="0 -1.7 3" radius="0.2" height="0.5"/>
                </world>
                """);
        assertThat(run("drive", world.toString(), "--tell", "cart=1", "--seconds", "6"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString()).contains("met the ground, a box at (1.5, -1, 0) (");
        assertThat(run("drive", world.toString(), "--planar", "--tell", "mule=-1", "--seconds", "6"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString()).contains("; met the border of the world (");
    }

    /** Without a ground plane a robot drives under the walls. */
    @Test
    void aFallToTheBottomOfTheWorldIsTold(@TempDir Path folder) throws IOException {
        String ground = """
                <model name='ground_plane'><static>1</static><link name='l'><collision name='c'><geometry><plane/></geometry>
                </collision></link></model>
                """;
        Path world = Files.writeString(folder.resolve("lab.sdf"), """
                <sdf version='1.9'><world name='w'>
                <model name='bot'><pose>0 0 0.25 0 0 0</pose><link name='l'><collision name='c'><geometry><box>
                <size>0.5 0.5 0.5</size></box></geometry></collision></link></model>
                </world></sdf>
                """);
        assertThat(run("drive", world.toString(), "--seconds", "2"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .containsPattern("\"bot\" has fallen 2 m, onto the lower border of the world; if there should have been"
                        + " a floor, add one to the world, or drive with --planar");
        out.getBuffer().setLength(0);
        Path floor = Files.writeString(folder.resolve("floor.xml"), """
                <world xmlns="urn:robosim:world:1" width="8" height="4" length="8" unit="m">
                  <include file="lab.sdf"/>
                  <box name="floor" center="0 -0.5 0" width="8" height="1" length="8"/>
                </world>
                """);
        assertThat(run("drive", floor.toString(), "--seconds", "2"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .containsPattern("\"bot\" at \\((1|0.9\\d*), 0.25, 0\\).*; met \"floor\"")
                .doesNotContain("fallen");
        Files.writeString(world, Files.readString(world).replace("</world>", ground + "</world>"));
        out.getBuffer().setLength(0);
        assertThat(run("drive", world.toString(), "--seconds", "2"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString())
                .containsPattern("\"bot\" at \\((1|0.9\\d*), 0.25, 0\\).*; met \"ground_plane\"")
                .doesNotContain("fallen");
        out.getBuffer().setLength(0);
        assertThat(run("drive", world.toString(), "--seconds", "2", "--planar"))
                .as(err.toString())
                .isZero();
        assertThat(out.toString() + err).contains("\"bot\" at (1, 0), ").doesNotContain("fallen", "ground_plane");
    }

    /** For a moment only: what rolls along in front of a robot takes many slices of a step. */
    @Test
    void aRoverPushesTheBall(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("out.scenario.jsonl");
        assertThat(run(
                        "drive",
                        WORLD,
                        "--tell",
                        "cart=0.8",
                        "--tell",
                        "rover=0.5",
                        "--seconds",
                        "5.5",
                        "--record",
                        file.toString()))
                .as(err.toString())
                .isLessThan(2);
        assertThat(out.toString()).containsPattern("\"ball\" .*met .*\"rover\"");
        assertThat(run("replay", file.toString())).isZero();
        Path results = folder.resolve("sweep.jsonl");
        assertThat(run("sweep", file.toString(), "-n", "1", "-p", "place=0,0.02", "--out", results.toString()))
                .as(err.toString())
                .isZero();
        assertThat(Files.readString(results)).contains("stopped");
    }

    private static BodyAnswer cart(StepBundle.Answer answer) {
        return answer.bodies().stream()
                .filter(body -> body.objectName().equals("cart"))
                .findFirst()
                .orElseThrow();
    }
}
