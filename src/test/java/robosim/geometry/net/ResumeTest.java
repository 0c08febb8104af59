package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.WorldMemory;

/** Sessions that outlive their connections. */
class ResumeTest {
    private static final String INIT =
            "{\"type\":\"init\",\"id\":1,\"settings\":{\"width\":20,\"height\":20,\"length\":20},\"objects\":[{\"kind\":\"cylinder\",\"name\":\"r\",\"moveable\":true,\"center\":[0,0,0],"
                    + "\"radius\":0.2,\"height\":1}]}";
    private static final String GO =
            "{\"type\":\"step\",\"id\":%d,\"seconds\":1,\"commands\":[{\"objectName\":\"r\",\"forward\":1}]}";
    private static final String WHERE = "{\"type\":\"batch\",\"requests\":[{\"kind\":\"pose\",\"objectName\":\"r\"}]}";

    private final AtomicInteger opened = new AtomicInteger();
    private final AtomicInteger ended = new AtomicInteger();

    private NetOptions options(Duration kept) {
        return NetOptions.defaults()
                .withTimeouts(Timeouts.DEFAULT.withResume(kept))
                .withListeners(connection -> new SessionListener() {
                    @Override
                    public void opened(Session session) {
                        opened.incrementAndGet();
                    }

                    @Override
                    public void ended() {
                        ended.incrementAndGet();
                    }
                });
    }

    private GeometryServer server(Duration kept) {
        return new GeometryServer(InetAddress.getLoopbackAddress(), 0, options(kept));
    }

    /** A JSON peer, which has said hello. */
    private static final class Talk implements AutoCloseable {
        private final Socket socket;
        private final BufferedReader in;
        private final String welcome;

        Talk(Socket socket, String resume) throws IOException {
            this.socket = socket;
            socket.setSoTimeout(20_000);
            in = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
            welcome = ask("{\"type\":\"hello\",\"version\":1" + resume + "}");
        }

        static Talk dial(GeometryServer server, String resume) throws IOException {
            return new Talk(
                    new Socket(InetAddress.getLoopbackAddress(), server.port()), ",\"resume\":\"" + resume + "\"");
        }

        void send(String line) throws IOException {
            socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
        }

        String ask(String line) throws IOException {
            send(line);
            return String.valueOf(in.readLine());
        }

        String token() {
            return welcome.replaceAll(".*\"token\":\"([0-9a-f]{32})\".*", "$1");
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    @Test
    void aSessionGoesOnWhereItWas() throws Exception {
        String token;
        try (GeometryServer server = server(Duration.ofSeconds(30))) {
            try (Talk first = Talk.dial(server, "")) {
                token = first.token();
                assertThat(token).hasSize(32);
                first.send(INIT);
                assertThat(first.ask(GO.formatted(2))).contains("\"center\":[1.0,0.0,0.0]");
            }
            try (Talk second = Talk.dial(server, token)) {
                assertThat(second.welcome).contains("\"id\":2").contains("\"token\":\"" + token + "\"");
                assertThat(second.ask("{\"type\":\"step\",\"seconds\":1}")).contains("\"center\":[2.0,0.0,0.0]");
            }
            assertThat(opened).hasValue(1);
            assertThat(ended).hasValue(0);
        }
        HostilePeerTest.await(() -> ended.get() == 1);
    }

    @Test
    void aPeerThatIsFasterThanTheModuleTakesItsSessionOver() throws Exception {
        try (GeometryServer server = server(Duration.ofSeconds(30));
                Talk first = Talk.dial(server, "")) {
            first.send(INIT);
            first.ask(GO.formatted(2));
            try (Talk second = Talk.dial(server, first.token())) {
                assertThat(second.ask(WHERE)).contains("\"center\":[1.0,0.0,0.0]");
                assertThat(first.in.readLine()).isNull();
            }
        }
    }

    @Test
    void aRequestThatIsCutOffByTheDropIsNotCarriedOut() throws Exception {
        try (GeometryServer server = server(Duration.ofSeconds(30))) {
            String token;
            try (Talk first = Talk.dial(server, "")) {
                token = first.token();
                first.send(INIT);
                first.ask(GO.formatted(2));
                first.send("{\"type\":\"sonars\",\"id\":3,\"requests\":["
                        + "{\"objectName\":\"r\",\"xOffset\":1,\"zOffset\":0},".repeat(200_000)
                        + "{\"objectName\":\"r\",\"xOffset\":1,\"zOffset\":0}]}");
            }
            try (Talk second = Talk.dial(server, token)) {
                assertThat(second.welcome).contains("\"id\":2");
                assertThat(second.ask(WHERE)).contains("\"center\":[1.0,0.0,0.0]");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "00000000000000000000000000000000", "' OR 1=1", "\\u0000", "é", "../../etc"})
    void aTokenOfNobodyIsRefused(String token) throws Exception {
        try (GeometryServer server = server(Duration.ofSeconds(30));
                Talk kept = Talk.dial(server, "");
                Talk stranger = Talk.dial(server, token)) {
            assertThat(stranger.welcome)
                    .contains("error")
                    .contains("no session is kept")
                    .doesNotContain("continues");
            assertThat(stranger.in.readLine()).isNull();
            assertThat(kept.ask("{\"type\":\"ping\"}")).contains("pong");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {",\"resume\":7", ",\"resume\":null", ",\"resume\":[\"\"]", ",\"resume\":\"\",\"resume\":\"\""})
    void whatIsNoTokenIsRefused(String resume) throws Exception {
        try (GeometryServer server = server(Duration.ofSeconds(30));
                Talk stranger = new Talk(new Socket(InetAddress.getLoopbackAddress(), server.port()), resume)) {
            assertThat(stranger.welcome).contains("\"error\"");
        }
    }

    @Test
    void aLongTokenIsRefusedAndNotRepeated() throws Exception {
        String token = "5ec2e7".repeat(100);
        try (GeometryServer server = server(Duration.ofSeconds(30));
                LogCapture log = new LogCapture();
                Talk stranger = Talk.dial(server, token)) {
            assertThat(stranger.welcome).contains("the token of a session").doesNotContain("5ec2e7");
            assertThat(log.linesWith("5ec2e7")).isEmpty();
        }
    }

    @Test
    void aSessionExpires() throws Exception {
        try (GeometryServer server = server(Duration.ofMillis(50))) {
            String token;
            try (Talk first = Talk.dial(server, "")) {
                token = first.token();
                first.ask(GO.formatted(2));
            }
            HostilePeerTest.await(() -> ended.get() == 1);
            try (Talk second = Talk.dial(server, token)) {
                assertThat(second.welcome).contains("no session is kept");
            }
        }
    }

    @Test
    void theOldestMakesRoom() throws Exception {
        try (GeometryServer server = server(Duration.ofMinutes(5))) {
            List<String> tokens = new ArrayList<>();
            for (int k = 0; k <= KeptSessions.MOST; k++) {
                try (Talk each = Talk.dial(server, "")) {
                    tokens.add(each.token());
                }
                HostilePeerTest.await(() -> server.connections() == 0);
            }
            HostilePeerTest.await(() -> ended.get() == 1);
            try (Talk oldest = Talk.dial(server, tokens.get(0));
                    Talk next = Talk.dial(server, tokens.get(1))) {
                assertThat(oldest.welcome).contains("no session is kept");
                assertThat(next.welcome).contains(tokens.get(1));
            }
        }
        HostilePeerTest.await(() -> ended.get() == opened.get());
    }

    @Test
    void oneMachineKeepsFewAndTheirMemoryIsGivenBack() throws Exception {
        WorldMemory memory = new WorldMemory(1 << 20);
        InetAddress robot = InetAddress.getByName("10.0.0.7");
        try (Watchdog watchdog = new Watchdog("test", Duration.ofSeconds(1))) {
            KeptSessions kept = new KeptSessions(Duration.ofMinutes(5), watchdog);
            List<String> tokens = new ArrayList<>();
            for (int k = 0; k <= KeptSessions.MOST_FROM_ONE; k++) {
                WorldMemory.Share share = memory.share();
                share.claim(100_000); // the first has room
                SessionListener listener = options(Duration.ZERO).listeners().apply("");
                KeptSessions.Kept each =
                        new KeptSessions.Kept(new Session(SessionOptions.ROBOSIM, listener, ""), listener, share);
                tokens.add(kept.begin(each, () -> {}, robot, "CN=robot"));
                assertThat(kept.release(each, true)).isTrue();
            }
            assertThatThrownBy(() -> kept.resume(tokens.get(0), () -> {}, robot, "CN=robot"))
                    .hasMessageContaining("no session is kept");
            assertThatThrownBy(() -> kept.resume(tokens.get(1), () -> {}, robot, "CN=thief"))
                    .hasMessageContaining("no session is kept");
            kept.resume(tokens.get(1), () -> {}, robot, "CN=robot");
            int dropped = 0;
            while (kept.makeRoom()) {
                dropped++;
            }
            assertThat(dropped).isEqualTo(KeptSessions.MOST_FROM_ONE - 1); // not the one that is held
            assertThat(memory.share().claim(130_000)).isNull(); // nearly all of it
        }
        HostilePeerTest.await(() -> ended.get() == KeptSessions.MOST_FROM_ONE);
    }

    @Test
    void nothingIsKeptUnlessBothWantIt() throws Exception {
        try (GeometryServer server = server(Duration.ZERO);
                Talk asks = Talk.dial(server, "")) {
            assertThat(asks.welcome).contains("\"hello\"").doesNotContain("token");
            try (Talk stranger = Talk.dial(server, "00")) {
                assertThat(stranger.welcome).contains("--resume");
            }
        }
        try (GeometryServer server = server(Duration.ofSeconds(30))) {
            try (Talk silent = new Talk(new Socket(InetAddress.getLoopbackAddress(), server.port()), "")) {
                assertThat(silent.welcome).doesNotContain("token");
            }
            // Counted by the connections' own threads, which may lag behind what their peers have read.
            HostilePeerTest.await(() -> opened.get() > 1 && ended.get() == opened.get());
        }
    }

    @Test
    void anEnvironmentThatIsDialledResumesToo() throws Exception {
        try (ServerSocket listening = Peer.listen();
                GeometryClient client = new GeometryClient(
                        "127.0.0.1",
                        listening.getLocalPort(),
                        options(Duration.ofSeconds(30))
                                .withRedial(new Redial(Duration.ofMillis(1), Duration.ofMillis(2))))) {
            new Thread(client).start();
            String token;
            try (Talk first = new Talk(listening.accept(), ",\"resume\":\"\"")) {
                token = first.token();
                first.send(INIT);
                first.ask(GO.formatted(2));
            }
            try (Talk second = new Talk(listening.accept(), ",\"resume\":\"" + token + "\"")) {
                assertThat(second.ask(WHERE)).contains("\"center\":[1.0,0.0,0.0]");
            }
        }
    }
}
