package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.MoveResult;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.json.JsonLines;

/** Both ends over real sockets: how they meet, and how they part. */
@Tag("clock")
class EndsTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);

    private static Set<Thread> ownThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("geometry-"))
                .collect(Collectors.toSet());
    }

    private static Thread start(GeometryClient client) {
        Thread thread = new Thread(client, "geometry-client-of-a-test");
        thread.start();
        return thread;
    }

    private static void converse(Peer peer) throws IOException {
        peer.send(new InitBundle(List.of()));
        for (int k = 0; k < 100; k++) {
            assertThat(peer.move(NOBODY, NOBODY)).isEmpty();
            assertThat(peer.measure(new SonarRequest("nobody", 1, k))).containsExactly(Double.NaN);
        }
    }

    @Test
    void clientAnswersTheEnvironmentThatItDials() throws Exception {
        try (LogCapture log = new LogCapture();
                ServerSocket environment = Peer.listen();
                GeometryClient client = new GeometryClient("127.0.0.1", environment.getLocalPort())) {
            Thread thread = start(client);
            try (Peer peer = new Peer(environment.accept())) {
                converse(peer);
            }
            thread.join(5000);
            assertThat(thread.isAlive()).as("ends when the environment does").isFalse();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void serverAnswersEnvironmentsThatDialIn() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            assertThat(server.port()).isPositive();
            assertThat(server.address().getAddress().isLoopbackAddress()).isTrue();
            try (Peer first = Peer.dial(server.port());
                    Peer second = Peer.dial(server.port())) {
                converse(first);
                converse(second);
                assertThat(server.connections()).isEqualTo(2);
            }
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    /** Whichever of its two streams an environment opens first; it has only the JDK's own streams and the records. */
    @Test
    void bareObjectStreamsOpenInEitherOrder() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            for (boolean inputFirst : new boolean[] {true, false}) {
                try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                    socket.setSoTimeout(10_000);
                    ObjectInputStream in = inputFirst ? new ObjectInputStream(socket.getInputStream()) : null;
                    ObjectOutputStream out = new ObjectOutputStream(socket.getOutputStream());
                    if (in == null) {
                        out.flush();
                        in = new ObjectInputStream(socket.getInputStream());
                    }
                    out.writeObject(new SonarRequestBundle(List.of(new SonarRequest("nobody", 1, 0))));
                    out.flush();
                    assertThat(in.readObject()).isEqualTo(new DistanceBundle(List.of(Double.NaN)));
                    out.writeObject(new MoveBundle(List.of(NOBODY)));
                    out.flush();
                    assertThat(in.readObject()).isEqualTo(new MoveBundle(List.of()));
                }
            }
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    @Timeout(60)
    void closingTheServerLeavesNoThreadAndNoSocket() throws Exception {
        Set<Thread> before = ownThreads();
        List<Peer> peers = new ArrayList<>();
        GeometryServer server = new GeometryServer(0);
        try (LogCapture log = new LogCapture()) {
            for (int k = 0; k < 20; k++) {
                Peer peer = Peer.dial(server.port());
                peers.add(peer);
                assertThat(peer.move(NOBODY)).isEmpty();
            }
            peers.get(0).send(new byte[] {0x73}); // half a message
            assertThat(ownThreads()).hasSize(before.size() + 22);
            server.close();
            server.close();
            assertThat(ownThreads()).isEqualTo(before);
            for (Peer peer : peers) {
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
                peer.close();
            }
            assertThat(log.linesWith("closed")).isEmpty();
            assertThat(catchThrowable(() -> Peer.dial(server.port()))).isInstanceOf(IOException.class);
            try (GeometryServer again = new GeometryServer(server.port())) {
                assertThat(again.port()).isEqualTo(server.port());
            }
        }
    }

    @Test
    void closingTheServerLetsTheAnswerInWorkGoOut() throws Exception {
        CountDownLatch atWork = new CountDownLatch(1);
        SessionListener slow = new SessionListener() {
            @Override
            public void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {
                atWork.countDown();
                try {
                    Thread.sleep(300);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        };
        NetOptions options = NetOptions.defaults().withListeners(connection -> slow);
        GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
        try (LogCapture log = new LogCapture();
                Peer peer = Peer.dial(server.port())) {
            CompletableFuture<List<MoveRequest>> answer = CompletableFuture.supplyAsync(() -> {
                try {
                    return peer.move(NOBODY);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
            assertThat(atWork.await(5, TimeUnit.SECONDS)).isTrue();
            server.close();
            assertThat(answer.get(5, TimeUnit.SECONDS)).isEmpty();
            assertThat(peer.receive()).isNull();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void closingTheClientEndsItWhereverItIs() throws Exception {
        try (LogCapture log = new LogCapture();
                ServerSocket environment = Peer.listen()) {
            GeometryClient idle = new GeometryClient("127.0.0.1", environment.getLocalPort());
            Thread thread = start(idle);
            try (Peer peer = new Peer(environment.accept())) {
                converse(peer);
                idle.close();
                thread.join(5000);
                assertThat(thread.isAlive()).isFalse();
                assertThat(peer.receive()).isNull();
            }
            GeometryClient never = new GeometryClient("127.0.0.1", environment.getLocalPort());
            never.close();
            never.run();
            assertThatThrownBy(never::run).isInstanceOf(IllegalStateException.class);
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void aListenerMayCloseItsClientAndTheAnswerInWorkGoesOut() throws Exception {
        GeometryClient[] client = new GeometryClient[1];
        NetOptions options = NetOptions.defaults().withListeners(connection -> new SessionListener() {
            @Override
            public void requested(Bundle request) {
                client[0].close();
            }
        });
        try (LogCapture log = new LogCapture();
                ServerSocket environment = Peer.listen()) {
            client[0] = new GeometryClient("127.0.0.1", environment.getLocalPort(), options);
            Thread thread = start(client[0]);
            try (Peer peer = new Peer(environment.accept())) {
                assertThat(peer.move(NOBODY)).isEmpty();
                assertThat(peer.receive()).isNull();
            }
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void aListenerThatThrowsEndsItsOwnConnection() throws Exception {
        List<String> names = new ArrayList<>();
        NetOptions options = NetOptions.defaults().withListeners(connection -> {
            names.add(connection);
            return new SessionListener() {
                @Override
                public void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {
                    if (request instanceof SonarRequestBundle) {
                        throw new IllegalStateException("listener's own");
                    }
                }
            };
        });
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
                Peer first = Peer.dial(server.port())) {
            assertThat(first.move(NOBODY)).isEmpty();
            try (Peer second = Peer.dial(server.port())) {
                second.send(new SonarRequestBundle(List.of()));
                assertThat(second.isClosedByTheOtherEnd()).isTrue();
            }
            try (Peer third = Peer.dial(server.port())) {
                third.send("{\"type\":\"hello\",\"version\":1}\n{\"type\":\"sonars\",\"requests\":[]}\n"
                        .getBytes(StandardCharsets.UTF_8));
                assertThat(third.heardToTheEnd())
                        .contains("{\"type\":\"error\",\"message\":\"an internal error of the module");
            }
            assertThat(first.move(NOBODY)).isEmpty();
            assertThat(log.linesWith("error of the module itself")).hasSize(2);
            assertThat(names).hasSize(3).doesNotHaveDuplicates();
        }
    }

    @Test
    void nobodyThereIsSaidSo() throws Exception {
        int port;
        try (ServerSocket gone = Peer.listen()) {
            port = gone.getLocalPort();
        }
        assertThatThrownBy(() -> new GeometryClient("127.0.0.1", port).run())
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("127.0.0.1:" + port);
        assertThatThrownBy(() -> new GeometryClient("no.such.host.invalid", port).run())
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("no.such.host.invalid");
        try (GeometryServer server = new GeometryServer(0)) {
            assertThatThrownBy(() -> new GeometryServer(server.port()))
                    .isInstanceOf(UncheckedIOException.class)
                    .hasMessageContaining(":" + server.port());
        }
    }

    @Test
    void badArgumentsAreNamed() {
        assertThatThrownBy(() -> new GeometryClient("localhost", 0))
                .hasMessageContaining("port")
                .hasMessageContaining("0");
        assertThatThrownBy(() -> new GeometryServer(65536)).hasMessageContaining("65536");
        assertThatThrownBy(() -> GeometryClient.main(new String[] {"localhost"}))
                .hasMessageContaining("localhost");
        assertThatThrownBy(() -> GeometryClient.main(new String[] {"localhost", "x"}))
                .hasMessageContaining("x");
        assertThatThrownBy(() -> NetOptions.defaults().withConnections(0)).hasMessageContaining("connections");
    }

    /** A bundle that would take minutes: it is cut off, and its peer is told; so is the log. */
    @Test
    @Timeout(60)
    void whatIsNotAnsweredInTimeIsCutOffAndToldSo() throws Exception {
        CountDownLatch atWork = new CountDownLatch(2);
        class Slow implements SessionListener {
            private boolean begun;

            @Override
            public void tried(MoveRequest request, MoveResult result) {
                if (!begun) {
                    atWork.countDown();
                }
                begun = true;
                try {
                    Thread.sleep(20);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        }
        NetOptions options = NetOptions.defaults().withListeners(connection -> new Slow());
        InitBundle world = new InitBundle(List.of(new CylinderObject(new Point(), 0.25, 1).moveable("robot")));
        MoveBundle minutes = new MoveBundle(Collections.nCopies(10_000, new MoveRequest("robot", 0, 0, 0, 0, 0)));
        Set<Thread> before = ownThreads();
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
                Peer json = Peer.dial(server.port());
                Peer java = Peer.dial(server.port())) {
            json.send(("{\"type\":\"hello\",\"version\":1}\n" + JsonLines.write(world) + "\n" + JsonLines.write(minutes)
                            + "\n")
                    .getBytes(StandardCharsets.UTF_8));
            java.send(world);
            java.send(minutes);
            assertThat(atWork.await(20, TimeUnit.SECONDS)).isTrue();
            server.close();
            assertThat(ownThreads()).isEqualTo(before);
            assertThat(json.heardToTheEnd())
                    .contains("\"message\":\"the module is shutting down: message 3 was cut off, and has no answer\"");
            assertThat(java.receive()).isNull();
            assertThat(log.linesWith("closed at message 2, which was cut off and has no answer"))
                    .as("of Java")
                    .hasSize(1);
            assertThat(log.linesWith("closed at message 3, which was cut off and has no answer"))
                    .as("of JSON, whose hello is the first")
                    .hasSize(1);
        }
    }

    @Test
    void whoIsRefusedForLackOfMemoryIsToldThat() throws Exception {
        NetOptions options = NetOptions.defaults().withListeners(connection -> new SessionListener() {
            @Override
            public void requested(Bundle request) {
                throw new OutOfMemoryError("Java heap space");
            }
        });
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
                Peer peer = Peer.dial(server.port())) {
            peer.send("{\"type\":\"hello\",\"version\":1}\n{\"type\":\"sonars\",\"requests\":[]}\n"
                    .getBytes(StandardCharsets.UTF_8));
            assertThat(peer.heardToTheEnd())
                    .contains("the module does not have enough memory for this request")
                    .doesNotContain("an error of the module itself");
            assertThat(log.linesWith("closed at message 2, the module does not have enough memory"))
                    .hasSize(1)
                    .first()
                    .asString()
                    .startsWith("WARNING")
                    .contains("(got: java.lang.OutOfMemoryError: Java heap space)");
        }
    }

    /** Six peers that complain about ever new worlds: what they can write is bounded, and counted. */
    @Test
    @Timeout(60)
    void aLogIsNotFilledByPeers() throws Exception {
        int worlds = 1500;
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            for (int k = 0; k < 3; k++) {
                try (Peer peer = Peer.dial(server.port())) {
                    for (int world = 0; world < worlds; world++) {
                        peer.send(new InitBundle(List.of()));
                        peer.send(new MoveBundle(List.of(NOBODY)));
                        assertThat(((MoveBundle) peer.receive()).moves()).isEmpty();
                    }
                }
            }
            assertThat(log.lines().size()).isBetween(2000, 2900); // and 10 for each second that this took
        }
    }
}
