package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import robosim.geometry.exact.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.Limits;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Text;

/**
 * Messages as lines of JSON, in both directions: what an environment in any language writes and reads, and what a
 * scenario's file holds. {@code docs/protocol.schema.json} is their schema. Every double keeps its bits.
 *
 * <p>Reading is strict, and within the {@link Limits}. A line is without its line feed. Needs Jackson's core
 * ({@code com.fasterxml.jackson.core:jackson-core}) beside the module, which nothing else does.
 */
public final class JsonLines {
    /** Of the protocol, as a hello tells it. */
    public static final int VERSION = 1;

    /** This module and its version, as its hello tells it. */
    public static final String MODULE = "robosim-geometry 1.0.0-SNAPSHOT";

    private JsonLines() {}

    /**
     * An {@code init}, {@code moves} or {@code sonars} line.
     *
     * @throws IllegalArgumentException where it is a {@link DistanceBundle}, which is no request
     */
    public static String write(Bundle request) {
        Checks.present("request", request);
        return text(output -> output.write(request));
    }

    /** A {@code moves} line with what was refused, or a {@code distances} line. */
    public static String write(Reply reply) {
        Checks.present("reply", reply);
        return text(output -> output.write(reply));
    }

    /**
     * A request that an environment may send.
     *
     * @throws ProtocolException where the line is none; the message names the place
     */
    public static Bundle readRequest(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> {
            String type = JsonInput.typeOf(JsonInput.of(bytes, 0, bytes.length));
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return request(type, in);
            }
        });
    }

    /**
     * An answer that a module may send.
     *
     * @throws ProtocolException where the line is none; the message names the place
     */
    public static Reply readReply(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> {
            String type = JsonInput.typeOf(JsonInput.of(bytes, 0, bytes.length));
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return switch (type) {
                    case "moves" -> new JsonMessages(in).made();
                    case "distances" -> new JsonMessages(in).distances();
                    default ->
                        throw new ProtocolException(
                                "an answer's type must be moves or distances (got: " + Text.quoted(type) + ")");
                };
            }
        });
    }

    /**
     * The {@code type} of a line's object, whatever else that holds.
     *
     * @throws ProtocolException where the line is no object that has one
     */
    public static String typeOf(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> JsonInput.typeOf(JsonInput.of(bytes, 0, bytes.length)));
    }

    /**
     * Whether a line is an answer and no request: {@code distances}, or {@code moves} that tell what was refused.
     *
     * @throws ProtocolException where the line is no object that has a {@code type}
     */
    public static boolean isReply(String line) throws ProtocolException {
        String type = typeOf(line);
        if (!type.equals("moves")) {
            return type.equals("distances");
        }
        byte[] bytes = bytes(line);
        return guarded(() -> {
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return in.find("refused");
            }
        });
    }

    static Bundle request(String type, JsonInput in) throws IOException {
        JsonMessages messages = new JsonMessages(in);
        return switch (type) {
            case "init" -> messages.init();
            case "moves" -> messages.moves();
            case "sonars" -> messages.sonars();
            default ->
                throw new ProtocolException(
                        "a request's type must be init, moves or sonars (got: " + Text.quoted(type) + ")");
        };
    }

    static byte[] bytes(String line) throws ProtocolException {
        byte[] bytes;
        try {
            ByteBuffer encoded =
                    StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(Checks.present("line", line)));
            bytes = new byte[encoded.remaining()];
            encoded.get(bytes);
        } catch (CharacterCodingException e) {
            throw new ProtocolException("a line must have no half of a surrogate pair (got: one)", e);
        }
        if (bytes.length > Limits.MAX_MESSAGE_BYTES) {
            throw new ProtocolException(
                    "a line must have at most " + Limits.MAX_MESSAGE_BYTES + " bytes (got: " + bytes.length + ")");
        }
        LineInput.checkText(bytes, 0, bytes.length);
        return bytes;
    }

    /** Reads something. */
    @FunctionalInterface
    interface Reading<T> {
        T read() throws IOException;
    }

    /** Whatever goes wrong in reading is the peer's fault and has one type. */
    static <T> T guarded(Reading<T> reading) throws ProtocolException {
        try {
            return reading.read();
        } catch (ProtocolException e) {
            throw e;
        } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
            throw noMessage(e);
        }
    }

    /** Whatever goes wrong in reading a line that comes over a connection, but for the connection itself. */
    static <T> T guardedAsItComes(Reading<T> reading) throws IOException {
        try {
            return reading.read();
        } catch (CharacterCodingException e) {
            throw new ProtocolException("a line must be UTF-8 (got: other bytes)", e);
        } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
            throw noMessage(e);
        }
    }

    private static ProtocolException noMessage(Throwable e) {
        if (e instanceof OutOfMemoryError) {
            return ProtocolException.noMemory(e);
        }
        String text = e.getMessage();
        return new ProtocolException(
                "a line that is no message: " + e.getClass().getSimpleName()
                        + (text == null ? "" : ", " + Text.line(text)),
                e);
    }

    /** Writes something. */
    @FunctionalInterface
    interface Writing {
        void write(JsonOutput output) throws IOException;
    }

    private static String text(Writing writing) {
        StringWriter text = new StringWriter();
        try (JsonGenerator generator = JsonInput.FACTORY.createGenerator(text)) {
            writing.write(new JsonOutput(generator));
        } catch (IOException e) {
            throw new UncheckedIOException("a text cannot fail", e);
        }
        return wellFormed(text.toString());
    }

    /** A name of a Java peer may hold half a surrogate pair, which UTF-8 cannot; it is escaped, and no line is broken. */
    static String wellFormed(String text) {
        if (text.chars().noneMatch(c -> Character.isSurrogate((char) c))) {
            return text;
        }
        StringBuilder formed = new StringBuilder(text.length());
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            if (Character.isHighSurrogate(c) && k + 1 < text.length() && Character.isLowSurrogate(text.charAt(k + 1))) {
                formed.append(c).append(text.charAt(++k));
            } else if (Character.isSurrogate(c)) {
                formed.append(String.format("\\u%04x", (int) c));
            } else {
                formed.append(c);
            }
        }
        return formed.toString();
    }
}
