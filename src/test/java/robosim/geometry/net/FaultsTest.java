package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.MoveBundle;

/** Bad networks cost their own connection at most; what a healthy one hears is what an undisturbed run says, to the bit. */
@Tag("clock")
class FaultsTest {
    @Test
    void everyFaultIsSurvivedAndNobodyElseNotices() throws Exception {
        NetOptions options = NetOptions.defaults().withTimes(Duration.ofSeconds(5), Duration.ofSeconds(20));
        FaultTable table = new FaultTable();
        AtomicBoolean over = new AtomicBoolean();
        AtomicInteger rounds = new AtomicInteger();
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            Conversation healthy = Conversation.of(1, 40);
            Thread witness = new Thread(() -> witness(server.port(), healthy, over, rounds, table), "witness");
            witness.start();
            FaultRun run = new FaultRun(server.port(), table);
            for (int seed = 0; seed < 4; seed++) {
                run.all(seed, 30);
            }
            over.set(true);
            witness.join();
            assertThat(table.failures()).isEmpty();
            assertThat(table.tried()).isEqualTo(4 * 16 + rounds.get());
            assertThat(rounds.get()).as("healthy conversations meanwhile").isGreaterThan(1);
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(server.figures().getErrors())
                    .as("faults that it noticed")
                    .isBetween(4L, 60L);
            assertThat(log.linesWith("closed at message"))
                    .hasSize((int) server.figures().getErrors());
        }
    }

    private static void witness(
            int port, Conversation conversation, AtomicBoolean over, AtomicInteger rounds, FaultTable table) {
        try {
            while (!over.get()) {
                String difference = conversation.difference(new Talker(port, 3, conversation).talk());
                rounds.incrementAndGet();
                table.enter("none, beside the others", difference);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void theConversationsAreWorthSomething() {
        Conversation conversation;
        try (LogCapture log = new LogCapture()) {
            conversation = Conversation.of(7, 200);
            assertThat(conversation).isEqualTo(Conversation.of(7, 200));
            assertThat(log.linesWith("robot 6")).isNotEmpty();
        }
        List<Double> distances = conversation.answers().stream()
                .filter(DistanceBundle.class::isInstance)
                .flatMap(bundle -> ((DistanceBundle) bundle).distances().stream())
                .toList();
        assertThat(distances).hasSizeGreaterThan(500);
        assertThat(distances.stream().filter(distance -> distance.isNaN()).count())
                .isBetween(1L, 100L);
        assertThat(distances.stream().distinct().count()).isGreaterThan(distances.size() / 2);
        long asked = 0;
        long made = 0;
        for (int k = 0; k < 200; k++) {
            if (conversation.requests().get(k) instanceof MoveBundle moves) {
                asked += moves.moves().size();
                made += ((MoveBundle) conversation.answers().get(k)).moves().size();
            }
        }
        assertThat((double) made / asked).as("share of moves made").isBetween(0.3, 0.95);
    }
}
