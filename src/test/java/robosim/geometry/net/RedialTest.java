package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;

/** A client that dials again, until it is closed. */
@Tag("clock")
class RedialTest {
    private static final Redial REDIAL = new Redial(Duration.ofMillis(100), Duration.ofSeconds(2));

    /** The pauses that it makes; each ends at once, but for those after the 20th in a row, which end when it is closed. */
    private final BlockingQueue<Duration> pauses = new LinkedBlockingQueue<>();

    private GeometryClient client(int port) {
        NetOptions options = NetOptions.defaults().withRedial(REDIAL);
        return new GeometryClient("127.0.0.1", port, options, new SplittableRandom(1), (closing, time) -> {
            pauses.add(time);
            if (pauses.size() > 20) {
                closing.await();
            }
        });
    }

    private static Thread start(GeometryClient client) {
        Thread thread = new Thread(client, "geometry-client-of-a-test");
        thread.start();
        return thread;
    }

    @Test
    void pausesGrowToTheLongestAndAreNeverTheSame() {
        SplittableRandom random = new SplittableRandom(5);
        Duration whole = REDIAL.first();
        for (int failures = 0; failures < 100; failures++) {
            for (int k = 0; k < 100; k++) {
                Duration pause = REDIAL.pause(failures, random);
                assertThat(pause).isBetween(whole.dividedBy(2), whole);
            }
            Duration doubled = whole.multipliedBy(2);
            whole = doubled.compareTo(REDIAL.longest()) < 0 ? doubled : REDIAL.longest();
        }
        assertThat(REDIAL.pause(3, random)).isNotEqualTo(REDIAL.pause(3, random));
        Redial days = new Redial(Duration.ofDays(1), Duration.ofDays(1));
        for (int failures = 0; failures < 1000; failures++) {
            assertThat(days.pause(failures, random)).isBetween(Duration.ofHours(12), Duration.ofHours(24));
        }
    }

    @Test
    void nobodyThereIsTriedAgainMoreAndMoreSlowly() throws Exception {
        int port;
        try (ServerSocket gone = Peer.listen()) {
            port = gone.getLocalPort();
        }
        GeometryClient client = client(port);
        Thread thread;
        try (LogCapture log = new LogCapture()) {
            thread = start(client);
            HostilePeerTest.await(() -> pauses.size() > 20);
            client.close();
            thread.join(5000);
            assertThat(log.lines()).as("above INFO").isEmpty();
        }
        assertThat(thread.isAlive()).isFalse();
        List<Duration> made = List.copyOf(pauses);
        SplittableRandom same = new SplittableRandom(1);
        for (int k = 0; k < made.size(); k++) {
            assertThat(made.get(k)).as("pause " + k).isEqualTo(REDIAL.pause(k, same));
        }
        assertThat(made.get(0)).isLessThan(Duration.ofMillis(101));
        assertThat(made.get(20)).isGreaterThan(Duration.ofMillis(999));
    }

    @Test
    void eachConnectionBeginsAnewAndOneThatWorkedPausesShortly() throws Exception {
        try (LogCapture log = new LogCapture();
                ServerSocket environment = Peer.listen();
                GeometryClient client = client(environment.getLocalPort())) {
            Conversation conversation = Conversation.of(11, 20);
            Thread thread = start(client);
            for (int dialled = 1; dialled <= 5; dialled++) {
                try (Peer peer = new Peer(environment.accept())) {
                    // There is no world left of the connection before.
                    assertThat(peer.move(new MoveRequest("robot 0", 0, 0, 0, 0, 0.1)))
                            .isEmpty();
                    peer.send(conversation.world());
                    for (int k = 0; k < conversation.requests().size(); k++) {
                        peer.send(conversation.requests().get(k));
                        Bundle answer = peer.receive();
                        assertThat(answer).isEqualTo(conversation.answers().get(k));
                    }
                    if (dialled % 2 == 0) {
                        peer.socket.setSoLinger(true, 0); // a crash
                    }
                }
                assertThat(pauses.poll(5, TimeUnit.SECONDS))
                        .isBetween(REDIAL.first().dividedBy(2), REDIAL.first());
            }
            assertThat(client.figures().getConnections()).isGreaterThanOrEqualTo(5);
            client.close();
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(log.linesWith("connection 1, message 1: no moveable object \"robot 0\", there is no world yet"))
                    .hasSize(1);
            assertThat(log.linesWith("connection 5, message 1: no moveable object \"robot 0\", there is no world yet"))
                    .hasSize(1);
        }
    }

    @Test
    void closingEndsAPauseAtOnce() throws Exception {
        int port;
        try (ServerSocket gone = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = gone.getLocalPort();
        }
        NetOptions options = NetOptions.defaults().withRedial(new Redial(Duration.ofHours(1), Duration.ofHours(2)));
        GeometryClient client = new GeometryClient("127.0.0.1", port, options);
        try (LogCapture log = new LogCapture()) {
            Thread thread = start(client);
            Thread.sleep(200);
            client.close();
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
            assertThat(log.lines()).isEmpty();
        }
    }

    @Test
    void badTimesAreNamed() {
        assertThatThrownBy(() -> new Redial(Duration.ZERO, Duration.ofSeconds(1)))
                .hasMessageContaining("first")
                .hasMessageContaining("PT0S");
        assertThatThrownBy(() -> new Redial(Duration.ofSeconds(2), Duration.ofSeconds(1)))
                .hasMessageContaining("longest must be at least first");
        assertThatThrownBy(() -> new Timeouts(Duration.ofSeconds(2), Duration.ofSeconds(1), Duration.ofDays(2)))
                .hasMessageContaining("idle");
        assertThatThrownBy(() -> new Quotas(1, 0, 1)).hasMessageContaining("objects must be at least 1 (got: 0)");
    }
}
