package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.LogCapture;
import robosim.geometry.net.Session;
import robosim.geometry.net.SessionListener;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.scenario.recording.QuietLog;
import robosim.geometry.scenario.recording.RecordingFile;

/** What cannot be recorded is told, what was recorded before can be read, and no answer is another for it. */
class LostRecordingTest {
    private static final int STEPS = 20;

    /** A file on a disk with room for so many bytes, of which one write may take a part. */
    private static final class Disk extends RecordingFile {
        private int room;
        private int written;

        Disk(Path place, int room) throws IOException {
            super(place);
            this.room = room;
        }

        @Override
        public void write(byte[] bytes, int at, int length) throws IOException {
            int part = Math.min(length, room);
            super.write(bytes, at, part);
            room -= part;
            written += part;
            if (part < length) {
                throw new IOException("No space left on device");
            }
        }

        @Override
        public void cutTo(long bytes) throws IOException {
            super.cutTo(bytes);
            room += written - (int) bytes;
            written = (int) bytes;
        }
    }

    private static List<Reply> talk(SessionListener recorder) {
        Session session = new Session(SessionOptions.ROBOSIM, recorder, "test", new QuietLog());
        List<Reply> replies = new ArrayList<>();
        for (Bundle request : requests()) {
            replies.add(session.reply(request));
        }
        recorder.ended();
        return replies;
    }

    private static List<Bundle> requests() {
        List<Bundle> requests = new ArrayList<>();
        requests.add(new InitBundle(List.of(new CylinderObject(new Point(), 1, 1).moveable("robot"))));
        for (int k = 1; k < STEPS; k++) {
            requests.add(
                    k % 2 == 0
                            ? new SonarRequestBundle(Collections.nCopies(8, new SonarRequest("robot", k, 1)))
                            : new MoveBundle(List.of(new MoveRequest("robot", 0.125, 0, 0, 0, 0.5))));
        }
        return requests;
    }

    @Test
    void aFullDiskLeavesWholeLinesOfWhichTheLastTellsIt(@TempDir Path folder) throws IOException {
        Recordings recordings = Recordings.inFile(folder.resolve("whole"), SessionOptions.ROBOSIM);
        List<Reply> undisturbed = talk(recordings.apply("whole"));
        int size = (int) Files.size(folder.resolve("whole")); // its times are of another length each time
        int told = 0;
        int shortened = 0;
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            for (int room = 600; room < size - 500; room += 29) {
                int most = room;
                Path file = folder.resolve("disk " + room);
                assertThat(talk(Recordings.inFile(file, SessionOptions.ROBOSIM)
                                .into(place -> new Disk(place, most))
                                .apply("disk " + room)))
                        .isEqualTo(undisturbed);
                try (ScenarioReader reader = ScenarioReader.open(file)) {
                    int steps = 0;
                    for (Step step = reader.next(); step != null; step = reader.next()) {
                        assertThat(step.request()).isEqualTo(requests().get(steps));
                        if (step.expected() != null) {
                            assertThat(step.expected()).isEqualTo(undisturbed.get(steps));
                        }
                        steps++;
                    }
                    assertThat(reader.torn()).as("no incomplete line").isZero();
                    told += reader.lastNotes().toString().contains("recorded no further: No space left") ? 1 : 0;
                    shortened += steps < STEPS ? 1 : 0;
                }
                assertThat(log.linesWith("disk " + room + ": recording stopped"))
                        .hasSize(1)
                        .first()
                        .asString()
                        .contains("No space left");
            }
        }
        assertThat(shortened).isGreaterThan(100);
        assertThat(told)
                .as("of " + shortened + ", where the line that did not fit was longer than the note")
                .isGreaterThan(shortened / 4);
    }

    @Test
    void aFolderThatCannotBeWrittenIntoIsToldAndTheSessionGoesOn(@TempDir Path folder) throws IOException {
        List<Reply> undisturbed = talk(new Recorder(
                "nowhere",
                () -> {
                    throw new IOException("nowhere");
                },
                null));
        Path file = Files.createFile(folder.resolve("a file"));
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            for (Path place : List.of(file, folder.resolve("not there"))) {
                assertThat(talk(Recordings.inFolder(place, SessionOptions.ROBOSIM)
                                .apply("session")))
                        .isEqualTo(undisturbed);
                assertThat(log.linesWith(place.toString()))
                        .hasSize(1)
                        .first()
                        .asString()
                        .contains("session: recording stopped after 0 bytes");
            }
        }
        assertThat(Files.size(file)).isZero();
    }

    @Test
    void aFolderWithoutRightsIsToldToo(@TempDir Path folder) throws IOException {
        Path locked = Files.createDirectory(folder.resolve("locked"));
        assumeThat(locked.toFile().setWritable(false)).isTrue();
        assumeThat(Files.isWritable(locked)).as("not by root").isFalse();
        try (LogCapture log = new LogCapture("robosim.geometry.scenario")) {
            assertThat(talk(Recordings.inFolder(locked, SessionOptions.ROBOSIM).apply("session")))
                    .hasSize(STEPS);
            assertThat(log.linesWith("AccessDeniedException")).hasSize(1);
        } finally {
            assertThat(locked.toFile().setWritable(true)).isTrue();
        }
    }
}
