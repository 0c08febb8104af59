package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import javax.net.ssl.SSLSocket;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/** Peers that dial and do not get as far as a first message take no place of others, and not for long. */
@Tag("clock")
class AdmissionTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);
    private static final int CROWD = 300;

    @TempDir
    static Path folder;

    private static Stores stores;

    @BeforeAll
    static void makeStores() throws Exception {
        stores = new Stores(folder);
    }

    private static NetOptions admittedWithin(Duration time) {
        return NetOptions.defaults()
                .withTimeouts(new Timeouts(Duration.ofSeconds(10), Duration.ofSeconds(60), Duration.ofDays(1), time));
    }

    private static GeometryServer server(NetOptions options) {
        return new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
    }

    private static Peer secured(int port) throws IOException {
        SSLSocket socket =
                stores.of("environment").dial(new Socket(InetAddress.getLoopbackAddress(), port), "127.0.0.1", port);
        return new Peer(socket);
    }

    private static List<Socket> crowd(int port) throws IOException {
        List<Socket> crowd = new ArrayList<>();
        for (int k = 0; k < CROWD; k++) {
            crowd.add(new Socket(InetAddress.getLoopbackAddress(), port));
        }
        return crowd;
    }

    private static void close(List<Socket> crowd) throws IOException {
        for (Socket each : crowd) {
            each.close();
        }
    }

    @Test
    void aCrowdThatSaysNothingKeepsNobodyOut() throws Exception {
        for (boolean tls : new boolean[] {false, true}) {
            NetOptions options = admittedWithin(Duration.ofSeconds(60)).withConnections(3);
            try (LogCapture log = new LogCapture();
                    GeometryServer server = server(tls ? options.withAccess(stores.of("module"), null) : options);
                    Peer first = tls ? secured(server.port()) : Peer.dial(server.port())) {
                assertThat(first.move(NOBODY)).isEmpty();
                List<Socket> crowd = crowd(server.port());
                try (Peer second = tls ? secured(server.port()) : Peer.dial(server.port())) {
                    assertThat(second.move(NOBODY)).isEmpty();
                    assertThat(first.move(NOBODY)).isEmpty();
                }
                assertThat(log.linesWith("closed before it was admitted")).isNotEmpty();
                assertThat(log.linesWith("connections are refused")).isEmpty();
                close(crowd);
            }
        }
    }

    static Stream<Arguments> beginnings() throws IOException {
        byte[] java = Peer.bytes(new MoveBundle(Collections.nCopies(50, NOBODY)));
        byte[] json = ("{\"type\":\"hello\"," + " ".repeat(2000)).getBytes(StandardCharsets.UTF_8);
        byte[] header = {(byte) 0xAC, (byte) 0xED, 0, 5};
        byte[] hello = new byte[600];
        System.arraycopy(new byte[] {0x16, 3, 1, 2, 0, 1, 0, 1, (byte) 0xFC, 3, 3}, 0, hello, 0, 11);
        return Stream.of(
                Arguments.of("nothing", false, new byte[0]),
                Arguments.of("a header", false, header),
                Arguments.of("a message of Java", false, java),
                Arguments.of("a hello", false, json),
                Arguments.of("nothing, with TLS", true, new byte[0]),
                Arguments.of("a handshake", true, hello));
    }

    /** However its bytes trickle, and although each comes in time. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("beginnings")
    void theTimeUntilTheFirstMessageIsLimitedInAll(String what, boolean tls, byte[] bytes) throws Exception {
        NetOptions options = admittedWithin(Duration.ofMillis(700));
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(tls ? options.withAccess(stores.of("module"), null) : options);
                Peer slow = Peer.dial(server.port())) {
            long start = System.nanoTime();
            HostilePeerTest.await(() -> server.connections() == 1);
            try {
                for (int k = 0; server.connections() > 0; k++) {
                    slow.send(k < bytes.length - 1 ? new byte[] {bytes[k]} : new byte[0]);
                    Thread.sleep(20);
                }
            } catch (IOException e) {
                assertThat(e).as("closed").isNotNull();
            }
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(Duration.ofNanos(System.nanoTime() - start))
                    .isBetween(Duration.ofMillis(650), Duration.ofSeconds(5));
            HostilePeerTest.await(() -> !log.linesWith("closed at message 1").isEmpty());
            assertThat(log.lines())
                    .singleElement(InstanceOfAssertFactories.STRING)
                    .contains(tls ? "took too long" : "within 700 ms");
        }
    }

    @Test
    void aLargeFirstMessageHasTheTimeOfAnyMessage() throws Exception {
        List<SonarRequest> requests = new ArrayList<>();
        for (int k = 1; k <= 20_000; k++) {
            requests.add(new SonarRequest("nobody", k, 0));
        }
        byte[] large = Peer.bytes(new SonarRequestBundle(requests));
        assertThat(large.length).isGreaterThan(450_000);
        try (GeometryServer server = server(admittedWithin(Duration.ofMillis(500)));
                Peer peer = Peer.dial(server.port())) {
            peer.send(Arrays.copyOf(large, 400_000));
            Thread.sleep(900);
            peer.send(Arrays.copyOfRange(large, 400_000, large.length));
            assertThat(((DistanceBundle) peer.receive()).distances()).hasSize(20_000);
        }
    }

    @Test
    void anAdmittedPeerMayBeSilentForLong() throws Exception {
        try (GeometryServer server = server(admittedWithin(Duration.ofMillis(300)));
                Peer java = Peer.dial(server.port());
                Peer json = Peer.dial(server.port())) {
            json.send("{\"type\":\"hello\",\"version\":1}\n".getBytes(StandardCharsets.UTF_8));
            assertThat(java.move(NOBODY)).isEmpty();
            Thread.sleep(700);
            assertThat(java.move(NOBODY)).isEmpty();
            json.send("{\"type\":\"ping\"}\n".getBytes(StandardCharsets.UTF_8));
            json.socket.shutdownOutput();
            assertThat(json.heardToTheEnd()).contains("pong");
        }
    }
}
