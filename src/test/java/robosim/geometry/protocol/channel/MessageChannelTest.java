package robosim.geometry.protocol.channel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTest;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.MoveBundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Problem;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Samples;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.pace.MessagePace;

class MessageChannelTest {
    private static final String HELLO = "{\"type\":\"hello\",\"version\":1}\n";
    private static final String MOVES = "{\"type\":\"moves\",\"moves\":[]}\n";
    private static final byte[] HEADER = {(byte) 0xAC, (byte) 0xED, 0, 5};
    private static final Reply NONE_MADE = new Reply(new MoveBundle(List.of()), List.of(Problem.of(0, "a \"b\"")));

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    private MessageChannel channel(InputStream in, PeerAdmission gate) {
        return new MessageChannel(in, out, MessageTranslator.RECORDS, MessagePace.NONE, gate);
    }

    private MessageChannel channel(String text) {
        return channel(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PeerAdmission.OPEN);
    }

    private List<String> lines() {
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }

    /** Silent at first, as told by the pace of a stream with a clock. */
    private static InputStream late(byte[] bytes) {
        return new InputStream() {
            private final InputStream in = new ByteArrayInputStream(bytes);
            private boolean silent = true;

            @Override
            public int read() throws IOException {
                byte[] one = new byte[1];
                return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
            }

            @Override
            public int read(byte[] into, int at, int length) throws IOException {
                if (silent) {
                    silent = false;
                    throw new InterruptedIOException();
                }
                return in.read(into, at, Math.min(length, 1));
            }
        };
    }

    @Test
    void aJavaPeerIsAnsweredInJava() throws IOException {
        byte[] bytes = MessageTest.write(Samples.everyBundle().toArray(Bundle[]::new));
        MessageChannel channel = channel(new ByteArrayInputStream(bytes), PeerAdmission.OPEN);
        assertThat(out.toByteArray()).as("before a word of the peer").isEmpty();
        assertThat(channel.encoding()).isNull();
        assertThatThrownBy(() -> channel.write(NONE_MADE)).isInstanceOf(IllegalStateException.class);
        for (Bundle bundle : Samples.everyBundle()) {
            assertThat(channel.read()).isEqualTo(bundle);
            assertThat(channel.messageBytes()).isPositive();
        }
        assertThat(channel.encoding()).isEqualTo(MessageChannel.Encoding.JAVA);
        assertThat(out.toByteArray()).containsExactly(HEADER);
        channel.write(NONE_MADE);
        channel.refuse("there is no word for this in Java");
        assertThat(channel.read()).isNull();
        assertThat(MessageTest.readAll(out.toByteArray())).containsExactly(NONE_MADE.bundle());
    }

    @Test
    void aJsonPeerIsAnsweredInJson() throws IOException {
        MessageChannel channel = channel(HELLO + "{\"type\":\"ping\"}\n{\"id\":\"\u00e9\\\"\",\"type\":\"ping\"}\r\n"
                + "{\"type\":\"ping\",\"id\":-9007199254740991}\n" + MOVES);
        assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
        assertThat(channel.encoding()).isEqualTo(MessageChannel.Encoding.JSON);
        assertThat(channel.messageBytes()).isEqualTo(MOVES.length() - 1);
        channel.write(NONE_MADE);
        assertThat(channel.read()).isNull();
        assertThat(lines())
                .hasSize(5)
                .endsWith(
                        "{\"type\":\"pong\"}",
                        "{\"type\":\"pong\",\"id\":\"\u00e9\\\"\"}",
                        "{\"type\":\"pong\",\"id\":-9007199254740991}",
                        "{\"type\":\"moves\",\"moves\":[],\"refused\":[{\"index\":0,\"reason\":\"a \\\"b\\\"\"}]}");
        assertThat(lines().get(0))
                .startsWith("{\"type\":\"hello\",\"version\":1,\"module\":\"robosim-geometry ")
                .contains("\"messageBytes\":67108864");
    }

    /** Where nothing is delayed, each write may be a packet. */
    @Test
    void anAnswerInJsonIsOneWrite() throws IOException {
        int[] writes = new int[1];
        OutputStream counting = new OutputStream() {
            @Override
            public void write(int single) {
                writes[0]++;
            }

            @Override
            public void write(byte[] bytes, int at, int length) {
                writes[0]++;
            }
        };
        InputStream in = new ByteArrayInputStream((HELLO + MOVES).getBytes(StandardCharsets.UTF_8));
        MessageChannel channel =
                new MessageChannel(in, counting, MessageTranslator.RECORDS, MessagePace.NONE, PeerAdmission.OPEN);
        channel.read();
        assertThat(writes[0]).as("for the hello").isEqualTo(1);
        channel.write(NONE_MADE);
        assertThat(writes[0]).as("for hello and answer").isEqualTo(2);
    }

    @Test
    void whoIsSilentGetsTheHeaderOfJava() throws IOException {
        byte[] bytes = MessageTest.write(new MoveBundle(List.of()));
        MessageChannel channel = channel(late(bytes), PeerAdmission.OPEN);
        assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
        channel.write(NONE_MADE);
        assertThat(MessageTest.readAll(out.toByteArray())).containsExactly(NONE_MADE.bundle());
    }

    @Test
    void aJsonPeerThatIsLateFindsTheHeaderOnALineOfItsOwn() throws IOException {
        MessageChannel channel = channel(late((HELLO + MOVES).getBytes(StandardCharsets.UTF_8)), PeerAdmission.OPEN);
        assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
        channel.write(NONE_MADE);
        byte[] got = out.toByteArray();
        assertThat(got).startsWith(0xAC, 0xED, 0, 5, '\n', '{');
        assertThat(new String(got, 5, got.length - 5, StandardCharsets.UTF_8).lines())
                .hasSize(2)
                .allMatch(line -> line.startsWith("{") && line.endsWith("}"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"GET / HTTP/1.1", "\n{}", " {}", "\ufeff{}", "[1]", "\u0000"})
    void anythingElseIsRefused(String text) {
        assertThatThrownBy(() -> channel(text).read())
                .isInstanceOf(ProtocolException.class)
                .hasMessageContaining("AC ED 00 05")
                .hasMessageContaining("JSON lines");
        assertThat(out.toString(StandardCharsets.UTF_8))
                .startsWith("{\"type\":\"error\",")
                .endsWith("}\n");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{\"type\":\"moves\",\"moves\":[]} | line 1, the first message must be a hello",
                "{\"version\":1} | line 1, the message: must have the field \"type\"",
                "{\"type\":\"hello\"} | line 1, the message: must have the field \"version\"",
                "{\"type\":\"hello\",\"version\":2} | line 1, the message: version must be 1",
                "{\"type\":\"hello\",\"version\":\"1\"} | line 1, the message: must be a number",
                "{\"type\":\"hello\",\"version\":1}~ | line 2, a line must contain a message (got: a blank line)",
                "{\"type\":\"hello\",\"version\":1}~{\"type\":\"moves\",\"moves\":[NaN]} | line 2, at /moves/0: must be JSON",
                "{\"type\":\"hello\",\"version\":1}~{\"type\":\"moves\",\"moves\":[]}}~ | line 2, "
            })
    void aJsonPeerIsToldWhy(String text, String reason) {
        MessageChannel channel = channel(text.replace('~', '\n') + "\n" + MOVES);
        assertThatThrownBy(channel::read)
                .isInstanceOf(ProtocolException.class)
                .hasMessageStartingWith(reason)
                .satisfies(e -> assertThat(lines().get(lines().size() - 1))
                        .isEqualTo("{\"type\":\"error\",\"message\":\""
                                + e.getMessage().replace("\\", "\\\\").replace("\"", "\\\"") + "\"}"));
        assertThat(lines().stream().filter(line -> line.contains("error"))).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{\"type\":\"hello\",\"version\":1,\"id\":1} | 1 | a hello must come once",
                "{\"id\":\"x\",\"type\":\"pong\"} | \"x\" | a request's type must be",
                "{\"id\":7} | 7 | the message: must have the field \"type\"",
                "{\"type\":7,\"id\":8} | 8 | at /type: must be a string",
                "{\"type\":\"ping\",\"id\":1.5} |  | at /id: must be a whole number",
                "{\"type\":\"ping\",\"id\":9007199254740992} |  | at /id: must be",
                "{\"type\":\"ping\",\"id\":null} |  | at /id: an id must be a text or a whole number; leave it out",
                "{\"type\":\"ping\",\"id\":1,\"id\":2} | 2 | at /id: a field must occur only once",
                "{\"type\":\"moves\",\"moves\":[{\"id\":3,\"x\":[{\"id\":4}]}],\"id\":5} | 5 | at /moves/0/id: a field must be",
                "{\"type\":\"moves\",\"moves\":{},\"id\":[6]} |  | at /moves: must be a list",
                "[{\"id\":7}] |  | the message: must be an object",
                "{\"type\":\"sonars\",\"requests\":[{\"objectName\":\"r\",\"xOffset\":0,\"zOffset\":0}],\"id\":-1} | -1 | at"
                        + " /requests/0: xOffset and zOffset must not both be zero",
            })
    void aWrongRequestIsAnsweredAndTheNextOneIsRead(String text, @Nullable String id, String reason)
            throws IOException {
        // The second time the line is longer than the buffer, and read as it comes.
        for (String line : List.of(text, text.replaceFirst(".$", " ".repeat(40_000) + "$0"))) {
            out.reset();
            MessageChannel channel = channel(HELLO + line + "\n" + MOVES);
            List<String> wrong = new ArrayList<>();
            channel.onWrongRequest(wrong::add);
            assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
            channel.write(NONE_MADE);
            assertThat(wrong).hasSize(1).allMatch(each -> each.startsWith("line 2, " + reason));
            assertThat(lines()).hasSize(3);
            assertThat(lines().get(1))
                    .startsWith("{\"type\":\"error\"," + (id == null ? "" : "\"id\":" + id + ",")
                            + "\"continues\":true,\"message\":\"line 2, ");
            assertThat(lines().get(2)).startsWith("{\"type\":\"moves\",\"moves\":[]");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\":\"moves\",\"moves\":{},\"id\":1",
                "{\"type\":\"moves\",\"moves\":{},\"id\":NaN}",
                "{\"type\":\"moves\",\"moves\":{}} {}",
                "{\"type\":\"pong\",\"x\":[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[0]",
            })
    void ofAWrongRequestTheRestMustBeJsonToo(String line) {
        for (String text : List.of(line, line + " ".repeat(40_000) + "~")) {
            assertThatThrownBy(() -> channel(HELLO + text + "\n" + MOVES).read())
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageStartingWith("line 2, ")
                    .matches(e -> !((ProtocolException) e).isAboutRequest());
        }
    }

    @Test
    void anAnswerRepeatsTheIdOfItsRequest() throws IOException {
        MessageChannel channel = channel(HELLO
                + "{\"id\":1,\"type\":\"init\",\"objects\":[],\"answer\":true}\n"
                + "{\"type\":\"moves\",\"moves\":[],\"id\":\"zwei\"}\n" + MOVES
                + "{\"id\":4,\"type\":\"init\",\"objects\":[],\"answer\":true}\n" + MOVES);
        channel.read();
        assertThat(channel.read()).isEqualTo(InitBundle.Answered.QUESTION);
        channel.write(NONE_MADE);
        channel.read();
        channel.write(NONE_MADE);
        channel.read();
        channel.write(NONE_MADE);
        channel.read();
        assertThat(channel.answerError("too \"many\"")).isTrue(); // of the init, so that its question is gone
        assertThat(channel.read()).isEqualTo(new MoveBundle(List.of()));
        assertThat(lines().stream().skip(1).map(line -> line.replaceFirst(",\"moves\".*", "")))
                .containsExactly(
                        "{\"type\":\"moves\",\"id\":1",
                        "{\"type\":\"moves\",\"id\":\"zwei\"",
                        "{\"type\":\"moves\"",
                        "{\"type\":\"error\",\"id\":4,\"continues\":true,\"message\":\"too \\\"many\\\"\"}");
    }

    @Test
    void aLineWithoutItsEndIsNoMessage() {
        assertThatThrownBy(() -> channel(HELLO + MOVES.trim()).read())
                .hasMessageContaining("line 2, the stream ended inside a line, after 27 bytes of it");
    }

    @Test
    void bytesThatAreNoTextAreRefused() {
        byte[][] bad = {
            {(byte) 0xC0, (byte) 0x80}, {(byte) 0xED, (byte) 0xA0, (byte) 0xBD}, {(byte) 0xFF}, {(byte) 0xE4}
        };
        for (byte[] some : bad) {
            ByteArrayOutputStream text = new ByteArrayOutputStream();
            text.writeBytes((HELLO + "{\"type\":\"ping\",\"id\":\"").getBytes(StandardCharsets.UTF_8));
            text.writeBytes(some);
            text.writeBytes("\"}\n".getBytes(StandardCharsets.UTF_8));
            assertThatThrownBy(() -> channel(new ByteArrayInputStream(text.toByteArray()), PeerAdmission.OPEN)
                            .read())
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageContaining("line 2, a line must be UTF-8 (got: other bytes at byte 22)");
        }
    }

    @Test
    void aLineHasAnEndAndAHelloHasItSooner() {
        String longHello =
                "{\"type\":\"hello\",\"version\":1,\"secret\":\"" + "x".repeat(MessageLimits.MAX_HELLO_BYTES) + "\"}\n";
        assertThatThrownBy(() -> channel(longHello).read())
                .hasMessageContaining("line 1, a line must have at most 8192 bytes");
        InputStream spaces = new InputStream() {
            @Override
            public int read() {
                return ' ';
            }

            @Override
            public int read(byte[] bytes, int from, int length) {
                Arrays.fill(bytes, from, from + length, (byte) ' ');
                return length;
            }
        };
        InputStream endless = new SequenceInputStream(
                new ByteArrayInputStream((HELLO + "{").getBytes(StandardCharsets.UTF_8)), spaces);
        assertThatThrownBy(() -> channel(endless, PeerAdmission.OPEN).read())
                .hasMessageContaining("line 2, a line must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes");
    }

    @Test
    void longAndShortLinesAlternate() throws IOException {
        StringBuilder text = new StringBuilder(HELLO);
        List<Bundle> sent = new ArrayList<>();
        for (int k = 0; k < 40; k++) {
            MoveRequest move = new MoveRequest("robot " + k, k, 0, 0, 0, 0);
            sent.add(new MoveBundle(java.util.Collections.nCopies(k % 3 == 0 ? 3000 : k % 7, move)));
            text.append(JsonLines.write(sent.get(k))).append('\n');
        }
        MessageChannel channel = channel(text.toString());
        for (Bundle bundle : sent) {
            assertThat(channel.read()).isEqualTo(bundle);
        }
        assertThat(channel.read()).isNull();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\":\"hello\",\"version\":1,\"secret\":\"hush hush\"}",
                "{\"type\":\"hello\",\"version\":1,\"secret\":\"hush hush\",\"hush hush\":1}",
                "{\"type\":\"hello\",\"version\":1,\"secret\":hush hush}",
                "{\"type\":\"hello\",\"version\":1,\"secret\":\"hush hush}",
                "{\"type\":\"hush hush\",\"version\":1}",
                "{\"hush hush\":{\"type\":1}}",
                "{\"type\":\"hello\",\"version\":1,\"secret\":\"hush hush\"} hush"
            })
    void aSecretIsRepeatedNowhere(String hello) {
        MessageChannel channel =
                channel(new ByteArrayInputStream((hello + "\n").getBytes(StandardCharsets.UTF_8)), secret -> false);
        assertThatThrownBy(channel::read).isInstanceOf(ProtocolException.class).satisfies(e -> {
            for (Throwable cause = e; cause != null; cause = cause.getCause()) {
                assertThat(cause.toString()).doesNotContain("hush");
            }
        });
        assertThat(lines()).singleElement().asString().contains("\"error\"").doesNotContain("hush");
    }

    @Test
    void theGateIsAskedOnceAndNothingElseIsReadBeforeIt() throws IOException {
        List<String> told = new ArrayList<>();
        PeerAdmission gate = secret -> told.add(String.valueOf(secret));
        String hello = HELLO.replace("1}", "1,\"secret\":\"\\u0061b\"}");
        MessageChannel channel =
                channel(new ByteArrayInputStream((hello + MOVES + MOVES).getBytes(StandardCharsets.UTF_8)), gate);
        assertThat(channel.read()).isNotNull();
        assertThat(channel.read()).isNotNull();
        assertThat(told).containsExactly("ab");
        MessageChannel java = channel(new ByteArrayInputStream(MessageTest.write(new MoveBundle(List.of()))), gate);
        assertThat(java.read()).isNotNull();
        assertThat(told).containsExactly("ab", "null");
        // What follows a refused hello is not looked at, nor is a Java peer's first object.
        out.reset();
        MessageChannel refused = channel(
                new ByteArrayInputStream((HELLO + "rubbish\n").getBytes(StandardCharsets.UTF_8)), secret -> false);
        assertThatThrownBy(refused::read).hasMessageContaining("a hello must have the field \"secret\" here");
        assertThat(lines()).hasSize(1);
        InputStream header = new ByteArrayInputStream(new byte[] {(byte) 0xAC});
        assertThatThrownBy(() -> channel(header, secret -> false).read()).hasMessageContaining("must send a secret");
    }

    @Test
    void aPeerThatIsGoneNeedNotBeTold() {
        OutputStream broken = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("gone");
            }
        };
        MessageChannel channel = new MessageChannel(
                new ByteArrayInputStream("{}\n".getBytes(StandardCharsets.UTF_8)),
                broken,
                MessageTranslator.RECORDS,
                MessagePace.NONE,
                PeerAdmission.OPEN);
        assertThatThrownBy(channel::read).hasMessageContaining("must have the field \"type\"");
        channel.refuse("again");
    }

    /** Who embeds the module without Jackson does not notice; a JSON peer is told what is missing. */
    @Test
    void withoutJacksonJavaIsSpokenAndJsonIsRefused() throws Exception {
        URL classes = MessageChannel.class.getProtectionDomain().getCodeSource().getLocation();
        try (URLClassLoader bare = new URLClassLoader(new URL[] {classes}, ClassLoader.getPlatformClassLoader())) {
            Object bundle = read(bare, MessageTest.write(new MoveBundle(List.of())));
            assertThat(bundle).hasToString("MoveBundle[moves=[]]");
            out.reset();
            for (int k = 0; k < 2; k++) {
                assertThatThrownBy(() -> read(bare, HELLO.getBytes(StandardCharsets.UTF_8)))
                        .isInstanceOf(InvocationTargetException.class)
                        .cause()
                        .hasMessageContaining("com.fasterxml.jackson.core:jackson-core");
            }
            assertThat(lines()).hasSize(2).allMatch(line -> line.startsWith("{\"type\":\"error\",\"message\":\"JSON"));
        }
    }

    private Object read(ClassLoader loader, byte[] bytes) throws ReflectiveOperationException {
        String home = "robosim.geometry.protocol.";
        Class<?> channel = loader.loadClass(home + "channel.MessageChannel");
        Class<?> translator = loader.loadClass(home + "MessageTranslator");
        Class<?> pace = loader.loadClass(home + "pace.MessagePace");
        Class<?> gate = loader.loadClass(home + "json.PeerAdmission");
        Object made = channel.getConstructor(InputStream.class, OutputStream.class, translator, pace, gate)
                .newInstance(
                        new ByteArrayInputStream(bytes),
                        out,
                        translator.getField("RECORDS").get(null),
                        pace.getField("NONE").get(null),
                        gate.getField("OPEN").get(null));
        return channel.getMethod("read").invoke(made);
    }

    /** As where the peer is killed: its system resets the connection. */
    @Test
    void aConnectionThatFailsIsNoBadMessage() throws IOException {
        ByteArrayOutputStream sent = new ByteArrayOutputStream();
        MessageWriter writer = new MessageWriter(sent);
        writer.write(new MoveBundle(List.of()));
        int first = sent.size();
        writer.write(new MoveBundle(List.of()));
        for (int cut : new int[] {first, first + 1, first + 7, sent.size() - 3}) {
            InputStream in = new java.io.FilterInputStream(new ByteArrayInputStream(sent.toByteArray(), 0, cut)) {
                @Override
                public int read(byte[] into, int at, int length) throws IOException {
                    int got = super.read(into, at, length);
                    if (got < 0) {
                        throw new java.net.SocketException("Connection reset");
                    }
                    return got;
                }
            };
            MessageReader reader = new MessageReader(in);
            assertThat(reader.read()).isEqualTo(new MoveBundle(List.of()));
            String place = cut == first ? "between two messages" : "bytes of a message";
            assertThatThrownBy(reader::read)
                    .isInstanceOf(ProtocolException.class)
                    .hasMessageStartingWith("the connection failed ")
                    .hasMessageEndingWith(place + ": Connection reset");
        }
    }

    /** Slightly too large, the message can still be read to its end; far too large, it cannot. */
    @Test
    void aFileThatIsTooLargeIsRefusedByItsOwnLimit() throws IOException {
        String reason = "line 2, at /files/a: must have at most 25165824 bytes in base64 (got: more)";
        assertThat(channel(load((24 << 20) + 3)).read()).isNull();
        assertThat(lines().get(1)).contains(reason, "\"continues\":true");
        MessageChannel channel = channel(load(26 << 20));
        assertThatThrownBy(channel::read).hasMessageContaining(reason);
    }

    private static String load(int bytes) {
        return HELLO + "{\"type\":\"load\",\"file\":\"a\",\"files\":{\"a\":\"" + "AAAA".repeat(bytes / 3) + "\"}}\n";
    }
}
