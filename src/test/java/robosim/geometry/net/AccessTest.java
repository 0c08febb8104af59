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
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import javax.net.ssl.SSLSocket;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;

/** Who gets in, and who does not. */
@Tag("clock")
class AccessTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);
    private static final String WORD = "correct horse battery staple";
    private static final char[] SECRET = WORD.toCharArray();

    @TempDir
    static Path folder;

    private static Stores stores;

    @BeforeAll
    static void makeStores() throws Exception {
        stores = new Stores(folder);
    }

    private static InetAddress everywhere() throws IOException {
        return InetAddress.getByName("0.0.0.0");
    }

    // Long enough for a first handshake on a busy machine.
    private static NetOptions options(@Nullable Tls tls, char @Nullable [] secret) {
        return NetOptions.defaults().withAccess(tls, secret).withTimes(Duration.ofSeconds(5), Duration.ofSeconds(20));
    }

    private static Peer secured(int port, Tls tls) throws IOException {
        SSLSocket socket = tls.dial(new Socket(InetAddress.getLoopbackAddress(), port), "127.0.0.1", port);
        return new Peer(socket);
    }

    @Test
    void offLoopbackItDoesNotStartWithoutKnowingWhoComes() throws Exception {
        for (String address : List.of("0.0.0.0", "::", "192.0.2.1")) {
            assertThatThrownBy(() -> new GeometryServer(InetAddress.getByName(address), 0, NetOptions.defaults()))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("TLS")
                    .hasMessageContaining("secret")
                    .hasMessageContaining("GeometryClient dial");
        }
        try (GeometryServer loopback =
                new GeometryServer(InetAddress.getByName("127.0.0.2"), 0, NetOptions.defaults())) {
            assertThat(loopback.port()).isPositive();
        }
    }

    @Test
    void certificatesLetTheirOwnersInAndNobodyElse() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(everywhere(), 0, options(stores.of("module"), null));
                Peer healthy = secured(server.port(), stores.of("environment"))) {
            assertThat(healthy.move(NOBODY)).isEmpty();
            try (Peer stranger = secured(server.port(), stores.of("stranger"))) {
                assertThat(stranger.isClosedByTheOtherEnd()).isTrue();
            }
            HostilePeerTest.await(() -> log.linesWith("TLS was not agreed on").size() == 1);
            try (Peer plain = Peer.dial(server.port())) {
                plain.send(new byte[] {(byte) 0xAC, (byte) 0xED, 0, 5, 0x73, 0x72});
                assertThat(plain.isClosedByTheOtherEnd()).isTrue();
            }
            HostilePeerTest.await(() -> log.linesWith("TLS was not agreed on").size() == 2);
            assertThat(healthy.move(NOBODY)).isEmpty();
        }
    }

    // A server of its own, which need not wait for the handshake of a busy machine.
    @Test
    void whoNeverBeginsAHandshakeMayNotWaitForEver() throws Exception {
        NetOptions impatient = NetOptions.defaults()
                .withAccess(stores.of("module"), null)
                .withTimes(Duration.ofMillis(400), Duration.ofSeconds(20));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(everywhere(), 0, impatient);
                Peer silent = Peer.dial(server.port())) {
            assertThat(silent.isClosedByTheOtherEnd()).isTrue();
            HostilePeerTest.await(() -> log.linesWith("TLS was not agreed on").size() == 1);
        }
    }

    @Test
    void aWholeConversationOverTlsAndAnEndOnBothSides() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(everywhere(), 0, options(stores.of("module"), null))) {
            Conversation conversation = Conversation.of(5, 50);
            Peer peer = secured(server.port(), stores.of("environment"));
            peer.send(conversation.world());
            for (int k = 0; k < 50; k++) {
                peer.send(conversation.requests().get(k));
                assertThat(peer.receive()).isEqualTo(conversation.answers().get(k));
            }
            peer.close();
            HostilePeerTest.await(() -> server.connections() == 0);
            Peer last = secured(server.port(), stores.of("environment"));
            assertThat(last.move(NOBODY)).isEmpty();
            server.close();
            assertThat(last.isClosedByTheOtherEnd()).isTrue();
            last.close();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void theClientDialsOverTlsWhomItTrusts() throws Exception {
        try (LogCapture log = new LogCapture();
                ServerSocket environment = Peer.listen();
                GeometryClient client = new GeometryClient(
                        "localhost", environment.getLocalPort(), options(stores.of("module"), null))) {
            Thread thread = new Thread(client, "geometry-client-of-a-test");
            thread.start();
            try (Peer peer = new Peer(stores.of("environment").accept(environment.accept()))) {
                assertThat(peer.move(NOBODY)).isEmpty();
            }
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(log.linesWith("closed")).isEmpty();
        }
        try (LogCapture log = new LogCapture();
                ServerSocket impostor = Peer.listen();
                GeometryClient client =
                        new GeometryClient("localhost", impostor.getLocalPort(), options(stores.of("module"), null))) {
            Thread thread = new Thread(client, "geometry-client-of-a-test");
            thread.start();
            try (Peer peer = new Peer(stores.of("stranger").accept(impostor.accept()))) {
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            thread.join(5000);
            assertThat(log.linesWith("TLS was not agreed on")).hasSize(1);
        }
    }

    @Test
    void aSecretLetsJsonPeersInWhoKnowItAndNoJavaPeer() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(everywhere(), 0, options(null, SECRET))) {
            assertThat(hello(server, ",\"secret\":\"" + WORD + "\""))
                    .contains("\"hello\"")
                    .doesNotContain(WORD);
            for (String wrong : List.of("", ",\"secret\":\"\"", ",\"secret\":\"correct horse battery stapl\"")) {
                assertThat(hello(server, wrong)).contains("\"error\"", "secret");
            }
            try (Peer java = Peer.dial(server.port())) {
                java.send(new MoveBundle(List.of(NOBODY)));
                assertThat(java.isClosedByTheOtherEnd()).isTrue();
            }
            HostilePeerTest.await(() -> log.linesWith("closed at message 1").size() == 4);
            assertThat(log.linesWith("Java serialization")).hasSize(1);
            assertThat(log.linesWith("horse")).isEmpty();
            assertThat(SECRET.toString() + options(null, SECRET)).doesNotContain("horse");
        }
    }

    /** What the module answers to a hello. */
    private static String hello(GeometryServer server, String secret) throws IOException {
        try (Peer peer = Peer.dial(server.port())) {
            peer.send(("{\"type\":\"hello\",\"version\":1" + secret + "}\n").getBytes(StandardCharsets.UTF_8));
            String line = new BufferedReader(
                            new InputStreamReader(peer.socket.getInputStream(), StandardCharsets.UTF_8))
                    .readLine();
            return line == null ? "" : line;
        }
    }

    @Test
    void whoDoesNotSayTheSecretMayNotWaitForEver() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(
                        InetAddress.getLoopbackAddress(),
                        0,
                        NetOptions.defaults()
                                .withAccess(null, SECRET)
                                .withTimes(Duration.ofMillis(200), Duration.ofSeconds(5)));
                Peer silent = Peer.dial(server.port())) {
            assertThat(silent.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.linesWith("silence for PT0.2S")).hasSize(1);
        }
    }

    @Test
    void withBothTheCertificateDoesForJavaAndJsonSaysTheSecretToo() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(everywhere(), 0, options(stores.of("module"), SECRET))) {
            try (Peer java = secured(server.port(), stores.of("environment"))) {
                Thread.sleep(400); // so long that it gets our stream header first
                assertThat(java.move(NOBODY)).isEmpty();
            }
            try (Peer json = secured(server.port(), stores.of("environment"))) {
                json.send("{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8));
                assertThat(json.isClosedByTheOtherEnd()).isTrue();
            }
            assertThat(log.linesWith("closed at message 1")).hasSize(1);
        }
    }

    @Test
    void badStoresAndSecretsAreNamedAndNoPasswordWithThem() throws Exception {
        char[] wrong = "no such password".toCharArray();
        assertThatThrownBy(() -> Tls.load(stores.path("module.p12"), wrong, stores.path("module-trusts.p12"), wrong))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("keyStore")
                .hasMessageContaining("module.p12")
                .hasMessageNotContaining("no such");
        Path text = Files.writeString(folder.resolve("text.p12"), "hello");
        assertThatThrownBy(() -> Tls.load(
                        stores.path("module.p12"), Stores.PASSWORD.toCharArray(), text, Stores.PASSWORD.toCharArray()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("trustStore")
                .hasMessageNotContaining(Stores.PASSWORD);
        assertThatThrownBy(() -> Secret.of("short".toCharArray()))
                .hasMessageContaining("16")
                .hasMessageNotContaining("short");
    }
}
