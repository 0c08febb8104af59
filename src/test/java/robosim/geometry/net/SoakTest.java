package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A server for a long time: several environments with long conversations, and beside them every fault again and again,
 * killed processes and crowds. What the healthy hear is the truth to the bit, and the heap stays as it is.
 *
 * <p>Some seconds in an ordinary build, minutes under {@code -Psoak}: the system properties {@code soak.seconds} and {@code
 * soak.bundles}, of one conversation. The table comes to {@code target/soak/soak.md}.
 */
@Tag("clock")
class SoakTest {
    private static final long SECONDS = Long.getLong("soak.seconds", 2);
    private static final int BUNDLES = Integer.getInteger("soak.bundles", 500);
    private static final boolean LONG = SECONDS >= 60;
    private static final int ENVIRONMENTS = 4;

    /**
     * What the heap may grow by, early to late: what crowds and faults keep at one time or another. Of a few seconds there are
     * few samples, between which what is under way at a collection differs by some megabytes.
     */
    private static final long MOST_GROWTH = (LONG ? 4 : 12) << 20;

    /** Each third of the time needs some, on a busy machine too. */
    private static final int LEAST_SAMPLES = 6;

    /** Of each of two meshes; a move of the larger ones would take days. */
    private static final int SLIVERS = LONG ? 100_000 : 2500;

    private static final int BODIES = LONG ? 3000 : 500;

    @TempDir
    private Path folder;

    /** Held while worlds of many megabytes come and go, and while what is alive is measured. */
    private final Lock large = new ReentrantLock(true);

    /** Held while a few hundred peers dial: of twice as many, some are sent away to make room for others. */
    private final Lock newcomers = new ReentrantLock(true);

    private final FaultTable table = new FaultTable();
    private final AtomicInteger conversations = new AtomicInteger();
    private final AtomicInteger differences = new AtomicInteger();
    private final AtomicLong bundles = new AtomicLong();
    private final List<Long> heap = new ArrayList<>();
    private final long start = System.nanoTime();

    private boolean isOver() {
        return System.nanoTime() - start > Duration.ofSeconds(SECONDS).toNanos();
    }

    @FunctionalInterface
    private interface Task {
        void run() throws Exception;
    }

    private Thread again(String name, Task task) {
        Thread thread = new Thread(
                () -> {
                    try {
                        do {
                            task.run();
                        } while (!isOver());
                    } catch (Exception e) {
                        table.enter(name, "failed itself: " + e);
                    }
                },
                "soak-" + name);
        thread.start();
        return thread;
    }

    @Test
    void aServerStaysUpAndStaysAsItIs() throws Exception {
        NetOptions options = NetOptions.defaults().withTimes(Duration.ofSeconds(10), Duration.ofSeconds(60));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            List<Thread> threads = new ArrayList<>();
            for (int k = 0; k < ENVIRONMENTS; k++) {
                Conversation conversation = Conversation.of(k, BUNDLES);
                threads.add(again("environment", () -> converse(server, conversation)));
            }
            AtomicInteger seed = new AtomicInteger();
            FaultRun faults = new FaultRun(server.port(), table);
            threads.add(again("faults", () -> faults.all(seed.incrementAndGet(), 30)));
            AttackRun attacks = new AttackRun(server, table, SLIVERS, BODIES);
            threads.add(again("attacks", () -> attack(attacks)));
            if (LONG) {
                threads.add(again("attacks with TLS", this::attackSecured));
                Conversation beside = Conversation.of(77, 50);
                threads.add(again("kills", () -> kill(server, beside)));
                threads.add(again("crowds", () -> crowd(server)));
            }
            sampleHeap();
            for (Thread thread : threads) {
                thread.join();
            }
            HostilePeerTest.await(() -> server.connections() == 0);
            report(server.figures());
            assertThat(table.failures()).isEmpty();
            assertThat(log.linesWith("an error of the module itself")).isEmpty();
            assertThat(differences.get()).isZero();
            assertThat(conversations.get()).isGreaterThanOrEqualTo(ENVIRONMENTS);
            assertThat(growth()).as("bytes that the heap grew by, of " + heap).isLessThan(MOST_GROWTH);
        }
    }

    private void converse(GeometryServer server, Conversation conversation) throws InterruptedException {
        int same = new Talker(server.port(), 3, conversation).compare();
        conversations.incrementAndGet();
        bundles.addAndGet(conversation.requests().size());
        if (same != conversation.requests().size()) {
            differences.incrementAndGet();
            table.enter("healthy environments", same + " of the answers were the truth");
        }
    }

    private void kill(GeometryServer server, Conversation beside) throws Exception {
        table.enter("environment killed (kill -9)", KillTest.killEnvironment(server, beside));
        table.enter("server killed (kill -9)", KillTest.killServer());
        Thread.sleep(2000);
    }

    private void attack(AttackRun attacks) throws Exception {
        large.lock();
        try {
            attacks.vanish();
        } finally {
            large.unlock();
        }
        attacks.wrong();
        newcomers.lock();
        try {
            attacks.idle(null);
        } finally {
            newcomers.unlock();
        }
        if (LONG) {
            attacks.trickle();
        }
    }

    /** A server of its own, as all peers of one server speak TLS or none does. */
    private void attackSecured() throws Exception {
        Stores stores = new Stores(Files.createTempDirectory(folder, "stores"));
        NetOptions options = NetOptions.defaults().withAccess(stores.of("module"), null);
        try (GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, options)) {
            AttackRun attacks = new AttackRun(server, table, 2, 1);
            for (int k = 0; k < 10 && !isOver(); k++) {
                attacks.idle(stores.of("environment"));
                Thread.sleep(1000);
            }
        }
    }

    private void crowd(GeometryServer server) throws InterruptedException {
        List<String> differences;
        newcomers.lock();
        try {
            differences = CrowdTest.crowd(server, 500);
        } finally {
            newcomers.unlock();
        }
        table.enter("200 at once, 60 of them slow", differences.isEmpty() ? "" : differences.toString());
        Thread.sleep(5000);
    }

    /** What is alive after a collection, while all of this goes on. */
    private void sampleHeap() throws InterruptedException {
        Runtime runtime = Runtime.getRuntime();
        while (!isOver() || heap.size() < LEAST_SAMPLES) {
            Thread.sleep(LONG ? 2000 : 100);
            long used = used(runtime);
            if (!isOver() || heap.size() < LEAST_SAMPLES) { // else the environments may have left already
                heap.add(used);
            }
        }
    }

    private long used(Runtime runtime) {
        large.lock();
        try {
            System.gc();
            return runtime.totalMemory() - runtime.freeMemory();
        } finally {
            large.unlock();
        }
    }

    /** Of the least that was alive, from the second sixth of the time, when all has been loaded, to the last third. */
    private long growth() {
        int count = heap.size();
        return least(count * 2 / 3, count) - least(count / 6, count / 2);
    }

    private long least(int from, int to) {
        return heap.subList(from, to).stream().mapToLong(Long::longValue).min().orElseThrow();
    }

    private void report(FiguresMXBean figures) throws Exception {
        String text = String.format(
                Locale.ROOT,
                """
                # Soak

                %d s, %d environments with conversations of %d bundles: %d conversations, %d bundles, %d differences.
                Heap after collections: %.1f MB early, %.1f MB late (%d samples). Server: %s.

                %s
                """,
                SECONDS,
                ENVIRONMENTS,
                BUNDLES,
                conversations.get(),
                bundles.get(),
                differences.get(),
                least(heap.size() / 6, heap.size() / 2) / 1e6,
                least(heap.size() * 2 / 3, heap.size()) / 1e6,
                heap.size(),
                figures.line(),
                table.markdown());
        String failures = String.join(System.lineSeparator(), table.failures());
        Path folder = Files.createDirectories(Path.of("target", "soak"));
        Files.writeString(folder.resolve("soak.md"), text + failures);
        if (LONG) {
            System.out.println(text + failures);
        }
    }
}
