package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.net.FaultProxy.Fault;
import robosim.geometry.net.FaultProxy.Plan;

/** Many environments at once, some of which are slow. */
@Tag("clock")
class CrowdTest {
    static final int PEERS = 200;
    private static final int BUNDLES = 25;

    /** Differences between what each heard and the truth. */
    static List<String> crowd(GeometryServer server, long seed) throws InterruptedException {
        List<Conversation> conversations = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            conversations.add(Conversation.of(seed + k, BUNDLES));
        }
        Queue<String> differences = new ConcurrentLinkedQueue<>();
        CountDownLatch start = new CountDownLatch(1);
        List<Thread> threads = new ArrayList<>();
        for (int k = 0; k < PEERS; k++) {
            int number = k;
            Conversation conversation = conversations.get(k / 10 % 10);
            Thread thread = new Thread(
                    () -> {
                        try {
                            start.await();
                            String difference = one(server.port(), number, conversation);
                            if (!difference.isEmpty()) {
                                differences.add("peer " + number + ": " + difference);
                            }
                        } catch (InterruptedException | IOException e) {
                            differences.add("peer " + number + ": " + e);
                        }
                    },
                    "crowd-" + k);
            threads.add(thread);
            thread.start();
        }
        start.countDown();
        for (Thread thread : threads) {
            thread.join();
        }
        return List.copyOf(differences);
    }

    /** One in ten reads slowly, another writes byte by byte, another's network is slow. */
    private static String one(int port, int number, Conversation conversation)
            throws InterruptedException, IOException {
        return switch (number % 10) {
            case 3 ->
                conversation.difference(new Talker(port, BUNDLES, conversation)
                        .reading(k -> Thread.sleep(20))
                        .talk());
            case 5 -> through(port, Fault.SINGLE_BYTES, conversation);
            case 7 -> through(port, Fault.DELAY, conversation);
            default ->
                conversation.difference(new Talker(port, 1 + number % 5, conversation)
                        .in(number % 2 == 0 ? Tongue.JAVA : Tongue.JSON)
                        .talk());
        };
    }

    private static String through(int port, Fault fault, Conversation conversation)
            throws InterruptedException, IOException {
        try (FaultProxy proxy = new FaultProxy(port, new Plan(fault, false, 0, 1))) {
            return conversation.difference(new Talker(proxy.port(), 3, conversation).talk());
        }
    }

    @Test
    void twoHundredAtOnceAreEachAnsweredAsIfAlone() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            Conversation first =
                    Conversation.of(1, BUNDLES); // loads the classes, which takes seconds on a busy machine
            assertThat(one(server.port(), 0, first)).isEmpty();
            long start = System.nanoTime();
            assertThat(crowd(server, 100)).isEmpty();
            assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofMinutes(1));
            assertThat(server.figures().getConnections()).isEqualTo(PEERS + 1);
            assertThat(server.figures().getRefusedConnections()).isZero();
            assertThat(server.figures().getBundles()).isEqualTo((PEERS + 1) * (BUNDLES + 1L));
            assertThat(server.figures().getErrors()).isZero();
            assertThat(log.linesWith("closed")).isEmpty();
        }
    }
}
