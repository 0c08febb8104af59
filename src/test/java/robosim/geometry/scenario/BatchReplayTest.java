package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BatchAnswer;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeAnswer;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.MeasureRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.NoAnswer;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.Obstacle;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.batch.WorldAnswer;
import robosim.geometry.protocol.batch.WorldRequest;
import robosim.geometry.scenario.recording.QuietLog;

/** Batches are recorded, replayed and compared bit for bit. */
class BatchReplayTest {
    private static final InitBundle WORLD = new InitBundle(List.of(
            new BoxObject(new Point(3, 0, 0), 0.2, 2, 4).named("wall"),
            new CylinderObject(new Point(), 0.25, 1).moveable("robot")));

    private static final BatchRequestBundle BATCH = new BatchRequestBundle(List.of(
            new SenseRequest(
                    "robot",
                    Mount.CENTER,
                    new BeamPattern.Fan(0, 1.5, 3),
                    0,
                    9,
                    0,
                    false,
                    true,
                    false,
                    ScanMotion.NONE,
                    false,
                    List.of()),
            new FreePosesRequest("robot", Numbers.of(0, 0, 0, 0, 3, 0, 0, 0)),
            new SenseRequest("rover", new BeamPattern.Fan(0, 0, 1))));

    private static final BatchRequestBundle MEASURES = new BatchRequestBundle(List.of(
            new MeasureRequest(
                    "robot",
                    MeasureRequest.Question.DISTANCES,
                    Numbers.of(0, 0, 0, 0, 2.8, 0, 0, 0),
                    Double.POSITIVE_INFINITY,
                    0,
                    List.of()),
            new MeasureRequest(
                    "robot",
                    MeasureRequest.Question.DRIVES,
                    Numbers.of(0, 0, 0, 0, 1, 0, 0, 0.1, 9),
                    Double.POSITIVE_INFINITY,
                    0.25,
                    List.of()),
            new MeasureRequest(
                    "robot",
                    MeasureRequest.Question.DRIVES,
                    Numbers.of(0, 0, 0, 0, 1, 0, 0, 0.1, 2),
                    Double.POSITIVE_INFINITY,
                    0.25,
                    List.of("wall"))));

    private static List<Step> recorded() throws IOException {
        return recorded(BATCH);
    }

    private static List<Step> recorded(BatchRequestBundle batch) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ScenarioHeader header = new ScenarioHeader("batches", SessionOptions.ROBOSIM);
        try (Recorder recorder = new Recorder("test", () -> new ScenarioWriter(file, header), null)) {
            Session session = new Session(SessionOptions.ROBOSIM, recorder, "test", new QuietLog());
            session.reply(WORLD);
            session.reply(batch);
        }
        List<Step> steps = new ArrayList<>();
        try (ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "batches")) {
            for (Step step = reader.next(); step != null; step = reader.next()) {
                steps.add(step);
            }
        }
        return steps;
    }

    @Test
    void aRecordingIsReplayedToTheBit() throws IOException {
        List<Step> steps = recorded();
        assertThat(steps).extracting(Step::request).containsExactly(WORLD, BATCH);
        assertThat(steps.get(1).expected()).isNotNull();
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        for (Step step : steps) {
            assertThat(replay.step(step)).isNull();
        }
        assertThat(replay.compared()).isEqualTo(6);
    }

    /** What blocks, by its index; slides; and a sensor in the world. */
    @Test
    void movesAlongWhatBlocksAreRecordedAndReplayed() throws IOException {
        BatchRequestBundle moves = new BatchRequestBundle(List.of(
                new WorldRequest.Identify(new WorldRequest.Go("robot", 5, 0, 0, 0, 0)),
                new WorldRequest.GoToContact("robot", 5, 0, 0, 0, 0, 0.1),
                new WorldRequest.GoAndSlide("robot", 1, 0, 1, 0, 0, 0.1, 4),
                new WorldRequest.Identify(new WorldRequest.Go("robot", 0, 0, 0.5, 0, 0)),
                new SenseRequest("", new BeamPattern.Fan(0, 1, 4))));
        List<Step> steps = recorded(moves);
        assertThat(steps).extracting(Step::request).containsExactly(WORLD, moves);
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        for (Step step : steps) {
            assertThat(replay.step(step)).isNull();
        }
        Reply told = Objects.requireNonNull(steps.get(1).expected());
        List<BatchAnswer> answers = new ArrayList<>(((BatchAnswerBundle) told.bundle()).answers());
        WorldAnswer.Identified first = (WorldAnswer.Identified) answers.get(0);
        assertThat(first.obstacles()).extracting(Obstacle::index).containsExactly(0L);
        assertThat(((WorldAnswer.Slid) answers.get(2)).contacts()).hasSize(1);
        answers.set(
                0,
                new WorldAnswer.Identified(
                        first.answer(), List.of(new Obstacle(7, "wall", GeometryObject.Kind.BOX, new Point(3, 0, 0)))));
        Replay other = new Replay(SessionOptions.ROBOSIM);
        other.step(steps.get(0));
        assertThat(String.valueOf(other.step(new Step(moves, new Reply(new BatchAnswerBundle(answers))))))
                .contains("step 2, request 0, a request for Identify[request=Go[objectName=robot")
                .contains("index=7")
                .contains("index=0");
    }

    private static String mismatch(int index, BatchAnswer wanted) throws IOException {
        List<Step> steps = recorded();
        Reply told = steps.get(1).expected();
        List<BatchAnswer> answers = new ArrayList<>(((BatchAnswerBundle) told.bundle()).answers());
        answers.set(index, wanted);
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        replay.step(steps.get(0));
        return String.valueOf(replay.step(new Step(BATCH, new Reply(new BatchAnswerBundle(answers)))));
    }

    @Test
    void whatDiffersIsNamed() throws IOException {
        double none = Double.POSITIVE_INFINITY;
        Numbers normals = Numbers.of(-1, 0, 0, 0, 0, 0, 0, 0, 0);
        assertThat(mismatch(0, new SenseAnswer(Numbers.of(2.9, none, none), normals)))
                .isEqualTo("null");
        assertThat(mismatch(0, new SenseAnswer(Numbers.of(2.9, 4, none), normals)))
                .isEqualTo(
                        "step 2, request 0, a batch of 3 beams of \"robot\": expected for beam 1 4.0 (0x1.0p2) off (0.0,"
                                + " 0.0, 0.0), got for beam 1 no echo off (0.0, 0.0, 0.0)");
        assertThat(mismatch(0, new SenseAnswer(Numbers.of(2.9, none, none), Numbers.of(-1, 0, 0, 0, 0, 0, 0, -0.0, 0))))
                .contains("for beam 2 no echo off (0.0, -0.0, 0.0), got for beam 2 no echo off (0.0, 0.0, 0.0)");
        assertThat(mismatch(0, new SenseAnswer(Numbers.of(Math.nextUp(2.9), none, none), normals)))
                .contains("shorter by 4.44");
        assertThat(mismatch(1, new FreeAnswer(2, new byte[] {3})))
                .isEqualTo("step 2, request 1, a batch of 2 poses of \"robot\": expected free at 1, got not free at 1");
        assertThat(mismatch(1, new NoAnswer())).contains("expected no answer, got bits");
        assertThat(mismatch(2, new SenseAnswer(Numbers.of(1), Numbers.NONE)))
                .contains("expected distances, got no answer, no moveable object \"rover\"");
    }

    @Test
    void answersMustFitTheirRequests() {
        Numbers one = Numbers.of(1);
        List<List<BatchAnswer>> wrong = List.of(
                List.of(),
                List.of(new NoAnswer(), new NoAnswer()),
                List.of(new SenseAnswer(one, Numbers.NONE), new NoAnswer(), new NoAnswer()),
                List.of(new SenseAnswer(Numbers.of(1, 1, 1), Numbers.NONE), new NoAnswer(), new NoAnswer()),
                List.of(new FreeAnswer(3, new byte[1]), new NoAnswer(), new NoAnswer()),
                List.of(new NoAnswer(), new FreeAnswer(3, new byte[1]), new NoAnswer()));
        for (List<BatchAnswer> answers : wrong) {
            assertThatThrownBy(() -> new Step(BATCH, new Reply(new BatchAnswerBundle(answers))))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("(got: ");
        }
        assertThatThrownBy(() -> new Step(new BatchAnswerBundle(List.of()), null))
                .hasMessageContaining("(got: a BatchAnswerBundle)");
        assertThat(StepWeight.of(new Step(BATCH, null))).isEqualTo(1 + 3 + (3 * 144 + 2 + 64) / 60);
    }

    @Test
    void whatWasMeasuredIsComparedToTheBit() throws IOException {
        List<Step> steps = recorded(MEASURES);
        Reply told = Objects.requireNonNull(steps.get(1).expected());
        List<BatchAnswer> answers = new ArrayList<>(((BatchAnswerBundle) told.bundle()).answers());
        Numbers distances = ((MeasureRequest.Answer) answers.get(0)).numbers();
        assertThat(distances.get(0)).isCloseTo(2.65, within(1e-12));
        assertThat(distances.get(1)).isLessThan(-0.1);
        double part = ((MeasureRequest.Answer) answers.get(1)).numbers().get(0);
        assertThat(part).isBetween(0.2, 0.4);
        assertThat(answers.get(2)).isEqualTo(new MeasureRequest.Answer(Numbers.of(1)));
        Replay replay = new Replay(SessionOptions.ROBOSIM);
        for (Step step : steps) {
            assertThat(replay.step(step)).isNull();
        }
        assertThat(replay.compared()).isEqualTo(4);
        answers.set(1, new MeasureRequest.Answer(Numbers.of(Math.nextUp(part))));
        Replay other = new Replay(SessionOptions.ROBOSIM);
        other.step(steps.get(0));
        assertThat(String.valueOf(other.step(new Step(MEASURES, new Reply(new BatchAnswerBundle(answers))))))
                .contains("1 DRIVES of \"robot\"")
                .contains("number 0: " + part);
    }
}
