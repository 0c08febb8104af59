package robosim.geometry.viewer.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.ScenarioHeader;
import robosim.geometry.scenario.ScenarioReader;
import robosim.geometry.scenario.ScenarioWriter;
import robosim.geometry.scenario.Step;
import robosim.geometry.scenario.drive.DriveRun;
import robosim.geometry.scenario.source.StepReader;
import robosim.geometry.viewer.playback.Feed;
import robosim.geometry.viewer.scene.Scene;
import robosim.geometry.world.WorldReader;

/** What the window shows of a recorded drive, where heights count and where they do not. */
class DrivenPlaybackTest {
    @ParameterizedTest
    @CsvSource({"worlds/pushing.xml, 0.8, 6", "worlds/ramp.xml, 0.8, 8"})
    void posesFollowAndContactsAreShown(String world, double speed, double seconds, @TempDir Path folder)
            throws IOException {
        Path file = folder.resolve("drive.scenario.jsonl");
        ScenarioHeader header = new ScenarioHeader("drive", SessionOptions.ROBOSIM);
        try (OutputStream out = Files.newOutputStream(file);
                ScenarioWriter writer = new ScenarioWriter(out, header)) {
            DriveRun run = new DriveRun(
                    WorldReader.read(Path.of(world)), List.of(), List.of(new DriveCommand("cart", speed, 0)), writer);
            for (int step = 0; step < seconds / 0.05; step++) {
                run.step(0.05);
            }
        }
        List<Step> steps = Scenario.read(file).steps();
        ViewerModel viewing;
        try (Feed feed = new Feed(StepReader.of(ScenarioReader.of(Files.newInputStream(file), "drive")))) {
            viewing = ViewerModel.ofRecording(feed, "drive", "m");
            viewing.camera.resize(1000, 600);
            viewing.player.pause();
            while (!feed.isEnded()) {
                viewing.tick(0);
                Thread.onSpinWait();
            }
            viewing.tick(0);
            int bumps = 0;
            for (int k = 1; k < steps.size(); k++) {
                StepBundle.Answer answer = (StepBundle.Answer)
                        Objects.requireNonNull(steps.get(k).expected()).bundle();
                viewing.player.seek(k);
                viewing.tick(0);
                Scene life = viewing.life();
                Map<String, GeometryObject> shown = new TreeMap<>();
                life.things()
                        .forEach(
                                thing -> shown.put(String.valueOf(thing.object().name()), thing.object()));
                for (BodyAnswer body : answer.bodies()) {
                    GeometryObject there = Objects.requireNonNull(shown.get(body.objectName()));
                    assertThat(there.center()).as("step %d", k).isEqualTo(body.center());
                    if (body.rotation().size() == 0) {
                        assertThat(Degrees.toRadians(there.heading()))
                                .as("step %d", k)
                                .isEqualTo(body.heading());
                    } else {
                        assertThat(there.rotation())
                                .as("step %d", k)
                                .containsExactly(body.rotation().values());
                    }
                }
                if (isBump(answer)) {
                    bumps++;
                    assertThat(life.refusals()).as("step %d", k).isNotEmpty();
                    assertThat(life.blocked()).as("step %d", k).isNotEmpty();
                }
            }
            assertThat(bumps).isPositive();
            assertThat(steps).hasSizeGreaterThan(100);
        }
    }

    /** Whether bodies have begun to touch something beside them. */
    private static boolean isBump(StepBundle.Answer answer) {
        return answer.contacts().stream()
                .anyMatch(contact -> contact.phase() == ContactAnswer.Phase.BEGIN
                        && Math.abs(contact.normal().y()) <= 0.5);
    }
}
