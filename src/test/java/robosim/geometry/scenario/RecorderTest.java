package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static robosim.geometry.scenario.Conversation.move;
import static robosim.geometry.scenario.Conversation.sonar;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.LogCapture;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.scenario.recording.QuietLog;

class RecorderTest {
    private static final ScenarioHeader HEADER = new ScenarioHeader("a test", ScenarioReaderTest.OPTIONS);

    private final ByteArrayOutputStream file = new ByteArrayOutputStream();
    private final AtomicLong clock = new AtomicLong(1000);

    private static List<Bundle> talk() {
        List<Bundle> talk = new ArrayList<>();
        talk.add(new InitBundle(List.of(
                new CylinderObject(new Point(), 1, 1).moveable("a"),
                new CylinderObject(new Point(5, 0, 0), 1, 1).moveable("b"))));
        for (int k = 0; k < 6; k++) {
            talk.add(new MoveBundle(List.of(move("a", 0.75, 0), move("c", 1, 0))));
            talk.add(new SonarRequestBundle(List.of(sonar("a", 1, 0), sonar("b", 0, 1))));
        }
        return talk;
    }

    private static List<Reply> answers(Session session) {
        List<Reply> answers = new ArrayList<>();
        for (Bundle request : talk()) {
            answers.add(session.reply(request));
        }
        return answers;
    }

    private static Session session(SessionListener recorder) {
        return new Session(HEADER.options(), recorder, "test", new QuietLog());
    }

    private Scenario recorded() throws IOException {
        List<Step> steps = new ArrayList<>();
        ScenarioReader reader = ScenarioReader.of(new ByteArrayInputStream(file.toByteArray()), "recorded");
        for (Step step = reader.next(); step != null; step = reader.next()) {
            steps.add(step);
        }
        return new Scenario(reader.header(), steps, reader.torn());
    }

    private ScenarioWriter open() throws IOException {
        return new ScenarioWriter(file, HEADER);
    }

    @Test
    void everythingIsWrittenWithItsTimes() throws IOException {
        Recorder recorder = new Recorder("test", this::open, () -> clock.getAndAdd(10));
        List<Reply> answers = answers(session(recorder));
        assertThat(recorder.bytes()).isEqualTo(file.size());
        Scenario scenario = recorded();
        assertThat(scenario.header()).isEqualTo(HEADER);
        assertThat(scenario.steps()).extracting(Step::request).isEqualTo(talk());
        assertThat(scenario.steps()).extracting(Step::expected).isEqualTo(answers);
        assertThat(scenario.steps())
                .allSatisfy(step -> assertThat(step.timing()).isNotNull());
        assertThat(scenario.steps()).extracting(step -> step.timing().at()).startsWith(10L, 20L, 30L);
        assertThat(Replay.of(scenario)).isEmpty();
    }

    @Test
    void eachMessageIsInTheFileBeforeTheNextIsRead() throws IOException {
        Session session = session(new Recorder("test", this::open, null));
        int steps = 0;
        for (Bundle request : talk()) {
            session.reply(request);
            assertThat(recorded().steps()).hasSize(++steps);
        }
    }

    /** A request that the module does not survive is in the file. */
    @Test
    void aRequestIsWrittenBeforeItIsCarriedOut() throws IOException {
        Recorder recorder = new Recorder("test", this::open, null);
        recorder.requested(talk().get(1));
        assertThat(recorded().steps()).hasSize(1);
        assertThat(recorded().steps().get(0).expected()).isNull();
        recorder.ended();
        assertThat(recorder.isRecording()).isFalse();
    }

    /** A stream that has room for so many bytes. */
    private final class Full extends OutputStream {
        private int room;
        private boolean closed;

        Full(int room) {
            this.room = room;
        }

        @Override
        public void write(int b) throws IOException {
            if (room-- <= 0) {
                throw new IOException("No space left on device");
            }
            file.write(b);
        }

        @Override
        public void close() {
            closed = true;
        }
    }

    @Test
    void aFullDiskEndsTheRecordingAndNotTheSession() throws IOException {
        List<Reply> undisturbed =
                answers(new Session(HEADER.options(), new Recorder("whole", this::open, null), "test"));
        int size = file.size();
        byte[] whole = file.toByteArray();
        int header = HEADER.line().length() + 1;
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            for (int room = 0; room < size; room += 7) {
                file.reset();
                Full disk = new Full(room);
                Recorder recorder = new Recorder("test " + room, () -> new ScenarioWriter(disk, HEADER), null);
                assertThat(answers(session(recorder))).isEqualTo(undisturbed);
                assertThat(recorder.isRecording()).isFalse();
                assertThat(Arrays.mismatch(whole, file.toByteArray())).isEqualTo(file.size());
                if (room >= header) {
                    assertThat(disk.closed).isTrue();
                    assertThat(Replay.of(recorded())).isEmpty();
                }
                assertThat(log.linesWith("test " + room + ": "))
                        .hasSize(1)
                        .first()
                        .asString()
                        .contains("No space left");
            }
        }
    }

    @Test
    void atTheMostBytesItStopsWithAWholeLine() throws IOException {
        answers(session(new Recorder("whole", this::open, null)));
        int size = file.size();
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            for (int most = HEADER.line().length() + 1; most < size; most += 50) {
                file.reset();
                int limit = most;
                Recorder recorder = new Recorder("test " + most, () -> new ScenarioWriter(file, HEADER, limit), null);
                answers(session(recorder));
                assertThat(recorder.isRecording()).isFalse();
                assertThat(file.size()).isLessThanOrEqualTo(most);
                Scenario scenario = recorded();
                assertThat(scenario.torn()).isZero();
                assertThat(Replay.of(scenario)).isEmpty();
                assertThat(log.linesWith("test " + most + ": "))
                        .hasSize(1)
                        .first()
                        .asString()
                        .contains("at most");
            }
        }
    }

    @Test
    void whateverThrowsTheSessionGoesOn() {
        List<Throwable> failures = List.of(
                new IOException("x"),
                new IllegalStateException("x"),
                new NoClassDefFoundError("x"),
                new OutOfMemoryError("x"));
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            for (Throwable failure : failures) {
                Recorder recorder = new Recorder("test", () -> RecorderTest.<RuntimeException>sneak(failure), null);
                assertThat(answers(session(recorder))).hasSize(talk().size());
                assertThat(recorder.bytes()).isZero();
            }
            assertThat(log.linesWith("test: recording stopped")).hasSize(failures.size());
        }
    }

    @SuppressWarnings("unchecked")
    private static <T extends Throwable> ScenarioWriter sneak(Throwable failure) throws T {
        throw (T) failure;
    }

    @Test
    void aNameThatJsonCannotHoldEndsTheRecording() throws IOException {
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            Recorder recorder = new Recorder("test", this::open, null);
            Session session = session(recorder);
            session.reply(new MoveBundle(List.of(move("\\ud800 is no pair, spelt out", 1, 0))));
            assertThat(recorder.isRecording()).isTrue();
            session.reply(new MoveBundle(List.of(move("half \ud800", 1, 0))));
            assertThat(recorder.isRecording()).isFalse();
            assertThat(recorded().steps()).hasSize(1);
            assertThat(log.linesWith("surrogate")).hasSize(1);
        }
    }

    @Test
    void whatCouldNotBeReadIsNotWritten() throws IOException {
        ScenarioWriter writer = open();
        int header = file.size();
        Reply odd = new Reply(new MoveBundle(List.of(move("half \ud800", 1, 0))));
        assertThatThrownBy(() -> writer.answer(odd, null)).hasMessageContaining("surrogate");
        assertThatThrownBy(() -> writer.request(odd.bundle())).hasMessageContaining("surrogate");
        assertThatThrownBy(() -> writer.note("half \ud800")).hasMessageContaining("surrogate");
        assertThat(file.size()).isEqualTo(header);
    }

    @Test
    void nothingIsOpenedForWhoAsksNothing() {
        Recorder recorder = new Recorder(
                "test",
                () -> {
                    throw new AssertionError("opened");
                },
                null);
        recorder.ended();
        recorder.requested(talk().get(0));
        assertThat(recorder.isRecording()).isFalse();
    }

    @Test
    void filesOfAFolderAreNamedByTimeAndConnectionAndNeverTheSame(@TempDir Path folder) throws IOException {
        Clock stopped = Clock.fixed(Instant.parse("2026-11-21T13:45:12.345Z"), ZoneOffset.UTC);
        Recordings recordings = Recordings.inFolder(folder, HEADER.options()).by(stopped);
        for (int k = 0; k < 3; k++) {
            answers(new Session(
                    HEADER.options(), recordings.apply("connection 7 of /127.0.0.1:5555"), "test", new QuietLog()));
        }
        recordings.apply("silent").ended();
        String name = "20261121T134512.345Z-connection-7-of-127.0.0.1-5555";
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder(
                            name + ".scenario.jsonl", name + "-2.scenario.jsonl", name + "-3.scenario.jsonl");
        }
        Scenario scenario = Scenario.read(folder.resolve(name + "-3.scenario.jsonl"));
        assertThat(scenario.header().title()).isEqualTo("connection 7 of /127.0.0.1:5555, 20261121T134512.345Z");
        assertThat(scenario.steps()).hasSize(talk().size());
        assertThat(Replay.of(scenario)).isEmpty();
    }

    @Test
    void aFileIsNumberedWhereItIsTaken(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("session.log");
        Recordings recordings = Recordings.inFile(file, HEADER.options()).atMost(1500);
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            answers(session(recordings.apply("one")));
            answers(session(recordings.apply("two")));
            assertThat(log.linesWith("at most 1500")).hasSize(2);
        }
        assertThat(Replay.of(Scenario.read(file))).isEmpty();
        assertThat(Replay.of(Scenario.read(folder.resolve("session-2.log")))).isEmpty();
        assertThatThrownBy(() -> recordings.atMost(0)).hasMessageContaining("at least 1");
    }
}
