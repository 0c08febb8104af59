package robosim.geometry.protocol.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.InitBundle;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;

/**
 * Messages as lines of JSON, in both directions: for environments in any language, and for scenario files. {@code
 * docs/protocol.schema.json} is their schema. Every double keeps its bits.
 *
 * <p>Reading is strict, and within the {@link MessageLimits}. Lines are passed without their line feed. Requires Jackson's
 * core ({@code com.fasterxml.jackson.core:jackson-core}).
 */
public final class JsonLines {
    /** The version of the protocol, as given in a hello. */
    public static final int VERSION = 1;

    /** This module's name and version, as given in its hello. */
    public static final String MODULE = "robosim-geometry 1.0.0-rc.1";

    /** The types of requests that need no connection. */
    private static final Set<String> REQUESTS = Set.of("init", "moves", "sonars", "batch", "step");

    private JsonLines() {}

    /**
     * Writes an {@code init}, {@code moves}, {@code sonars}, {@code batch} or {@code step} line.
     *
     * @throws IllegalArgumentException if it {@linkplain Bundle#isAnswer is an answer}
     */
    public static String write(Bundle request) {
        Checks.present("request", request);
        return text(out -> JsonMessages.write(out, request));
    }

    /** Writes a {@code moves} line with the refusals, a {@code distances}, an {@code answers} or a {@code bodies} line. */
    public static String write(Reply reply) {
        Checks.present("reply", reply);
        return text(out -> JsonMessages.write(out, reply, null));
    }

    /**
     * Reads a request that has a bundle: an init, moves, sonars, a batch or a step. A load or a ping is a connection's to answer.
     *
     * @throws ProtocolException if the line is not a request; the message names the place
     */
    public static Bundle readRequest(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> {
            String type = JsonMessages.typeOf(JsonInput.of(bytes, 0, bytes.length));
            if (!REQUESTS.contains(type)) {
                throw new ProtocolException(
                        "a request's type must be init, moves, sonars, batch or step, where there is no connection"
                                + " that answers a hello, a load or a ping (got: " + Text.quoted(type) + ")");
            }
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                Bundle request = (Bundle) JsonMessages.request(type, in);
                if (request instanceof InitBundle.Answered) {
                    throw new ProtocolException("at /answer: must be left out here, where the question what became of"
                            + " an init is a line of its own, {\"type\":\"batch\",\"requests\":[{\"kind\":\"world\"}]}"
                            + " (got: true)");
                }
                return request;
            }
        });
    }

    /**
     * Reads an answer that a module may send.
     *
     * @throws ProtocolException if the line is not an answer; the message names the place
     */
    public static Reply readReply(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> {
            String type = JsonMessages.typeOf(JsonInput.of(bytes, 0, bytes.length));
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return JsonMessages.reply(type, in);
            }
        });
    }

    /**
     * The {@code type} of a line's object; its other fields are not checked.
     *
     * @throws ProtocolException if the line is not an object with a {@code type}
     */
    public static String typeOf(String line) throws ProtocolException {
        byte[] bytes = bytes(line);
        return guarded(() -> JsonMessages.typeOf(JsonInput.of(bytes, 0, bytes.length)));
    }

    /**
     * Whether a line is an answer rather than a request: {@code distances}, {@code answers}, {@code bodies}, or {@code moves} with refusals.
     *
     * @throws ProtocolException if the line is not an object with a {@code type}
     */
    public static boolean isReply(String line) throws ProtocolException {
        String type = typeOf(line);
        if (!type.equals("moves")) {
            return type.equals("distances") || type.equals("answers") || type.equals("bodies");
        }
        byte[] bytes = bytes(line);
        return guarded(() -> {
            try (JsonInput in = JsonInput.of(bytes, 0, bytes.length)) {
                return in.find("refused");
            }
        });
    }

    static byte[] bytes(String line) throws ProtocolException {
        byte[] bytes;
        try {
            ByteBuffer encoded =
                    StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(Checks.present("line", line)));
            bytes = new byte[encoded.remaining()];
            encoded.get(bytes);
        } catch (CharacterCodingException e) {
            throw new ProtocolException("a line must have no unpaired surrogate (got: one)", e);
        }
        if (bytes.length > MessageLimits.MAX_MESSAGE_BYTES) {
            throw new ProtocolException("a line must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes (got: "
                    + bytes.length + ")");
        }
        LineInput.checkText(bytes, 0, bytes.length);
        return bytes;
    }

    /** An operation that reads. */
    @FunctionalInterface
    interface Reading<T> {
        T read() throws IOException;
    }

    /** Reads; any failure is the peer's fault and becomes a ProtocolException. */
    static <T> T guarded(Reading<T> reading) throws ProtocolException {
        try {
            return reading.read();
        } catch (ProtocolException e) {
            throw e;
        } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
            throw noMessage(e);
        }
    }

    /** The same for a line that is read as it arrives; failures of the connection itself are passed on. */
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
                "the line is not a message: " + e.getClass().getSimpleName()
                        + (text == null ? "" : ", " + Text.line(text)),
                e);
    }

    /** An operation that writes. */
    @FunctionalInterface
    interface Writing {
        void write(JsonGenerator out) throws IOException;
    }

    private static String text(Writing writing) {
        StringWriter text = new StringWriter();
        try (JsonGenerator generator = JsonInput.FACTORY.createGenerator(text)) {
            writing.write(generator);
        } catch (IOException e) {
            throw new UncheckedIOException("writing to a string cannot fail", e);
        }
        return wellFormed(text.toString());
    }

    /** Escapes unpaired surrogates, which a Java peer's name may contain but UTF-8 cannot. */
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
