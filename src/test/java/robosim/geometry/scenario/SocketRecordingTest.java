package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.ChildJvm;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionListener;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.json.JsonLines;

/** Recordings of sessions over real sockets: what a peer got is what the file holds and what a replay answers. */
@Tag("clock")
@Timeout(60)
class SocketRecordingTest {
    @TempDir
    Path folder;

    private GeometryServer server() throws IOException {
        NetOptions options = NetOptions.defaults();
        return new GeometryServer(
                InetAddress.getLoopbackAddress(),
                0,
                options.withListeners(Recordings.inFolder(folder, options.session())));
    }

    private List<Scenario> recordings() throws IOException {
        List<Scenario> recordings = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.sorted().toList()) {
                recordings.add(Scenario.read(file));
            }
        }
        return recordings;
    }

    private static List<Bundle> answersOf(Scenario scenario) {
        List<Bundle> answers = new ArrayList<>();
        for (Step step : scenario.steps()) {
            if (step.expected() != null) {
                answers.add(step.expected().bundle());
            }
        }
        return answers;
    }

    private static List<Bundle> inJava(int port, List<Bundle> requests) throws IOException {
        List<Bundle> answers = new ArrayList<>();
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            MessageWriter out = new MessageWriter(socket.getOutputStream());
            MessageReader in = new MessageReader(socket.getInputStream());
            for (Bundle request : requests) {
                out.write(request);
                if (!(request instanceof InitBundle)) {
                    answers.add(in.read());
                }
            }
        }
        return answers;
    }

    /** Lines that are sent as they are. */
    private static List<String> inJson(int port, List<String> requests) throws IOException {
        List<String> answers = new ArrayList<>();
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            BufferedReader in =
                    new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
            send(socket, "{\"type\":\"hello\",\"version\":1}");
            in.readLine();
            for (String request : requests) {
                send(socket, request);
                if (!request.contains("\"init\"")) {
                    answers.add(in.readLine());
                }
            }
        }
        return answers;
    }

    private static void send(Socket socket, String line) throws IOException {
        socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void eachPeersRecordingHoldsAndReplaysToTheBitsThatItGot() throws IOException {
        for (String name : List.of("wandering", "unknown-names", "quarter-turns", "found-least-direction")) {
            List<Bundle> requests = StoredScenarios.all().get(name).requests;
            List<Bundle> inJava;
            List<Bundle> inJson = new ArrayList<>();
            try (GeometryServer server = server()) {
                inJava = inJava(server.port(), requests);
                for (String line : inJson(
                        server.port(), requests.stream().map(JsonLines::write).toList())) {
                    inJson.add(JsonLines.readReply(line).bundle());
                }
            }
            assertThat(inJava).isEqualTo(inJson);
            List<Scenario> recordings = recordings();
            assertThat(recordings).hasSize(2);
            for (Scenario recording : recordings) {
                assertThat(recording.steps()).extracting(Step::request).isEqualTo(requests);
                assertThat(recording.steps()).allMatch(step -> step.timing() != null);
                assertThat(answersOf(recording)).as(name).isEqualTo(inJava);
                assertThat(Replay.of(recording)).as(name).isEmpty();
            }
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    /** A recording is closed with its connection, whoever ended that and however. */
    @Test
    void aListenerIsToldOfTheEndOnce() throws IOException {
        AtomicInteger begun = new AtomicInteger();
        AtomicInteger ended = new AtomicInteger();
        SessionListener counter = new SessionListener() {
            @Override
            public void ended() {
                ended.incrementAndGet();
            }
        };
        NetOptions options = NetOptions.defaults().withListeners(name -> {
            begun.incrementAndGet();
            return counter;
        });
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            inJava(server.port(), List.of(new MoveBundle(List.of())));
            try (Socket hostile = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                send(hostile, "rubbish");
                hostile.getInputStream().readAllBytes();
            }
            try (Socket waiting = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                send(waiting, "{\"type\":\"hello\",\"version\":1}");
                waiting.getInputStream().read();
                server.close();
            }
        }
        assertThat(ended).hasValue(3);
        assertThat(begun).hasValue(3);
    }

    /** What a file holds beside notes, times and answers can be sent to a server as it is. */
    @Test
    void theRequestsOfAFileAreLinesOfTheWire() throws IOException {
        List<String> requests = new ArrayList<>();
        List<String> answers = new ArrayList<>();
        for (String line : Files.readAllLines(StoredScenarios.file("overlapping-walls"))) {
            String type = JsonLines.typeOf(line);
            if (JsonLines.isReply(line)) {
                answers.add(line);
            } else if (List.of("init", "moves", "sonars").contains(type)) {
                requests.add(line);
            }
        }
        try (GeometryServer server = server()) {
            assertThat(inJson(server.port(), requests)).isEqualTo(answers).hasSize(4);
        }
    }

    /** An environment that goes on until it is killed with the rest. */
    static final class Talker {
        private Talker() {}

        public static void main(String[] arguments) throws IOException {
            NetOptions options = NetOptions.defaults();
            GeometryServer server = new GeometryServer(
                    InetAddress.getLoopbackAddress(),
                    0,
                    options.withListeners(Recordings.inFolder(Path.of(arguments[0]), options.session())));
            List<Bundle> requests = StoredScenarios.all().get("wandering").requests;
            while (true) {
                inJava(server.port(), requests);
            }
        }
    }

    @Test
    void whatAKilledProcessHasRecordedReplays() throws IOException, InterruptedException {
        Process process = new ProcessBuilder(ChildJvm.running(Talker.class, folder.toString()))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        try {
            long enough = System.nanoTime() + TimeUnit.SECONDS.toNanos(40);
            while (begun() < 4 && System.nanoTime() < enough) {
                TimeUnit.MILLISECONDS.sleep(1);
            }
        } finally {
            process.destroyForcibly().waitFor();
        }
        List<Bundle> requests = StoredScenarios.all().get("wandering").requests;
        List<Scenario> recordings = recordings();
        assertThat(recordings).hasSizeGreaterThanOrEqualTo(4);
        int steps = 0;
        for (Scenario recording : recordings) {
            List<Step> whole = recording.steps();
            assertThat(whole).extracting(Step::request).isEqualTo(requests.subList(0, whole.size()));
            assertThat(Replay.of(recording)).isEmpty();
            steps += whole.size();
        }
        // Where a fourth has begun, three are over; only what was being written may be missing.
        assertThat(steps).isGreaterThanOrEqualTo(2 * requests.size());
    }

    /** How many files hold at least the greater part of their world. */
    private int begun() throws IOException {
        int begun = 0;
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                begun += Files.size(file) > 10_000 ? 1 : 0;
            }
        }
        return begun;
    }
}
