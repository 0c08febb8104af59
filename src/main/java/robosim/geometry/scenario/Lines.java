package robosim.geometry.scenario;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Limits;

/** The lines of a file, one in memory at a time; blank ones are passed over. A last line that breaks off is no line. */
final class Lines implements Closeable {
    private static final int BUFFER = 1 << 16;

    private final InputStream in;
    private final String source;
    private ByteArrayOutputStream line = new ByteArrayOutputStream();
    private long number;
    private long torn;

    Lines(InputStream in, String source) {
        this.in = new BufferedInputStream(in, BUFFER);
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

    /** Whether a line feed came. */
    private boolean fill() throws ScenarioException {
        line.reset();
        try {
            for (int b = in.read(); b >= 0; b = in.read()) {
                if (b == '\n') {
                    return true;
                }
                if (line.size() == Limits.MAX_MESSAGE_BYTES) {
                    throw refused("a line must have at most " + Limits.MAX_MESSAGE_BYTES + " bytes (got: more)", null);
                }
                line.write(b);
            }
            return false;
        } catch (ScenarioException e) {
            throw e;
        } catch (IOException e) {
            throw refused("the file could not be read: " + e, e);
        }
    }

    /** Whether an object begins and does not end: what is left of a line whose writer was killed, and of no other. */
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

    /** What is wrong with the line that was read last. */
    ScenarioException refused(String problem, @Nullable Throwable cause) {
        return new ScenarioException(source, number, problem, cause);
    }

    /** Of the line that was read last, from 1. */
    long number() {
        return number;
    }

    /** The number of the last line where that breaks off; 0 otherwise. */
    long torn() {
        return torn;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
