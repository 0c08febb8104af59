package robosim.geometry.net;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import robosim.geometry.protocol.json.WorldLoader;
import robosim.geometry.scenario.drive.WorldLoading;
import robosim.geometry.world.shared.RegularFile;

/** A load has the limits of every other request, and ends with its peer and with the server. */
@Tag("clock")
class LoadLimitTest {
    private static final String BOX = "<box width='1' height='1' length='1'/>";

    private final List<IOException> ended = new CopyOnWriteArrayList<>();

    private static String hello() {
        return "{\"type\":\"hello\",\"version\":1}\n";
    }

    private static String load(String content) {
        return "{\"type\":\"load\",\"file\":\"w.xml\",\"named\":true,\"files\":{\"w.xml\":\""
                + Base64.getEncoder()
                        .encodeToString(("<world xmlns='urn:robosim:world:1' width='4' height='4' length='4'>" + content
                                        + "</world>")
                                .getBytes(UTF_8))
                + "\"}}\n";
    }

    private static String many(int boxes) {
        return IntStream.range(0, boxes).mapToObj(k -> BOX).collect(Collectors.joining("\n"));
    }

    private static GeometryServer server(Duration time, long work, WorldLoader loader) {
        NetOptions options = NetOptions.defaults()
                .withQuotas(Quotas.DEFAULT.withRequestLimit(time, work))
                .withWorlds(loader);
        return new GeometryServer(InetAddress.getLoopbackAddress(), 0, options);
    }

    private static BufferedReader heard(Peer peer) throws IOException {
        return new BufferedReader(new InputStreamReader(peer.socket.getInputStream(), UTF_8));
    }

    /** Keeps on loading until it is told to end, as a loader does that reads a file without an end. */
    private static final class Endless implements WorldLoader {
        final CountDownLatch begun = new CountDownLatch(1);
        final CountDownLatch ended = new CountDownLatch(1);

        @Override
        public WorldLoader.Loaded load(WorldLoader.Load load) {
            throw new AssertionError("a server counts the work of a load");
        }

        @Override
        public WorldLoader.Loaded load(WorldLoader.Load load, LongConsumer work) {
            begun.countDown();
            try {
                while (true) {
                    work.accept(1);
                }
            } finally {
                ended.countDown();
            }
        }
    }

    @Test
    void aFileOfTooMuchWorkIsAnsweredWithAnErrorAndTheWorldStays() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofMinutes(1), 2000, WorldLoading.of(null, List.of()));
                Peer peer = Peer.dial(server.port());
                BufferedReader heard = heard(peer)) {
            peer.send((hello() + load(BOX) + load(many(3000))
                            + "{\"type\":\"batch\",\"requests\":[{\"kind\":\"world\"}]}\n" + load(BOX + BOX)
                            + "{\"type\":\"fly\"}\n")
                    .getBytes(UTF_8));
            assertThat(heard.readLine()).contains("\"hello\"");
            assertThat(heard.readLine()).contains("\"answers\"").contains("\"added\":1");
            assertThat(heard.readLine())
                    .contains("\"error\"")
                    .contains("line 3, a request must take at most 2000 units of work");
            assertThat(heard.readLine()).contains("\"answers\"").contains("\"added\":1");
            assertThat(heard.readLine()).contains("\"answers\"").contains("\"added\":2");
            assertThat(heard.readLine()).contains("must be init, load, moves, sonars, batch, step or ping (got: ");
            assertThat(log.linesWith("line 3, a request must take at most 2000 units of work"))
                    .hasSize(1);
        }
    }

    @Test
    void aLoadThatTakesTooLongIsEndedAndSeenByTheOperator() throws Exception {
        Endless loader = new Endless();
        try (GeometryServer server = server(Duration.ofMillis(300), Long.MAX_VALUE, loader);
                Peer peer = Peer.dial(server.port());
                BufferedReader heard = heard(peer)) {
            peer.send((hello() + load("") + "{\"type\":\"ping\"}\n").getBytes(UTF_8));
            assertThat(heard.readLine()).contains("\"hello\"");
            assertThat(loader.begun.await(20, TimeUnit.SECONDS)).isTrue();
            GeometryServer.Peer seen = server.peers().get(0);
            assertThat(seen.request()).isIn("Load", null); // null if it has ended by now
            assertThat(seen.admitted()).isTrue();
            assertThat(heard.readLine())
                    .contains("\"error\"")
                    .contains("a request must take at most 300 ms of processor time");
            assertThat(heard.readLine()).contains("\"pong\"");
        }
    }

    @Test
    void aLoadEndsWhenItsPeerIsGone() throws Exception {
        Endless loader = new Endless();
        try (LogCapture log = new LogCapture();
                GeometryServer server = server(Duration.ofHours(1), Long.MAX_VALUE, loader)) {
            try (Peer peer = Peer.dial(server.port())) {
                peer.send((hello() + load("")).getBytes(UTF_8));
                assertThat(loader.begun.await(20, TimeUnit.SECONDS)).isTrue();
                assertThat(server.peers().get(0).request()).isEqualTo("Load");
            }
            assertThat(loader.ended.await(20, TimeUnit.SECONDS)).isTrue();
            HostilePeerTest.await(() -> server.connections() == 0);
            assertThat(log.linesWith("its work was cancelled, as the peer has gone"))
                    .hasSize(1);
        }
    }

    /** Even where its own thread has no time left to remove them. */
    @Test
    void noFilesStayOfALoadThatIsUnderWayAtTheEnd() throws Exception {
        WorldLoading loading = WorldLoading.of(null, List.of());
        WorldLoader.Load load = new WorldLoader.Load(
                "models/a.obj", Map.of("models/a.obj", "v 0 0 0\n".repeat(9999).getBytes(UTF_8)), null, false);
        AtomicReference<Path> opened = new AtomicReference<>();
        CountDownLatch reading = new CountDownLatch(1);
        CountDownLatch go = new CountDownLatch(1);
        Thread thread = new Thread(() -> {
            try {
                RegularFile.told(
                        opened::set,
                        () -> loading.load(load, units -> {
                            reading.countDown();
                            try {
                                go.await();
                            } catch (InterruptedException e) {
                                Thread.currentThread().interrupt();
                            }
                        }));
            } catch (IOException e) {
                ended.add(e);
            }
        });
        thread.start();
        assertThat(reading.await(20, TimeUnit.SECONDS)).isTrue();
        Path place = opened.get().getParent().getParent();
        assertThat(place).isDirectory();
        loading.close();
        assertThat(place).doesNotExist();
        go.countDown();
        thread.join();
        assertThat(place).doesNotExist();
        assertThat(ended).singleElement().satisfies(e -> assertThat(e).hasMessageContaining("at least one face"));
        assertThatThrownBy(() -> loading.load(load))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("the module is shutting down");
    }

    @Test
    void aLoadEndsWithTheServerAndItsPeerIsTold() throws Exception {
        Endless loader = new Endless();
        GeometryServer server = server(Duration.ofHours(1), Long.MAX_VALUE, loader);
        try (Peer peer = Peer.dial(server.port())) {
            peer.send((hello() + load("")).getBytes(UTF_8));
            assertThat(loader.begun.await(20, TimeUnit.SECONDS)).isTrue();
            server.close();
            assertThat(loader.ended.await(20, TimeUnit.SECONDS)).isTrue();
            assertThat(peer.heardToTheEnd())
                    .contains("the module is shutting down: message 2 was cut off, and has no answer");
        } finally {
            server.close();
        }
    }
}
