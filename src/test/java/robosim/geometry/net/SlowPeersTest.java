package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;

/** Who reads or writes slowly stops himself; who asks for too much, or says nothing for too long, is sent away. */
@Tag("clock")
class SlowPeersTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);

    /** Its answer has 10 bytes for each distance. */
    private static final SonarRequestBundle LARGE =
            new SonarRequestBundle(Collections.nCopies(10_000, new SonarRequest("nobody", 1, 0)));

    private static GeometryServer server(Duration stall, Duration message) {
        return new GeometryServer(
                InetAddress.getLoopbackAddress(), 0, NetOptions.defaults().withTimes(stall, message));
    }

    /** What it does not read stays in the server's queue, but for a little. */
    private static Peer narrow(GeometryServer server) throws IOException {
        Socket socket = new Socket();
        socket.setReceiveBufferSize(1 << 13);
        socket.connect(server.address());
        return new Peer(socket);
    }

    /** Sends until nobody takes any more, and tells how many requests were taken. */
    private static int ask(Peer peer, AtomicInteger sent) {
        try {
            while (sent.get() < 10_000) {
                peer.send(LARGE);
                sent.incrementAndGet();
            }
        } catch (IOException e) {
            return sent.get(); // the connection was closed
        }
        return sent.get();
    }

    @Test
    void aPeerThatDoesNotReadIsAskedNoMoreAndSentAway() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofMillis(700), Duration.ofSeconds(20));
                Peer healthy = Peer.dial(server.port());
                Peer deaf = narrow(server)) {
            HostilePeerTest.await(() -> server.connections() == 2);
            AtomicInteger sent = new AtomicInteger();
            long start = System.nanoTime();
            Thread asking = new Thread(() -> ask(deaf, sent), "asking");
            asking.start();
            long healthyMoves = 0;
            while (server.connections() == 2) {
                assertThat(healthy.move(NOBODY)).isEmpty();
                healthyMoves++;
                Thread.sleep(1);
            }
            assertThat(Duration.ofNanos(System.nanoTime() - start))
                    .isBetween(Duration.ofMillis(650), Duration.ofSeconds(10));
            asking.join();
            // What fits the server's queue was answered, and what fits the two sockets was sent; neither is without
            // bound.
            long answered = server.figures().getBundles() - healthyMoves;
            assertThat(answered).as("answers of 90 kB").isBetween(1L, 10L);
            assertThat(sent.get()).isLessThan(1000);
            assertThat(log.linesWith("closed at message"))
                    .singleElement()
                    .satisfies(line -> assertThat(line).contains("the peer read nothing for 700 ms"));
            assertThat(healthy.move(NOBODY)).isEmpty();
        }
    }

    @Test
    void aPeerThatReadsSlowlyGetsEveryAnswerInOrder() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofSeconds(5), Duration.ofSeconds(20))) {
            Conversation conversation = Conversation.of(3, 300);
            List<Bundle> heard = new Talker(server.port(), 300, conversation)
                    .reading(k -> Thread.sleep(k % 50 == 0 ? 50 : 0))
                    .talk();
            assertThat(conversation.difference(heard)).isEmpty();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    @Test
    void aMessageMustBeTakenInTimeHoweverItTrickles() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofSeconds(5), Duration.ofMillis(600));
                Peer slow = Peer.dial(server.port())) {
            slow.socket.setReceiveBufferSize(1024);
            Thread asking = new Thread(() -> ask(slow, new AtomicInteger()), "asking");
            asking.start();
            byte[] few = new byte[2000];
            try {
                while (slow.socket.getInputStream().read(few) >= 0) {
                    Thread.sleep(20);
                }
            } catch (IOException e) {
                assertThat(e).hasMessageContaining("reset");
            }
            asking.join();
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(log.linesWith("closed at message"))
                    .singleElement()
                    .satisfies(line -> assertThat(line).contains("did not read a message within 600 ms"));
        }
    }

    @Test
    void theTimeOfAMessageBeginsAnewWithEachMessage() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofSeconds(2), Duration.ofSeconds(2));
                Peer peer = Peer.dial(server.port())) {
            assertThat(peer.move(NOBODY)).isEmpty();
            Thread.sleep(2100);
            Thread asking = new Thread(() -> ask(peer, new AtomicInteger(9_950)), "asking");
            asking.start();
            Thread.sleep(1000); // its queue is full meanwhile
            for (int k = 0; k < 50; k++) {
                assertThat(((DistanceBundle) peer.receive()).distances()).hasSize(10_000);
            }
            asking.join();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }

    /** Closing a socket that has unread bytes would take back what was sent. */
    @Test
    void whatWasAnsweredBeforeRubbishStillArrives() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer peer = narrow(server)) {
            peer.send(LARGE);
            peer.send(new byte[500_000]);
            Thread.sleep(100);
            assertThat(((DistanceBundle) peer.receive()).distances()).hasSize(10_000);
            assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.linesWith("closed at message 2, ")).hasSize(1);
        }
    }

    @Test
    void whoSaysNothingForTooLongIsSentAwayAndWhoAsksNowAndThenIsNot() throws Exception {
        Timeouts timeouts = new Timeouts(Duration.ofSeconds(5), Duration.ofSeconds(5), Duration.ofMillis(400));
        NetOptions options = NetOptions.defaults().withTimeouts(timeouts);
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
                Peer silent = Peer.dial(server.port());
                Peer asking = Peer.dial(server.port())) {
            assertThat(silent.move(NOBODY)).isEmpty();
            for (int k = 0; k < 8; k++) {
                assertThat(asking.move(NOBODY)).isEmpty();
                Thread.sleep(100);
            }
            assertThat(silent.isClosedByTheOtherEnd()).isTrue();
            assertThat(asking.move(NOBODY)).isEmpty();
            assertThat(log.linesWith("silence for PT0.4S"))
                    .singleElement()
                    .satisfies(line ->
                            assertThat(line).contains("closed at message 2, ", "a ping or an empty MoveBundle"));
        }
    }

    @Test
    void aWorldAndABundleHaveTheirLimits() throws Exception {
        NetOptions options = NetOptions.defaults().withQuotas(new Quotas(5, 2, 3));
        Conversation conversation = Conversation.of(1, 1);
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new InitBundle(conversation.world().objects().subList(0, 2)));
                assertThat(peer.move(NOBODY, NOBODY, NOBODY)).isEmpty();
                peer.send(new MoveBundle(List.of(NOBODY, NOBODY, NOBODY, NOBODY)));
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new InitBundle(conversation.world().objects().subList(0, 3)));
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new SonarRequestBundle(LARGE.requests().subList(0, 4)));
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            assertThat(log.linesWith("at message 3, a bundle must have at most 3 requests (got: 4)"))
                    .hasSize(1);
            assertThat(log.linesWith("at message 1, a world must have at most 2 objects (got: 3)"))
                    .hasSize(1);
            assertThat(log.linesWith("at message 1, a bundle must have at most 3 requests (got: 4)"))
                    .hasSize(1);
        }
    }
}
