package robosim.geometry.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.cli.terminal.ExitCodes;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.scenario.Recordings;
import robosim.geometry.scenario.Replay;
import robosim.geometry.scenario.Scenario;

@Timeout(60)
class ReplayCommandTest extends CommandRun {
    private static final Path STORED = Path.of("worlds", "scenarios");

    private Path changed() throws IOException {
        Path file = folder.resolve("changed.scenario.jsonl");
        String text = Files.readString(STORED.resolve("quarter-turns.scenario.jsonl"));
        Files.writeString(file, text.replaceFirst("\\[8\\.0,5\\.0", "[8.0,5.000000000000001"));
        return file;
    }

    @Test
    void theStoredScenariosAreAllTheSame() {
        assertThat(run("replay", STORED)).isZero();
        assertThat(out.toString())
                .startsWith("14 scenarios, ")
                .contains("all the same, bit for bit, 1 request without an answer to compare with\n");
        assertThat(err.toString()).isEmpty();
        assertThat(run("replay", STORED.resolve("by-hand.scenario.jsonl"))).isZero();
        assertThat(out.toString()).startsWith("1 scenario, 4 steps, 3 answers compared: ");
    }

    @Test
    void theAnswersOfStoredScenariosAreProved() {
        assertThat(run("replay", STORED, "--prove")).isZero();
        assertThat(out.toString()).containsPattern("proofs: [1-9][0-9]+ hold, [0-9]+ answers have none, 0 failed");
        assertThat(run("replay", STORED, "--prove", "1.5")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--prove must be from 0 to 1 (got: 1.5)");
    }

    @Test
    void numbersAreWrittenAlikeEverywhere() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
            assertThat(run("replay", STORED)).isZero();
            assertThat(out.toString()).startsWith("14 scenarios, ");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aChangedBitIsTold() throws IOException {
        Path file = changed();
        assertThat(run("replay", STORED, file)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString())
                .contains(file + ": step 3 (line 5), request 1, a sonar of \"cube\" towards (0.0, 0, 1.0): expected"
                        + " 5.000000000000001 (0x1.4000000000001p2), got 5.0 (0x1.4p2)")
                .contains("15 scenarios, ", "1 answered differently, 0 unreadable");
        assertThat(run("replay", "--most", "0", file)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString()).contains("and 1 more step is answered differently");
    }

    @Test
    void whatCannotBeReadIsToldAndTheRestReplayed() throws IOException {
        changed();
        Path file = folder.resolve("none.scenario.jsonl");
        Files.writeString(file, "{\"type\":\"scenario\",\"version\":1,\"title\":\"x\"}\n{\"type\":\"fly\"}\n");
        assertThat(run("replay", folder, STORED.resolve("by-hand.scenario.jsonl")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(file + ":2: ").doesNotContain("\tat ");
        assertThat(out.toString()).contains("3 scenarios, ", "1 answered differently, 1 unreadable");
        assertThat(run("replay", folder.resolve("nowhere"))).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("must exist");
        assertThat(run("replay", Files.createDirectory(folder.resolve("empty"))))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("must contain a *.scenario.jsonl");
        assertThat(run("replay")).isEqualTo(ExitCodes.UNUSABLE);
    }

    /** What the demonstration leaves, by its folder or by either file. */
    @Test
    void theBytesOfAWireAreReplayed() throws IOException {
        Path demo = Files.createDirectory(folder.resolve("demo"));
        Bundle init = new InitBundle(List.of(
                new BoxObject(new Point(3, 0, 0), 0.2, 2, 4),
                new CylinderObject(new Point(), 0.25, 1).moveable("robot")));
        Bundle moves = new MoveBundle(List.of(new MoveRequest("robot", 2, 0, 0, 0, 0)));
        Bundle sonars = new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0)));
        write(demo.resolve("to-module.bin"), init, sonars, moves, sonars);
        Path answers = demo.resolve("from-module.bin");
        Bundle first = new DistanceBundle(List.of(2.9));
        write(answers, first, moves, new DistanceBundle(List.of(0.9)));
        for (Path place : List.of(folder, demo, demo.resolve("to-module.bin"), answers)) {
            assertThat(run("replay", place)).as(err.toString()).isZero();
            assertThat(out.toString())
                    .isEqualTo("1 scenario, 4 steps, 3 answers compared: all the same, bit for bit\n");
        }
        write(answers, first, new MoveBundle(List.of()), new DistanceBundle(List.of(2.9)));
        assertThat(run("replay", demo)).isEqualTo(ExitCodes.FINDINGS);
        assertThat(out.toString())
                .contains(
                        "to-module.bin: step 3, ", "expected refused, got made", "step 4, ", "1 answered differently");
        write(answers, first);
        assertThat(run("replay", demo)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("message 3: a request must have its answer in the other file");
        write(answers, first, moves, first, first);
        assertThat(run("replay", demo)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("an answer in the other file must have its request");
        Files.write(answers, new byte[] {1, 2, 3});
        assertThat(run("replay", demo)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).startsWith(demo.resolve("to-module.bin") + ": a stream must begin with AC ED");
        Files.delete(answers);
        assertThat(run("replay", demo)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains(answers + ": no such file or folder");
    }

    private static void write(Path file, Bundle... bundles) throws IOException {
        try (OutputStream out = Files.newOutputStream(file)) {
            MessageWriter writer = new MessageWriter(out);
            for (Bundle bundle : bundles) {
                writer.write(bundle);
            }
        }
    }

    @Test
    void aTornFileIsToldAndReplayed() throws IOException {
        Path file = folder.resolve("torn.scenario.jsonl");
        String text = Files.readString(STORED.resolve("quarter-turns.scenario.jsonl"));
        Files.writeString(file, text.substring(0, text.length() - 20));
        assertThat(run("replay", file)).isZero();
        assertThat(out.toString()).contains("line 27 is incomplete", "what was compared is the same", "1 incomplete");
    }

    private Path recording() throws IOException {
        Path file = folder.resolve("recorded.scenario.jsonl");
        Scenario stored = Scenario.read(STORED.resolve("wandering.scenario.jsonl"));
        SessionListener recorder = Recordings.ofSession(Files.newOutputStream(file), stored.header());
        Replay replay = new Replay(stored.header().options(), recorder);
        stored.steps().forEach(replay::step);
        recorder.ended();
        return file;
    }

    private void replayed(Path file, List<String> lines, int code, String... told) throws IOException {
        Files.write(file, lines);
        assertThat(run("replay", file)).as(out.toString()).isEqualTo(code);
        assertThat(out.toString()).contains(told);
        if (code != 0) {
            assertThat(out.toString()).doesNotContain("all the same");
        }
    }

    @Test
    void whatWasDoneToARecordingIsTold() throws IOException {
        Path file = recording();
        List<String> lines = List.copyOf(Files.readAllLines(file));
        assertThat(lines).hasSizeGreaterThan(20).allMatch(line -> line.matches(".*,\"crc\":\"[0-9a-f]{8}\"}"));
        replayed(file, lines, 0, "all the same, bit for bit");
        int at = 3;
        assertThat(lines.get(at)).contains("\"distances\"");
        List<String> changed = new ArrayList<>(lines);
        int digit = lines.get(at).indexOf('.') + 1;
        char next =
                lines.get(at).charAt(digit) == '9' ? '0' : (char) (lines.get(at).charAt(digit) + 1);
        changed.set(at, lines.get(at).substring(0, digit) + next + lines.get(at).substring(digit + 1));
        String other = "line 4 is not as it was recorded, or lines before it are missing; its checksum is another";
        replayed(file, changed, ExitCodes.FINDINGS, other, "1 altered", "1 answered differently");
        changed = new ArrayList<>(lines);
        changed.set(0, lines.get(0).replaceFirst("\"title\":\"", "\"title\":\"x"));
        replayed(file, changed, ExitCodes.FINDINGS, "line 1 is not as it was recorded", "1 altered");
        changed = new ArrayList<>(lines);
        changed.remove(at);
        replayed(file, changed, ExitCodes.FINDINGS, other, "1 altered", "1 request without an answer to compare with");
        changed = new ArrayList<>(lines);
        changed.removeIf(line -> line.contains("\"type\":\"distances\"") || line.contains("\"refused\":"));
        replayed(file, changed, ExitCodes.FINDINGS, "0 answers compared: nothing was compared, 1 altered, ");
        replayed(
                file,
                lines.subList(0, lines.size() - 1),
                0,
                "the end of the recording is missing: its recorder was killed or stopped, or the file was cut off",
                "what was compared is the same, bit for bit, 1 incomplete");
        changed = new ArrayList<>(lines.subList(0, lines.size() - 3));
        changed.add(lines.get(lines.size() - 1));
        replayed(file, changed, ExitCodes.FINDINGS, "as its end says", "1 altered");
        changed = new ArrayList<>(lines);
        changed.add(lines.get(1));
        Files.write(file, changed);
        assertThat(run("replay", file)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("nothing may follow the end of a recording (got: a line of type init)");
    }

    /** Without checksums nobody knows whether answers were there; where none is left, nothing was compared. */
    @Test
    void withoutAnswersNothingIsTheSame() throws IOException {
        Path file = folder.resolve("bare.scenario.jsonl");
        List<String> lines = new ArrayList<>(Files.readAllLines(STORED.resolve("wandering.scenario.jsonl")));
        lines.removeIf(line -> line.contains("\"type\":\"distances\"") || line.contains("\"refused\":"));
        replayed(
                file,
                lines,
                ExitCodes.FINDINGS,
                "0 answers compared: nothing was compared, 16 requests without an answer to compare with\n");
        replayed(file, lines.subList(0, 2), ExitCodes.FINDINGS, "0 answers compared: nothing was compared\n");
    }

    @Test
    void aWorldOutsideOfTheRootIsRefused() {
        Path byHand = STORED.resolve("by-hand.scenario.jsonl");
        assertThat(run("replay", "--root", STORED, byHand)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("by-hand.scenario.jsonl:3: file must lead to a file under");
    }

    @Test
    void helpHasExamples() {
        assertThat(run("replay", "--help")).isZero();
        assertThat(out.toString()).contains("Exit codes:", "robosim-geometry replay recordings");
        assertThat(run("serve", "--help")).isZero();
        assertThat(out.toString()).contains("--record=PLACE", "--record recordings");
    }

    @Test
    void connectRecordsWhatItIsAsked() throws Exception {
        Path file = folder.resolve("session.scenario.jsonl");
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread environment = new Thread(() -> {
                try (Socket socket = listening.accept()) {
                    String lines = "{\"type\":\"hello\",\"version\":1}\n{\"type\":\"moves\",\"moves\":[]}\n";
                    socket.getOutputStream().write(lines.getBytes(StandardCharsets.UTF_8));
                    socket.shutdownOutput();
                    socket.getInputStream().readAllBytes();
                } catch (IOException e) {
                    throw new AssertionError(e);
                }
            });
            environment.start();
            assertThat(run("connect", "localhost", listening.getLocalPort(), "--once", "--record", file))
                    .isZero();
            environment.join();
        }
        Scenario scenario = Scenario.read(file);
        assertThat(scenario.steps()).hasSize(1);
        assertThat(Replay.of(scenario)).isEmpty();
        assertThat(run("connect", "localhost", 5555, "--record", file)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--record must be a new file");
    }

    @Test
    void placesThatCannotBeRecordedIntoAreRefusedAtOnce() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "x");
        assertThat(run("serve", 0, "--record", file)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--record must be a folder");
        assertThat(run("serve", 0, "--record", folder, "--record-bytes", 0)).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("--record-bytes must be at least 1");
        assertThat(run("connect", "localhost", 5555, "--record", folder.resolve("no/where")))
                .isEqualTo(ExitCodes.UNUSABLE);
        assertThat(err.toString()).contains("in a folder that exists; create the folder first");
    }

    @Test
    void aWorldIsNoRecording() {
        assertThat(run("replay", "worlds/rooms.xml")).isEqualTo(ExitCodes.UNUSABLE);
        assertThat(out.toString() + err)
                .contains("rooms.xml:1: this is XML and no recording; a world file is for check, render and drive");
    }
}
