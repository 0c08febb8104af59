package robosim.geometry.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.SonarRequest;

/** Peers that send rubbish, stall or vanish lose their own connection, with a line in the log, and nothing else. */
@Tag("clock")
public class HostilePeerTest {
    private static final MoveRequest NOBODY = new MoveRequest("nobody", 1, 0, 0, 0, 0);

    static Stream<Arguments> rubbish() throws IOException {
        Set<Object> nested = new HashSet<>();
        for (int k = 0; k < 20; k++) {
            nested = new HashSet<>(List.of(nested, "x" + k));
        }
        // Immutable sets travel as java.util.CollSer, as the bundles' own lists do.
        Object immutable = Set.of(Set.of(1.0), 2.0);
        byte[] message = Peer.bytes(new MoveBundle(List.of(NOBODY)));
        byte[] garbled = message.clone();
        garbled[20] ^= 0x55;
        return Stream.of(
                Arguments.of("text", "GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII), "AC ED 00 05"),
                Arguments.of("zeros", new byte[100], "AC ED 00 05"),
                Arguments.of("other version", bytes(0xACED0006, 0), "StreamCorrupted"),
                Arguments.of(
                        "header, then text", join(header(), "hello".getBytes(StandardCharsets.UTF_8)), "not a message"),
                Arguments.of("garbled message", garbled, "list"),
                Arguments.of("hash map", stream(new HashMap<>()), "class \"java.util.HashMap\""),
                Arguments.of("nested sets", stream(nested), "class \"java.util.HashSet\""),
                Arguments.of("nested immutable sets", stream(immutable), "ImmutableCollections$Set"),
                Arguments.of("null", stream((Object) null), "null"),
                Arguments.of("text object", stream("hello"), "must be a bundle"),
                Arguments.of("an answer", Peer.bytes(new DistanceBundle(List.of(1.0))), "DistanceBundle"),
                Arguments.of("array without end", forgedArray(Integer.MAX_VALUE), "at most 4000000 items"),
                Arguments.of("array of negative length", forgedArray(-1), "not a message"),
                Arguments.of("proxy", join(header(), new byte[] {0x73, 0x7D, 0, 0, 0, 0}), "proxy"),
                Arguments.of("number", stream(3.5), "must be a bundle"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("rubbish")
    void rubbishCostsItsOwnConnectionAndNoMore(String what, byte[] bytes, String reason) throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer healthy = Peer.dial(server.port());
                Peer hostile = Peer.dial(server.port())) {
            healthy.send(new InitBundle(List.of()));
            assertThat(healthy.move(NOBODY)).isEmpty();
            hostile.send(bytes);
            assertThat(hostile.isClosedByTheOtherEnd()).as(what).isTrue();
            assertThat(healthy.measure(new SonarRequest("nobody", 1, 0))).containsExactly(Double.NaN);
            assertThat(log.linesWith("closed"))
                    .singleElement()
                    .satisfies(line -> assertThat(line)
                            .contains(reason)
                            .contains(":" + hostile.socket.getLocalPort())
                            .startsWith("WARNING"));
        }
    }

    @Test
    void aTextOf64MegabytesIsRefusedBeforeItIsRead() throws Exception {
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer hostile = Peer.dial(server.port())) {
            hostile.send(join(header(), new byte[] {0x7C, 0, 0, 0, 0, 0x04, 0, 0, 0}));
            byte[] letters = new byte[1 << 16];
            Arrays.fill(letters, (byte) 'a');
            int sent = 0;
            try {
                while (sent < 1 << 10) {
                    hostile.send(letters);
                    sent++;
                }
            } catch (IOException e) {
                assertThat(sent).as("blocks of 64 kB before the reset").isLessThan(1000);
            }
            assertThat(hostile.isClosedByTheOtherEnd()).isTrue();
            assertThat(log.linesWith("a string must have at most 65535 bytes")).hasSize(1);
        }
    }

    @Test
    void aMessageThatStallsHalfWayIsGivenUpAndIdlenessIsNot() throws Exception {
        NetOptions impatient = NetOptions.defaults().withTimes(Duration.ofMillis(200), Duration.ofMillis(500));
        byte[] message = Peer.bytes(new MoveBundle(List.of(NOBODY)));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, impatient);
                Peer idle = Peer.dial(server.port());
                Peer stalled = Peer.dial(server.port());
                Peer slow = Peer.dial(server.port())) {
            assertThat(idle.move(NOBODY)).isEmpty();
            stalled.send(Arrays.copyOf(message, message.length / 2));
            long start = System.nanoTime();
            assertThat(stalled.isClosedByTheOtherEnd()).isTrue();
            assertThat(Duration.ofNanos(System.nanoTime() - start))
                    .isBetween(Duration.ofMillis(150), Duration.ofSeconds(5));
            // A byte now and then never stalls, but the message as a whole is due some time.
            int sent = 0;
            try {
                for (; sent < message.length; sent++) {
                    slow.send(new byte[] {message[sent]});
                    Thread.sleep(20);
                }
            } catch (IOException e) {
                assertThat(sent).isGreaterThan(4);
            }
            assertThat(sent).isLessThan(message.length);
            assertThat(slow.isClosedByTheOtherEnd()).isTrue();
            assertThat(idle.move(NOBODY)).as("idle for longer than both times").isEmpty();
            assertThat(log.linesWith("stalled")).hasSize(2);
        }
    }

    @Test
    void aPeerThatVanishesInsideAMessageIsMissedByNobody() throws Exception {
        byte[] message = Peer.bytes(new MoveBundle(List.of(NOBODY)));
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(0);
                Peer healthy = Peer.dial(server.port())) {
            assertThat(healthy.move(NOBODY)).isEmpty();
            for (int cut : new int[] {1, 3, 5, 20, message.length / 2, message.length - 2}) {
                try (Peer leaving = Peer.dial(server.port())) {
                    leaving.send(Arrays.copyOf(message, cut));
                    leaving.socket.shutdownOutput();
                    assertThat(leaving.isClosedByTheOtherEnd()).isTrue();
                }
            }
            try (Peer rude = Peer.dial(server.port())) {
                rude.send(Arrays.copyOf(message, 40));
                rude.socket.setSoLinger(true, 0); // a reset instead of an end
            }
            await(() -> log.linesWith("closed").size() == 7);
            assertThat(log.linesWith("ended inside a message")).hasSizeGreaterThanOrEqualTo(6);
            assertThat(healthy.move(NOBODY)).isEmpty();
            await(() -> server.connections() == 1);
        }
    }

    @Test
    void refusesConnectionsBeyondTheLimitAndTakesTheNextWhenOneEnds() throws Exception {
        NetOptions two = NetOptions.defaults().withConnections(2);
        try (LogCapture log = new LogCapture();
                GeometryServer server = new GeometryServer(InetAddress.getLoopbackAddress(), 0, two);
                Peer first = Peer.dial(server.port());
                Peer second = Peer.dial(server.port())) {
            assertThat(first.move(NOBODY)).isEmpty();
            assertThat(second.move(NOBODY)).isEmpty();
            try (Peer third = Peer.dial(server.port())) {
                assertThat(third.heardToTheEnd())
                        .isEqualTo("{\"type\":\"error\",\"message\":\"there must be at most 2 connections (got: more);"
                                + " close one, or dial again later\"}\n");
            }
            assertThat(log.linesWith("connections are refused")).hasSize(1);
            second.close();
            await(() -> server.connections() == 1);
            try (Peer next = Peer.dial(server.port())) {
                assertThat(next.move(NOBODY)).isEmpty();
            }
        }
    }

    public static void await(java.util.function.BooleanSupplier condition) throws InterruptedException {
        long deadline = System.nanoTime() + 10_000_000_000L;
        while (!condition.getAsBoolean()) {
            assertThat(System.nanoTime()).as("waited 10 s").isLessThan(deadline);
            Thread.sleep(5);
        }
    }

    private static byte[] header() {
        return new byte[] {(byte) 0xAC, (byte) 0xED, 0, 5};
    }

    /** 31 bytes that claim an array of doubles. */
    private static byte[] forgedArray(int length) throws IOException {
        byte[] whole = stream(new double[0]);
        byte[] forged = whole.clone();
        System.arraycopy(bytes(length), 0, forged, forged.length - 4, 4);
        return forged;
    }

    private static byte[] stream(Object object) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(object);
        }
        return bytes.toByteArray();
    }

    private static byte[] bytes(int... numbers) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        for (int number : numbers) {
            out.writeInt(number);
        }
        return bytes.toByteArray();
    }

    private static byte[] join(byte[] a, byte[] b) {
        byte[] both = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, both, a.length, b.length);
        return both;
    }
}
