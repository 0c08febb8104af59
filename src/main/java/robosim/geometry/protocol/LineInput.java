package robosim.geometry.protocol;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;

/** Lines of UTF-8, each bounded before it is believed; the buffer grows with a line and shrinks after it. */
final class LineInput {
    private static final int BUFFER = 8192;
    private static final int LEAST = ' ';

    private final InputStream source;
    private final MessagePace pace;
    private byte[] buffer = new byte[BUFFER];

    /** The line, then what has been read beyond it. */
    private int start;

    private int length;
    private int next;
    private int end;
    private int number;

    LineInput(InputStream source, MessagePace pace) {
        this.source = source;
        this.pace = pace;
    }

    /**
     * Waits for the next line.
     *
     * @return whether there is one; false at the end of the stream, between two lines
     * @throws ProtocolException where it has more bytes, is no text or lacks its end
     */
    boolean await(int mostBytes) throws IOException {
        pace.idle();
        length = 0;
        if (next == end && !fill()) {
            return false;
        }
        pace.begun();
        number++;
        int seen = 0;
        while (true) {
            while (next + seen < end && seen <= mostBytes && buffer[next + seen] != '\n') {
                seen++;
            }
            length = seen;
            if (seen > mostBytes) {
                throw new ProtocolException("a line must have at most " + mostBytes + " bytes (got: more)");
            }
            if (next + seen < end) {
                break;
            }
            if (!fill()) {
                throw new ProtocolException("the stream ended inside a line, after " + seen
                        + " bytes of it; each message ends with a line feed");
            }
        }
        start = next;
        next += seen + 1;
        checkText(buffer, start, length);
        return true;
    }

    private boolean fill() throws IOException {
        if (next == end) {
            next = 0;
            end = 0;
            if (buffer.length > 8 * BUFFER) {
                buffer = new byte[BUFFER];
            }
        } else if (end == buffer.length) {
            int left = end - next;
            byte[] roomy = next >= buffer.length / 2
                    ? buffer
                    : new byte[Math.min(2 * buffer.length, Math.max(left, Limits.MAX_MESSAGE_BYTES) + BUFFER)];
            System.arraycopy(buffer, next, roomy, 0, left);
            buffer = roomy;
            next = 0;
            end = left;
        }
        int got = source.read(buffer, end, buffer.length - end);
        end += Math.max(got, 0);
        return got > 0;
    }

    /** Jackson would take other encodings than UTF-8 for JSON, all of which hold zeros, and overlong forms. */
    static void checkText(byte[] bytes, int start, int length) throws ProtocolException {
        if (length >= 3
                && bytes[start] == (byte) 0xEF
                && bytes[start + 1] == (byte) 0xBB
                && bytes[start + 2] == (byte) 0xBF) {
            throw new ProtocolException("a line must not begin with a byte order mark (got: one)");
        }
        boolean plain = true;
        for (int k = start; k < start + length; k++) {
            byte b = bytes[k];
            if (b >= 0 && b < LEAST && b != '\t' && b != '\r') {
                throw new ProtocolException(String.format(
                        Locale.ROOT,
                        "a control character must be escaped, as in \\u0007 (got: %02X in byte %d)",
                        b,
                        k - start + 1));
            }
            plain &= b >= 0;
        }
        if (!plain) {
            checkEncoding(ByteBuffer.wrap(bytes, start, length));
        }
    }

    private static void checkEncoding(ByteBuffer bytes) throws ProtocolException {
        int start = bytes.position();
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder(); // reports what is malformed
        CharBuffer chars = CharBuffer.allocate(BUFFER);
        CoderResult result = decoder.decode(bytes, chars, true);
        while (result.isOverflow()) {
            chars.clear();
            result = decoder.decode(bytes, chars, true);
        }
        if (result.isError()) {
            throw new ProtocolException(
                    "a line must be UTF-8 (got: other bytes at byte " + (bytes.position() - start + 1) + ")");
        }
    }

    /** The buffer in which the line is, to be read at once. */
    byte[] buffer() {
        return buffer;
    }

    /** Where in the buffer the line begins. */
    int start() {
        return start;
    }

    /** Bytes of the line, or of the part of it that has come; without its line feed. */
    int length() {
        return length;
    }

    /** Of this line, from 1. */
    int number() {
        return number;
    }

    /** Forgets what the line held, where that must not stay in memory. */
    void wipe() {
        Arrays.fill(buffer, start, start + length, (byte) 0);
    }
}
