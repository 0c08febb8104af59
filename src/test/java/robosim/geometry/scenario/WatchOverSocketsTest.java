package robosim.geometry.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.net.GeometryServer;
import robosim.geometry.net.LogCapture;
import robosim.geometry.net.NetOptions;
import robosim.geometry.net.SessionOptions;
import robosim.geometry.net.watch.WatchServer;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.scenario.source.WatchReader;

/** A server that is watched, over loopback. */
@Tag("clock")
@Timeout(120)
class WatchOverSocketsTest {
    private static final GeometryObject WALL = new BoxObject(new Point(30, 0, 0), 1, 1, 4).named("wall");
    private static final GeometryObject ROBOT = new CylinderObject(new Point(), 0.5, 1).moveable("r");
    private static final Bundle INIT = new InitBundle(List.of(WALL, ROBOT));
    private static final Bundle FORWARD = new MoveBundle(List.of(Conversation.move("r", 0.25, 0)));

    private final LogCapture log = new LogCapture("robosim.geometry.net");
    private final NetOptions options = NetOptions.defaults();
    private final Watching watching = new Watching(options.session());
    private final GeometryServer server =
            new GeometryServer(InetAddress.getLoopbackAddress(), 0, options.withListeners(watching));
    private final WatchServer watch = new WatchServer(0, watching::join);

    @AfterEach
    void close() {
        watch.close();
        server.close();
        log.close();
    }

    /** An environment. */
    private final class Environment implements AutoCloseable {
        private final Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
        private final MessageWriter writer = new MessageWriter(socket.getOutputStream());
        private final MessageReader reader = new MessageReader(socket.getInputStream());

        Environment() throws Exception {
            socket.setTcpNoDelay(true);
            writer.write(INIT);
        }

        Bundle ask(Bundle request) throws Exception {
            writer.write(request);
            return reader.read();
        }

        @Override
        public void close() throws Exception {
            socket.close();
        }
    }

    private static WatchReader dial(int port) throws Exception {
        return WatchReader.dial(InetAddress.getLoopbackAddress().getHostAddress(), port);
    }

    @Test
    void aLateWatcherSeesTheWorldAndThenEachStepAsItHappens() throws Exception {
        try (Environment environment = new Environment()) {
            environment.ask(FORWARD);
            try (WatchReader reader = dial(watch.port())) {
                Step now = reader.next();
                InitBundle world = (InitBundle) now.request();
                assertThat(world.objects().get(1).center()).isEqualTo(new Point(0.25, 0, 0));
                for (int k = 0; k < 50; k++) {
                    Bundle answer = environment.ask(FORWARD);
                    Step step = reader.next(); // at once, not with the next one
                    assertThat(step.request()).isEqualTo(FORWARD);
                    assertThat(step.expected().bundle()).isEqualTo(answer);
                }
                assertThat(reader.state()).isEmpty();
            }
        }
    }

    @Test
    void whatAWatcherSendsIsHeardByNobody() throws Exception {
        try (Environment environment = new Environment();
                Socket rude = new Socket(InetAddress.getLoopbackAddress(), watch.port())) {
            environment.ask(FORWARD);
            BufferedReader lines = new BufferedReader(new InputStreamReader(rude.getInputStream(), "UTF-8"));
            assertThat(lines.readLine()).contains("\"scenario\"");
            String forged = "{\"type\":\"init\",\"objects\":[]}\n".repeat(100);
            try {
                rude.getOutputStream().write(forged.getBytes("UTF-8"));
                rude.getOutputStream().write(forged.getBytes("UTF-8"));
            } catch (java.io.IOException refused) {
                assertThat(refused).isNotNull(); // as the system has it
            }
            for (int k = 0; k < 10; k++) {
                assertThat(environment.ask(FORWARD)).isEqualTo(FORWARD);
            }
            assertThat(log.lines()).isEmpty();
        }
    }

    @Test
    void aWatcherThatReadsNothingHoldsUpNobodyAndIsLetGoWithOneLine() throws Exception {
        List<SonarRequest> many = new ArrayList<>();
        for (int k = 0; k < 20_000; k++) {
            many.add(new SonarRequest("r", 1, 0));
        }
        Bundle large = new SonarRequestBundle(many);
        try (Environment environment = new Environment();
                Socket deaf = new Socket()) {
            deaf.setReceiveBufferSize(4096);
            deaf.connect(watch.address());
            environment.ask(FORWARD);
            while (watch.watchers() == 0) {
                Thread.onSpinWait();
            }
            // More than its queue and the sockets hold; each is answered.
            int asked = 0;
            while (log.linesWith("is told no more").isEmpty() && asked < 2000) {
                assertThat(environment.ask(large)).isNotNull();
                asked++;
            }
            assertThat(asked).isBetween(2, 1999);
            assertThat(environment.ask(FORWARD)).isEqualTo(FORWARD);
            while (watch.watchers() > 0) {
                Thread.onSpinWait();
            }
            assertThat(log.lines()).hasSize(1);
            assertThat(log.lines().get(0)).contains("watch " + watch.port() + ", peer /127.0.0.1:", "is told no more");
        }
    }

    @Test
    void whoIsGoneIsForgottenAndThereIsAnEndToThem() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        for (int k = 0; k < WatchServer.MOST_WATCHERS; k++) {
            sockets.add(new Socket(InetAddress.getLoopbackAddress(), watch.port()));
            assertThat(sockets.get(k).getInputStream().read()).isEqualTo('{');
        }
        try (Socket more = new Socket(InetAddress.getLoopbackAddress(), watch.port())) {
            assertThat(more.getInputStream().read()).isEqualTo(-1);
        }
        assertThat(log.linesWith("refused, there are 16")).hasSize(1);
        for (Socket socket : sockets) {
            socket.close();
        }
        while (watch.watchers() > 0) { // found out by the empty lines
            Thread.sleep(50);
        }
    }

    @Test
    void aServerThatIsGoneIsDialledAgain() throws Exception {
        WatchServer first = new WatchServer(0, watching::join);
        try (Environment environment = new Environment();
                WatchReader reader = dial(first.port())) {
            environment.ask(FORWARD);
            assertThat(reader.next()).isNotNull();
            int port = first.port();
            first.close();
            try (WatchServer second = new WatchServer(port, watching::join)) {
                Step step = reader.next();
                while (!(step.request() instanceof InitBundle)) {
                    step = reader.next();
                }
                assertThat(step.notes().get(0)).contains("as it is");
                assertThat(second.watchers()).isEqualTo(1);
            }
        }
    }

    @Test
    void nobodyThereIsToldWithTheRemedy() throws Exception {
        int free;
        try (ServerSocket socket = new ServerSocket(0)) {
            free = socket.getLocalPort();
        }
        assertThatThrownBy(() -> dial(free)).hasMessageContaining("--watch " + free);
    }

    @Test
    void whoIsOneTooManyIsToldSo() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        for (int k = 0; k < WatchServer.MOST_WATCHERS; k++) {
            sockets.add(new Socket(InetAddress.getLoopbackAddress(), watch.port()));
            assertThat(sockets.get(k).getInputStream().read()).isEqualTo('{');
        }
        assertThatThrownBy(() -> dial(watch.port()))
                .hasMessageContaining("hung up at once; perhaps 16 are watching already");
        for (Socket socket : sockets) {
            socket.close();
        }
    }

    /** A server that tells each who dials the same and hangs up, as it were another one each time. */
    private static final class Fickle implements AutoCloseable {
        private final ServerSocket listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        private final List<String> told;
        private final List<Long> dialled = Collections.synchronizedList(new ArrayList<>());
        private final Thread thread = new Thread(this::tell);

        Fickle(String... told) throws Exception {
            this.told = List.of(told);
            thread.start();
        }

        /** The last one again and again. */
        private void tell() {
            for (int k = 0; ; k++) {
                try (Socket socket = listening.accept()) {
                    dialled.add(System.nanoTime());
                    String lines = told.get(Math.min(k, told.size() - 1));
                    socket.getOutputStream().write(lines.getBytes(StandardCharsets.UTF_8));
                } catch (IOException e) {
                    return;
                }
            }
        }

        int port() {
            return listening.getLocalPort();
        }

        @Override
        public void close() throws Exception {
            listening.close();
            thread.join();
        }
    }

    private static String header(String title, Dimension dimension) {
        SessionOptions ours = SessionOptions.ROBOSIM;
        return new ScenarioHeader(title, new SessionOptions(dimension, ours.accuracy(), ours.beam())).line() + "\n";
    }

    @Test
    void anotherServerHasItsOwnHeader() throws Exception {
        String init = JsonLines.write(INIT) + "\n";
        try (Fickle fickle = new Fickle(header("a", Dimension.PLANAR) + init, header("b", Dimension.SPATIAL) + init);
                WatchReader reader = dial(fickle.port())) {
            assertThat(reader.next()).isNotNull();
            assertThat(reader.header().title()).isEqualTo("a");
            assertThat(reader.next()).isNotNull();
            assertThat(reader.header().title()).isEqualTo("b");
            assertThat(reader.header().options().dimension()).isEqualTo(Dimension.SPATIAL);
        }
    }

    @Test
    void whoTellsNothingIsDialledLessAndLessOftenAndItIsSaidWhy() throws Exception {
        String note = "{\"type\":\"note\",\"text\":\"the world is too large\"}\n";
        try (Fickle fickle = new Fickle(header("a", Dimension.PLANAR) + note);
                WatchReader reader = dial(fickle.port())) {
            Thread thread = new Thread(reader::next);
            thread.start();
            while (fickle.dialled.size() < 3 || !reader.state().endsWith("again in 4 s")) {
                Thread.sleep(10);
            }
            assertThat(reader.state())
                    .isEqualTo("the server has hung up: the world is too large; dialling again in 4 s");
            List<Long> at = List.copyOf(fickle.dialled);
            assertThat(at).hasSize(3);
            assertThat(at.get(1) - at.get(0)).isGreaterThanOrEqualTo(990_000_000L);
            assertThat(at.get(2) - at.get(1)).isGreaterThanOrEqualTo(1_990_000_000L);
            reader.close();
            thread.join();
        }
    }

    @Test
    void whatIsNoScenarioIsHungUpOn() {
        for (String told : List.of("", "\n\n", "HTTP/1.1 400 Bad Request\r\n", "{\"type\":\"note\",\"text\":\"\"}\n")) {
            AtomicBoolean hungUp = new AtomicBoolean();
            InputStream dialled = new ByteArrayInputStream(told.getBytes(StandardCharsets.UTF_8)) {
                @Override
                public void close() {
                    hungUp.set(true);
                }
            };
            assertThatThrownBy(() -> WatchReader.begin(dialled, "peer")).isInstanceOf(IOException.class);
            assertThat(hungUp).as("after %s", told).isTrue();
        }
    }
}
