package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.batch.WorldRequest;

/** The log calls messages by the numbers that they have for their sender; what it says of wrong beginnings; members of groups. */
class MessageNumbersTest {
    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}\n";
    private static final GeometryObject BOX = new BoxObject(new Point(), 1, 1, 1);

    private static MoveBundle moveOf(String name) {
        return new MoveBundle(List.of(new MoveRequest(name, 1, 0, 0, 0, 0)));
    }

    private static String line(String name) {
        return String.format(
                Locale.ROOT,
                "{\"type\":\"moves\",\"moves\":[{\"objectName\":\"%s\",\"x\":1,\"y\":0,\"z\":0,\"rx\":0,\"ry\":0}]}\n",
                name);
    }

    @Test
    void ofJsonTheyAreTheNumbersOfLines() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer peer = Peer.dial(server.port())) {
            String lines = HELLO + "{\"type\":\"ping\"}\n" + "{\"type\":\"init\",\"answer\":true,\"objects\":[]}\n"
                    + line("four") + "{\"type\":\"ping\",\"id\":5}\n" + line("six") + "nonsense\n";
            peer.send(lines.getBytes(StandardCharsets.UTF_8));
            assertThat(peer.heardToTheEnd()).contains("\"id\":5", "error");
            assertThat(log.linesWith(", message 4: no moveable object \"four\""))
                    .hasSize(1);
            assertThat(log.linesWith(", message 6: no moveable object \"six\"")).hasSize(1);
            assertThat(log.linesWith(": closed at message 7, line 7, ")).hasSize(1);
        }
    }

    @Test
    void ofJavaTheyAreTheObjectsThatWereSent() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer peer = Peer.dial(server.port())) {
            peer.send(new InitBundle.Answered(new InitBundle(List.of())));
            assertThat(peer.receive()).isNotNull();
            peer.send(moveOf("two"));
            peer.send(moveOf("three"));
            assertThat(peer.receive()).isNotNull();
            assertThat(peer.receive()).isNotNull();
            peer.send(new byte[100]);
            assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.linesWith(", message 2: no moveable object \"two\"")).hasSize(1);
            assertThat(log.linesWith(", message 3: no moveable object \"three\""))
                    .hasSize(1);
            assertThat(log.linesWith(": closed at message 4, ")).hasSize(1);
        }
    }

    @Test
    void ofASessionTheyAreItsRequests() {
        try (LogCapture log = new LogCapture()) {
            Session session = new Session(SessionOptions.ROBOSIM, SessionListener.NONE, "alone");
            session.reply(new InitBundle.Answered(new InitBundle(List.of())));
            session.reply(moveOf("two"));
            assertThat(log.lines()).singleElement().asString().startsWith("WARNING alone, message 2: ");
        }
    }

    @Test
    void aHandshakeOnThePlainPortIsCalledThat() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0)) {
            for (byte[] beginning : List.of(
                    new byte[] {0x16, 3, 1, 2, 0, 1, 0, 1, (byte) 0xFC, 3, 3},
                    "GET / HTTP/1.1\r\n".getBytes(StandardCharsets.US_ASCII))) {
                try (Peer peer = Peer.dial(server.port())) {
                    peer.send(beginning);
                    assertThat(peer.heardToTheEnd())
                            .startsWith("{\"type\":\"error\"")
                            .contains(
                                    beginning[0] == 0x16
                                            ? "without TLS, as the module was given no keys (got: the handshake of TLS)"
                                            : "JSON lines (got: 47)");
                }
            }
            assertThat(log.linesWith("closed at message 1, this port must be spoken to without TLS"))
                    .hasSize(1);
        }
    }

    @Test
    void theMembersOfGroupsCountAsObjects() throws Exception {
        ObjectGroup two = new ObjectGroup(List.of(BOX, BOX));
        ObjectGroup three = new ObjectGroup(List.of(two, BOX));
        NetOptions four = NetOptions.defaults().withQuotas(new Quotas(5, 4, 100));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, four)) {
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new InitBundle(List.of(three, two)));
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            assertThat(log.linesWith("a world must have at most 4 objects (got: 5)"))
                    .hasSize(1);
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new InitBundle(List.of(three.named("three"), BOX)));
                peer.send(new BatchRequestBundle(List.of(new WorldRequest.Remove("three"))));
                assertThat(peer.receive()).isNotNull();
                WorldRequest.Add addition = new WorldRequest.Add(three.named("again"), true);
                peer.send(new BatchRequestBundle(List.of(addition)));
                assertThat(peer.receive()).isNotNull();
                peer.send(new BatchRequestBundle(List.of(new WorldRequest.Add(BOX, true))));
                assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            }
            assertThat(log.linesWith("closed at message 4, a world must have at most 4 objects (got: 5)"))
                    .hasSize(1);
        }
    }
}
