package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.BatchAnswerBundle;
import robosim.geometry.protocol.BatchRequestBundle;
import robosim.geometry.protocol.BatchSamples;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.batch.BeamPattern;
import robosim.geometry.protocol.batch.FreeEdgesRequest;
import robosim.geometry.protocol.batch.FreePosesRequest;
import robosim.geometry.protocol.batch.Mount;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.batch.ScanMotion;
import robosim.geometry.protocol.batch.SenseAnswer;
import robosim.geometry.protocol.batch.SenseRequest;
import robosim.geometry.protocol.json.JsonLines;

/** Batches over sockets, in both encodings. */
@Timeout(120)
class BatchEndsTest {
    private static final InitBundle WORLD = new InitBundle(List.of(
            new BoxObject(new Point(3, 0, 0), 0.2, 2, 4).named("wall"),
            new CylinderObject(new Point(), 0.25, 1).moveable("robot")));

    private static final BatchRequestBundle BATCH = new BatchRequestBundle(List.of(
            new SenseRequest("robot", new BeamPattern.Fan(-1, 0.002, 1000)),
            new SenseRequest(
                    "robot",
                    new Mount(new Point(0.2, 0, 0.1)),
                    new BeamPattern.Fan(1, -0.01, 200),
                    0.1,
                    9,
                    0,
                    false,
                    true,
                    false,
                    ScanMotion.NONE,
                    false,
                    List.of()),
            new FreePosesRequest("robot", Numbers.of(0, 0, 0, 0, 3, 0, 0, 1, 1, 0, 0, 2)),
            new FreeEdgesRequest("robot", Numbers.of(0, 0, 0, 0, 6, 0, 0, 0)),
            new SenseRequest("rover", new BeamPattern.Fan(0, 0, 1))));

    private static Reply truth(Bundle request) {
        Session session = new Session();
        session.reply(WORLD);
        return Objects.requireNonNull(session.reply(request));
    }

    @Test
    void bothEncodingsAnswerAsASessionDoes() throws IOException {
        Reply truth = truth(BATCH);
        try (GeometryServer server = new GeometryServer(0);
                Peer peer = Peer.dial(server.port());
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
            peer.send(WORLD);
            peer.send(BATCH);
            assertThat(peer.receive()).isEqualTo(truth.bundle());
            BufferedReader in = talk(socket, JsonLines.write(WORLD), JsonLines.write(BATCH));
            assertThat(in.readLine()).contains("\"hello\"");
            assertThat(in.readLine()).isEqualTo(JsonLines.write(truth));
        }
    }

    /** An init that asks, in both encodings, each followed by more without waiting. */
    @Test
    void anInitThatAsksIsToldWhatBecameOfIt() throws IOException {
        InitBundle init =
                new InitBundle(List.of(WORLD.objects().get(0), WORLD.objects().get(0)));
        Session session = new Session();
        Bundle told = Objects.requireNonNull(session.answer(new InitBundle.Answered(init)));
        try (GeometryServer server = new GeometryServer(0)) {
            try (Peer peer = Peer.dial(server.port())) {
                peer.send(new InitBundle.Answered(init));
                peer.send(new InitBundle.Answered(WORLD));
                peer.send(BATCH);
                assertThat(peer.receive()).isEqualTo(told);
                assertThat(peer.receive()).isEqualTo(new Session().answer(new InitBundle.Answered(WORLD)));
                assertThat(peer.receive()).isEqualTo(truth(BATCH).bundle());
            }
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
                BufferedReader in =
                        talk(socket, JsonLines.write(new InitBundle.Answered(init)), JsonLines.write(BATCH));
                assertThat(in.readLine()).contains("\"hello\"");
                assertThat(in.readLine()).isEqualTo(JsonLines.write(new Reply(told)));
                assertThat(in.readLine()).startsWith("{\"type\":\"answers\"");
            }
        }
    }

    private static BufferedReader talk(Socket socket, String... lines) throws IOException {
        socket.setSoTimeout(60_000);
        String text = "{\"type\":\"hello\",\"version\":1}\n" + String.join("\n", lines) + "\n";
        socket.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
        return new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
    }

    /** Several at once ask, in 170 bytes each, for as many beams as there may be, while another asks for one. */
    @Test
    void theLargestBatchesOfManyAreAnsweredWhileAnotherIsServed() throws IOException {
        BatchRequestBundle large = new BatchRequestBundle(
                List.of(new SenseRequest("robot", new BeamPattern.Fan(0, 1e-5, MessageLimits.MAX_BEAMS))));
        assertThat(JsonLines.write(large).length()).isLessThan(200);
        try (GeometryServer server = new GeometryServer(0)) {
            List<Peer> peers = new ArrayList<>();
            try {
                for (int k = 0; k < 4; k++) {
                    Peer peer = Peer.dial(server.port());
                    peers.add(peer);
                    peer.socket.setSoTimeout(100_000);
                    peer.send(WORLD);
                    peer.send(large);
                }
                try (Peer modest = Peer.dial(server.port())) {
                    modest.send(WORLD);
                    modest.send(BATCH);
                    assertThat(modest.receive()).isEqualTo(truth(BATCH).bundle());
                }
                for (Peer peer : peers) {
                    SenseAnswer answer = (SenseAnswer) ((BatchAnswerBundle) Objects.requireNonNull(peer.receive()))
                            .answers()
                            .get(0);
                    assertThat(answer.distances().size()).isEqualTo(MessageLimits.MAX_BEAMS);
                    assertThat(answer.distances().get(0)).isEqualTo(2.9);
                }
            } finally {
                for (Peer peer : peers) {
                    peer.close();
                }
            }
        }
    }

    @Test
    void moreThanTheQuotaAllowsIsRefused() throws IOException {
        NetOptions few = NetOptions.defaults().withQuotas(new Quotas(4, 100, 1000));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, few);
                Peer peer = Peer.dial(server.port());
                Peer other = Peer.dial(server.port())) {
            peer.send(WORLD);
            peer.send(new BatchRequestBundle(List.of(
                    new SenseRequest("robot", new BeamPattern.Fan(0, 0, 996)),
                    new FreePosesRequest("robot", new Numbers(new double[20])))));
            assertThat(peer.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.lines())
                    .anyMatch(line -> line.contains(
                            "a bundle must have at most 1000 beams, poses, edges and pixels (got: 1001)"));
            other.send(WORLD);
            other.send(BatchSamples.answers());
            assertThat(other.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.lines()).anyMatch(line -> line.contains("(got: BatchAnswerBundle)"));
        }
    }
}
