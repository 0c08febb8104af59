package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.SonarRequest;
import robosim.geometry.protocol.SonarRequestBundle;
import robosim.geometry.protocol.json.JsonLines;

/** Both encodings on one port, whoever dials and whoever speaks first. */
@Tag("clock")
@Timeout(60)
class EncodingsTest {
    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}\n";
    private static final InitBundle WORLD = new InitBundle(List.of(
            new BoxObject(new Point(3, 0, 0), 0.2, 2, 4).named("wall"),
            new CylinderObject(new Point(), 0.25, 1).moveable("robot")));
    private static final MoveRequest FORTH = new MoveRequest("robot", 0.5, -0.0, 0, 0, 0);
    private static final MoveRequest INTO = new MoveRequest("robot", 10.75, 0, 0, 0, 0);
    private static final MoveBundle MOVES =
            new MoveBundle(List.of(INTO, FORTH, new MoveRequest("wall", 1, 0, 0, 0, 0)));

    /** Sends lines and reads lines. */
    private static final class JsonPeer implements AutoCloseable {
        final Socket socket;
        final BufferedReader in;

        JsonPeer(Socket socket) throws Exception {
            this.socket = socket;
            socket.setSoTimeout(20_000);
            InputStream bytes = socket.getInputStream();
            in = new BufferedReader(new InputStreamReader(bytes, StandardCharsets.ISO_8859_1));
        }

        String ask(String line) throws Exception {
            send(line);
            return in.readLine();
        }

        void send(String line) throws Exception {
            socket.getOutputStream().write((line.trim() + "\n").getBytes(StandardCharsets.UTF_8));
        }

        void converse() throws Exception {
            send(JsonLines.write(WORLD));
            Reply moved = JsonLines.readReply(ask(JsonLines.write(MOVES)));
            assertThat(moved.bundle()).isEqualTo(new MoveBundle(List.of(FORTH)));
            assertThat(moved.problems())
                    .containsExactly(
                            Problem.of(0, "blocked by \"wall\" after 0.246 of the way"),
                            Problem.of(2, "no moveable object \"wall\""));
            Reply seen = JsonLines.readReply(
                    ask(JsonLines.write(new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0))))));
            assertThat(seen.bundle()).isEqualTo(new DistanceBundle(List.of(2.4)));
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    @Test
    void aServerSpeaksBothAtATime() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                JsonPeer json = new JsonPeer(new Socket(InetAddress.getLoopbackAddress(), server.port()));
                Peer java = Peer.dial(server.port())) {
            assertThat(json.ask(HELLO)).startsWith("{\"type\":\"hello\"");
            java.send(WORLD);
            json.converse();
            assertThat(java.move(INTO, FORTH)).containsExactly(FORTH);
            assertThat(java.measure(new SonarRequest("robot", 1, 0))).containsExactly(2.4);
        }
    }

    @Test
    void aClientSpeaksBothToo() throws Exception {
        try (ServerSocket environment = Peer.listen();
                GeometryClient client = new GeometryClient("127.0.0.1", environment.getLocalPort())) {
            Thread thread = new Thread(client);
            thread.start();
            try (JsonPeer json = new JsonPeer(environment.accept())) {
                assertThat(json.ask(HELLO)).startsWith("{\"type\":\"hello\"");
                json.converse();
            }
            thread.join(5000);
            assertThat(thread.isAlive()).isFalse();
        }
    }

    /** As old environments do it: the input is opened first, and waits for our header. */
    @Test
    void aJavaPeerThatOpensItsInputFirstIsServed() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            socket.setSoTimeout(20_000);
            long start = System.nanoTime();
            ObjectInputStream in = new ObjectInputStream(socket.getInputStream());
            assertThat(Duration.ofNanos(System.nanoTime() - start)).isGreaterThan(Duration.ofMillis(250));
            ObjectOutputStream out = new ObjectOutputStream(socket.getOutputStream());
            out.writeObject(WORLD);
            out.writeObject(MOVES);
            out.flush();
            assertThat(in.readObject()).isEqualTo(new MoveBundle(List.of(FORTH)));
            Thread.sleep(400); // silence later on means nothing
            out.writeObject(new SonarRequestBundle(List.of(new SonarRequest("robot", 1, 0))));
            out.flush();
            assertThat(in.readObject()).isEqualTo(new DistanceBundle(List.of(2.4)));
        }
    }

    @Test
    void aJsonPeerThatIsLateSkipsALine() throws Exception {
        try (GeometryServer server = new GeometryServer(0);
                JsonPeer json = new JsonPeer(new Socket(InetAddress.getLoopbackAddress(), server.port()))) {
            Thread.sleep(600);
            assertThat(json.ask(HELLO)).isEqualTo("\u00ac\u00ed\u0000\u0005");
            assertThat(json.in.readLine()).startsWith("{\"type\":\"hello\"");
            json.converse();
        }
    }

    @Test
    void aWrongRequestIsAnsweredAndWhatIsNoJsonEndsTheConnection() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                JsonPeer json = new JsonPeer(new Socket(InetAddress.getLoopbackAddress(), server.port()))) {
            json.ask(HELLO);
            assertThat(json.ask("{\"type\":\"moves\",\"id\":5}"))
                    .isEqualTo("{\"type\":\"error\",\"id\":5,\"continues\":true,\"message\":\"line 2, the message: must"
                            + " have the field \\\"moves\\\" (got: none)\"}");
            assertThat(log.linesWith("answered with an error: line 2, the message: must have the field"))
                    .hasSize(1);
            json.converse();
            assertThat(json.ask("{\"type\":\"moves\"]")).startsWith("{\"type\":\"error\",\"message\":\"line 6, ");
            assertThat(json.in.readLine()).isNull();
            assertThat(log.linesWith("closed at message 6, line 6, ")).hasSize(1);
        }
    }
}
