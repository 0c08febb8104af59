package robosim.geometry.scenario;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.scenario.recording.Checksums;

/** Reads the lines of a file, one in memory at a time; blank lines and an incomplete last line are skipped. */
final class Lines implements Closeable {
    private static final int BUFFER = 1 << 16;

    private final InputStream in;
    private final String source;
    private final byte[] buffer = new byte[BUFFER];
    private int from;
    private int to;
    private ByteArrayOutputStream line = new ByteArrayOutputStream();
    private long number;
    private long torn;

    Lines(InputStream in, String source) {
        this.in = in;
        this.source = source;
    }

    /** The next line without its line feed; null at the end. */
    @Nullable
    String next() throws ScenarioException {
        while (true) {
            number++;
            boolean whole = fill();
            byte[] bytes = line.toByteArray();
            if (line.size() > BUFFER) {
                line = new ByteArrayOutputStream();
            }
            if (!whole && bytes.length == 0) {
                return null;
            }
            if (!whole && breaksOff(bytes)) {
                torn = number;
                return null;
            }
            String text = text(bytes);
            if (!text.isBlank()) {
                return text;
            }
        }
    }

    /** Reads up to the next line feed; returns whether there was one. */
    private boolean fill() throws ScenarioException {
        line.reset();
        try {
            while (true) {
                if (from == to) {
                    from = 0;
                    to = Math.max(0, in.read(buffer));
                    if (to == 0) {
                        return false;
                    }
                }
                int end = from;
                while (end < to && buffer[end] != '\n') {
                    end++;
                }
                if (line.size() + (end - from) > MessageLimits.MAX_MESSAGE_BYTES + Checksums.LENGTH) {
                    throw refused(
                            "a line must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes (got: more)", null);
                }
                line.write(buffer, from, end - from);
                from = Math.min(end + 1, to);
                if (end < to) {
                    return true;
                }
            }
        } catch (ScenarioException e) {
            throw e;
        } catch (IOException e) {
            throw refused("the file could not be read: " + e, e);
        }
    }

    /** Whether an object begins but does not end, as in a line whose writer was killed and in no other. */
    private static boolean breaksOff(byte[] bytes) {
        int depth = 0;
        boolean quoted = false;
        for (int k = 0; k < bytes.length; k++) {
            byte b = bytes[k];
            if (quoted) {
                k += b == '\\' ? 1 : 0;
                quoted = b != '"';
            } else if (b == '"') {
                quoted = true;
            } else if (b == '{') {
                depth++;
            } else if (b == '}') {
                depth--;
            }
        }
        return quoted || depth > 0;
    }

    private String text(byte[] bytes) throws ScenarioException {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
        } catch (CharacterCodingException e) {
            throw refused("a line must be UTF-8 (got: other bytes)", e);
        }
    }

    /** An exception about the line that was read last. */
    ScenarioException refused(String problem, @Nullable Throwable cause) {
        return new ScenarioException(source, number, problem, cause);
    }

    /** The number of the line that was read last, from 1. */
    long number() {
        return number;
    }

    /** The number of the last line if it is incomplete; 0 otherwise. */
    long torn() {
        return torn;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
