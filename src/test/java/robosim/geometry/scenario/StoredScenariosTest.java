package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;

/** The files of worlds/scenarios: replayed to the bit, as they were recorded, and able to tell a changed bit. */
class StoredScenariosTest {
    private static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(StoredScenarios.FOLDER)) {
            return files.sorted().toList();
        }
    }

    @Test
    void eachIsAnsweredAsItWasRecorded() throws IOException {
        assertThat(files()).hasSizeGreaterThan(12);
        for (Path file : files()) {
            Scenario scenario = Scenario.read(file);
            assertThat(Replay.of(scenario)).as("%s", file).isEmpty();
            assertThat(scenario.torn()).as("%s", file).isZero();
            assertThat(Files.size(file)).as("%s", file).isLessThan(50_000);
        }
    }

    @Test
    void eachRecordingIsTheOneOfItsConversation() throws IOException {
        for (var entry : StoredScenarios.all().entrySet()) {
            assertThat(Files.readString(StoredScenarios.file(entry.getKey())))
                    .as(entry.getKey())
                    .isEqualTo(new String(entry.getValue().recorded(), StandardCharsets.UTF_8));
        }
    }

    @Test
    void theyHoldMovesMadeAndRefusedAndDistancesOfEveryKind() throws IOException {
        int made = 0;
        int refused = 0;
        int near = 0;
        int none = 0;
        int unknown = 0;
        for (Path file : files()) {
            for (Step step : Scenario.read(file).steps()) {
                if (step.expected() != null && step.expected().bundle() instanceof MoveBundle moves) {
                    made += moves.moves().size();
                    refused += ((MoveBundle) step.request()).moves().size()
                            - moves.moves().size();
                } else if (step.expected() != null) {
                    for (double distance : ((DistanceBundle) step.expected().bundle()).distances()) {
                        near += distance < Double.POSITIVE_INFINITY ? 1 : 0;
                        none += distance == Double.POSITIVE_INFINITY ? 1 : 0;
                        unknown += Double.isNaN(distance) ? 1 : 0;
                    }
                }
            }
        }
        assertThat(made).isGreaterThan(30);
        assertThat(refused).isGreaterThan(20);
        assertThat(near).isGreaterThan(80);
        assertThat(none).isGreaterThan(20);
        assertThat(unknown).isGreaterThan(3);
    }

    @Test
    void recordedAgainEachIsTheSameFile() throws IOException {
        for (String name : StoredScenarios.all().keySet()) {
            Scenario scenario = Scenario.read(StoredScenarios.file(name));
            ByteArrayOutputStream again = new ByteArrayOutputStream();
            try (Recorder recorder = new Recorder(name, () -> new ScenarioWriter(again, scenario.header()), null)) {
                Replay replay = new Replay(scenario.header().options(), recorder);
                for (Step step : scenario.steps()) {
                    step.notes().forEach(recorder::note);
                    assertThat(replay.step(step)).isNull();
                }
            }
            assertThat(again).as(name).hasToString(Files.readString(StoredScenarios.file(name)));
            ByteArrayOutputStream written = new ByteArrayOutputStream();
            scenario.write(written);
            assertThat(written).as(name).hasToString(Files.readString(StoredScenarios.file(name)));
        }
    }

    @Test
    void aWorldFileIsWrittenOutAndReplaysAsBefore() throws IOException {
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        Scenario byHand = Scenario.read(StoredScenarios.file("by-hand"));
        byHand.write(written);
        List<Mismatch> found = new ArrayList<>();
        Replay replay =
                Replay.of(ScenarioReader.of(new ByteArrayInputStream(written.toByteArray()), "written"), found::add);
        assertThat(found).isEmpty();
        assertThat(replay.steps()).isEqualTo(4);
        assertThat(replay.compared()).isEqualTo(3);
    }

    /** In each step of each scenario the last bit of one number of the answer is another. */
    @Test
    void aChangedBitIsFound() throws IOException {
        int changed = 0;
        for (Path file : files()) {
            Scenario scenario = Scenario.read(file);
            for (int k = 0; k < scenario.steps().size(); k++) {
                Reply other = changed(scenario.steps().get(k).expected());
                if (other == null) {
                    continue;
                }
                changed++;
                Step step = scenario.steps().get(k);
                List<Step> steps = new ArrayList<>(scenario.steps());
                steps.set(k, new Step(step.line(), step.notes(), step.request(), other, step.timing()));
                List<Mismatch> found = Replay.of(new Scenario(scenario.header(), steps));
                assertThat(found).as("%s, step %s", file, k + 1).hasSize(1);
                assertThat(found.get(0).step()).isEqualTo(k + 1);
                assertThat(found.get(0).line()).isEqualTo(step.line()).isPositive();
                assertThat(found.get(0).others()).isZero();
            }
        }
        assertThat(changed).isGreaterThan(40);
    }

    private static Reply changed(Reply reply) {
        if (reply != null && reply.bundle() instanceof DistanceBundle bundle) {
            for (int k = bundle.distances().size() - 1; k >= 0; k--) {
                double distance = bundle.distances().get(k);
                if (!Double.isNaN(distance)) {
                    List<Double> distances = new ArrayList<>(bundle.distances());
                    distances.set(k, Math.nextDown(distance) < 0 ? Double.MIN_VALUE : Math.nextDown(distance));
                    return new Reply(new DistanceBundle(distances), reply.problems());
                }
            }
        }
        if (reply != null
                && reply.bundle() instanceof MoveBundle bundle
                && !bundle.moves().isEmpty()) {
            List<MoveRequest> moves = new ArrayList<>(bundle.moves());
            MoveRequest last = moves.remove(moves.size() - 1);
            moves.add(new MoveRequest(
                    last.objectName(), Math.nextUp(last.x()), last.y(), last.z(), last.rx(), last.ry()));
            return new Reply(new MoveBundle(moves), reply.problems());
        }
        return null;
    }
}
