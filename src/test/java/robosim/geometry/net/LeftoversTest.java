package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.MoveRequest;

/** After connections of every fate there are as many threads and open files as before. */
class LeftoversTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);
    private static final int FATES = 6;

    private static long threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("geometry-"))
                .count();
    }

    /** The sockets of this process; 0 on a system that does not show them. */
    private static long sockets() throws IOException {
        Path files = Path.of("/proc/self/fd");
        if (!Files.isDirectory(files)) {
            return 0;
        }
        long count = 0;
        try (Stream<Path> all = Files.list(files)) {
            for (Path each : (Iterable<Path>) all::iterator) {
                count += isSocket(each) ? 1 : 0;
            }
        }
        return count;
    }

    private static boolean isSocket(Path file) {
        try {
            return Files.readSymbolicLink(file).toString().startsWith("socket:");
        } catch (IOException e) {
            return false; // closed meanwhile: the one that lists the folder
        }
    }

    private static void live(Peer peer, int fate) throws IOException {
        switch (fate) {
            case 0 -> assertThat(peer.move(NOBODY)).isEmpty();
            case 1 -> peer.send(new byte[] {1, 2, 3});
            case 2 -> {
                assertThat(peer.move(NOBODY)).isEmpty();
                peer.socket.setSoLinger(true, 0); // a crash
            }
            case 3 -> {
                peer.send(new byte[] {(byte) 0xAC, (byte) 0xED, 0, 5, 0x73}); // stalls, if it is left open
                peer.socket.shutdownOutput();
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            case 4 ->
                peer.send("{\"type\":\"hello\",\"version\":1}\n{".getBytes(java.nio.charset.StandardCharsets.UTF_8));
            default -> {} // says nothing
        }
    }

    @Test
    void hundredsOfConnectionsLeaveNothingBehind() throws Exception {
        NetOptions options = NetOptions.defaults().withTimes(Duration.ofSeconds(1), Duration.ofSeconds(5));
        try (LogCapture log = new LogCapture()) {
            round(options, 2 * FATES); // what the JDK opens once
            long threads = threads();
            long sockets = sockets();
            assertThat(threads).isZero();
            round(options, 300);
            assertThat(threads()).isEqualTo(threads);
            assertThat(sockets()).isEqualTo(sockets);
            assertThat(log.linesWith("an error of the module itself")).isEmpty();
            assertThat(log.linesWith("closed at message")).hasSizeGreaterThan(100);
        }
    }

    /** Two thirds end by themselves; the others are there when the server is closed. */
    private static void round(NetOptions options, int connections) throws Exception {
        List<Peer> open = new ArrayList<>();
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            for (int k = 0; k < connections; k++) {
                Peer peer = Peer.dial(server.port());
                live(peer, k % FATES);
                if (k % 3 == 0) {
                    open.add(peer);
                } else {
                    peer.close();
                }
            }
            HostilePeerTest.await(() -> server.figures().getConnections() >= connections);
            assertThat(threads()).isGreaterThan(2);
        }
        for (Peer peer : open) {
            assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            peer.close();
        }
        try (ServerSocket environment = Peer.listen()) {
            for (int k = 0; k < connections / 10; k++) {
                GeometryClient client = new GeometryClient("127.0.0.1", environment.getLocalPort(), options);
                Thread thread = new Thread(client, "geometry-client-of-a-test");
                thread.start();
                try (Peer peer = new Peer(environment.accept())) {
                    live(peer, k % FATES);
                }
                client.close();
                thread.join(5000);
                assertThat(thread.isAlive()).isFalse();
            }
        }
    }
}
