package robosim.geometry.protocol.channel;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.ObjectStreamConstants;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MessageReader;
import robosim.geometry.protocol.MessageTranslator;
import robosim.geometry.protocol.MessageWriter;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.json.JsonCodec;
import robosim.geometry.protocol.json.JsonLines;
import robosim.geometry.protocol.json.PeerAdmission;
import robosim.geometry.protocol.json.WorldLoader;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * Both directions of one connection, in the encoding that the peer chooses by its first byte: {@code AC} of Java
 * serialization or <code>&#123;</code> of {@linkplain JsonLines JSON lines}.
 *
 * <p>A Java peer that opens its input first waits for our stream header before it sends a byte. So the header is
 * written when the peer's first byte is that of Java serialization, or when nothing has come for as long as {@link
 * MessagePace#opening} waits. A JSON peer that begins later than that is served too: the first line that it receives is
 * then the four bytes of that header, which it must skip.
 *
 * <p>{@link #read} itself answers a JSON peer's hello and pings, and with an error each request that is JSON but wrong: a
 * field that does not exist, a value out of its range. One thread may read and one may write, the same or another;
 * messages are written without interleaving. What is written answers the last message that was read, and repeats its
 * id. After an exception nothing more can be read.
 */
public final class MessageChannel {
    /** The encoding of a peer's messages. */
    public enum Encoding {
        /** Java serialization. */
        JAVA,
        /** JSON lines. */
        JSON
    }

    /** The first byte of a handshake: RFC 8446, 5.1. */
    private static final int TLS_HANDSHAKE = 0x16;

    private static final int JAVA = ObjectStreamConstants.STREAM_MAGIC >> 8 & 0xff;

    private final InputStream in;
    private final OutputStream out;
    private final MessageTranslator translator;
    private final MessagePace pace;
    private final PeerAdmission gate;

    /** The writer, if it was created, and our stream header sent, before the peer had sent anything. */
    private @Nullable MessageWriter early;

    private WorldLoader worlds = WorldLoader.NONE;
    private Consumer<String> wrongRequests = reason -> {};

    private volatile @Nullable Codec speech;
    private volatile @Nullable Encoding encoding;

    /** Reads and writes nothing yet. */
    public MessageChannel(
            InputStream in, OutputStream out, MessageTranslator translator, MessagePace pace, PeerAdmission gate) {
        this.in = Checks.present("in", in);
        this.out = Checks.present("out", out);
        this.translator = Checks.present("translator", translator);
        this.pace = Checks.present("pace", pace);
        this.gate = Checks.present("gate", gate);
    }

    /** Sets what reads world files for a JSON peer; before anything is read. */
    public void loadBy(WorldLoader loader) {
        worlds = Checks.present("loader", loader);
    }

    /** Tells an observer why requests are wrong that {@link #read} answers with an error. */
    public void onWrongRequest(Consumer<String> observer) {
        wrongRequests = Checks.present("observer", observer);
    }

    /**
     * Answers the last request that was read with an error, after which the conversation goes on.
     *
     * @return whether the peer's encoding has such an answer; Java serialization has none, and nothing is written
     */
    public boolean answerError(String reason) throws IOException {
        Checks.present("reason", reason);
        Codec spoken = speech;
        return spoken != null && spoken.refuse(reason);
    }

    /**
     * Waits for the next bundle.
     *
     * @return null if the stream ends between two messages
     * @throws ProtocolException if the bytes are not a message, the peer is not admitted, or the stream fails or ends
     *     inside a message. A JSON peer has been told why
     */
    public @Nullable Bundle read() throws ProtocolException {
        try {
            Codec spoken = speech == null ? open() : speech;
            return spoken == null ? null : spoken.read();
        } catch (ProtocolException e) {
            refuse(String.valueOf(e.getMessage()));
            throw e;
        }
    }

    /**
     * Writes an answer in the peer's encoding: one complete message, flushed.
     *
     * @throws IllegalStateException if nothing has been read, so that the encoding is not known yet
     */
    public void write(Reply reply) throws IOException {
        Checks.present("reply", reply);
        Codec spoken = speech;
        if (spoken == null) {
            throw new IllegalStateException("a request must be read before it is answered");
        }
        spoken.write(reply);
    }

    /**
     * Tells the peer why its connection is about to be closed, if its encoding has a message for that. Does so only
     * once, and throws nothing if the peer cannot be reached.
     */
    public void refuse(String reason) {
        Checks.present("reason", reason);
        if (encoding != Encoding.JSON) {
            return;
        }
        try {
            synchronized (out) {
                out.write(errorLine(reason));
                out.flush();
            }
        } catch (IOException e) {
            encoding = null; // the peer is gone
        }
    }

    /** The line that a JSON peer gets before its connection is closed, with its line feed. Does not need Jackson. */
    public static byte[] errorLine(String reason) {
        String words = Text.line(Checks.present("reason", reason))
                .replace("\\", "\\\\")
                .replace("\"", "\\\"");
        return ("{\"type\":\"error\",\"message\":\"" + words + "\"}\n").getBytes(StandardCharsets.UTF_8);
    }

    /** The peer's encoding; null until it has sent something. */
    public @Nullable Encoding encoding() {
        return encoding;
    }

    /**
     * The number of the message that is awaited or was read last, as the peer counts them, from 1: of JSON lines that of the
     * line. May be called by any thread.
     */
    public long messageNumber() {
        Codec spoken = speech;
        return spoken == null ? 1 : spoken.messageNumber();
    }

    /** The id of the last message that was read, a String or a Long; null for a message without an id. */
    public @Nullable Object id() {
        Codec spoken = speech;
        return spoken == null ? null : spoken.id();
    }

    /** The size in bytes of the last message read; 0 before the first. */
    public int messageBytes() {
        Codec spoken = speech;
        return spoken == null ? 0 : spoken.messageBytes();
    }

    private @Nullable Codec open() throws ProtocolException {
        try {
            int first = first();
            if (first < 0) {
                return null;
            }
            InputStream whole = new SequenceInputStream(new ByteArrayInputStream(new byte[] {(byte) first}), in);
            Codec opened = switch (first) {
                case JAVA -> java(whole);
                case '{' -> json(whole);
                default -> throw unknown(first);
            };
            speech = opened;
            return opened;
        } catch (ProtocolException e) {
            throw e;
        } catch (IOException e) {
            throw new ProtocolException(
                    "the connection failed before its first message: " + Text.line(e.toString()), e);
        }
    }

    /** Whoever sends anything but Java can read a line, too. */
    private ProtocolException unknown(int first) {
        encoding = Encoding.JSON;
        return new ProtocolException(
                first == TLS_HANDSHAKE
                        ? "this port must be spoken to without TLS, as the module was given no keys (got: the"
                                + " handshake of TLS); dial without it, or start the module with --key-store and"
                                + " --trust-store"
                        : "a stream must begin with AC ED 00 05, Java serialization, or with {, JSON lines"
                                + " (got: %02X)".formatted(first));
    }

    private int first() throws IOException {
        pace.opening();
        try {
            return in.read();
        } catch (InterruptedIOException silence) {
            early = new MessageWriter(out, translator);
            pace.idle();
            return in.read();
        }
    }

    private Codec java(InputStream whole) throws IOException {
        encoding = Encoding.JAVA;
        if (!gate.admits(null)) {
            throw new ProtocolException("a peer must send a secret, as JSON lines can and Java serialization cannot"
                    + " (got: Java serialization); use TLS with a certificate, or let the module dial");
        }
        MessageWriter writer = early == null ? new MessageWriter(out, translator) : early;
        MessageReader reader = new MessageReader(whole, translator, pace);
        return new Codec() {
            @Override
            public @Nullable Bundle read() throws ProtocolException {
                return reader.read();
            }

            @Override
            public void write(Reply reply) throws IOException {
                Checks.present("reply", reply);
                writer.write(reply.bundle());
            }

            @Override
            public boolean refuse(String reason) {
                return false;
            }

            @Override
            public long messageNumber() {
                return reader.messageNumber();
            }

            @Override
            public int messageBytes() {
                return reader.messageBytes();
            }
        };
    }

    private Codec json(InputStream whole) throws IOException {
        encoding = Encoding.JSON;
        if (early != null) {
            out.write('\n'); // makes the header a separate line
            out.flush();
        }
        try {
            return codec(JsonCodec.open(whole, out, pace, gate, worlds, reason -> wrongRequests.accept(reason)));
        } catch (LinkageError e) {
            throw new ProtocolException(
                    "JSON lines need Jackson: put com.fasterxml.jackson.core:jackson-core on the class path, or on the"
                            + " module path with --add-modules com.fasterxml.jackson.core (got: "
                            + Objects.requireNonNullElse(e.getMessage(), "no such class") + ")",
                    e);
        }
    }

    private static Codec codec(JsonCodec lines) {
        return new Codec() {
            @Override
            public @Nullable Bundle read() throws ProtocolException {
                return lines.read();
            }

            @Override
            public void write(Reply reply) throws IOException {
                lines.write(reply);
            }

            @Override
            public boolean refuse(String reason) throws IOException {
                lines.refuse(reason);
                return true;
            }

            @Override
            public @Nullable Object id() {
                return lines.id();
            }

            @Override
            public long messageNumber() {
                return lines.messageNumber();
            }

            @Override
            public int messageBytes() {
                return lines.messageBytes();
            }
        };
    }
}
