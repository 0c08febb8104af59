package robosim.geometry.protocol.json;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import robosim.geometry.protocol.MessageLimits;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.pace.MessagePace;

/**
 * Reads lines of UTF-8, each of limited length. A line that fits into the buffer is read completely; of a longer one
 * only the beginning, and the rest as it arrives, so that long lines need not be in memory at once.
 */
final class LineInput {
    /** The size of the buffer: the largest line that is read completely; more than a hello may have. */
    static final int BUFFER = 2 * MessageLimits.MAX_HELLO_BYTES;

    private static final int LEAST = ' ';

    private final InputStream source;
    private final MessagePace pace;
    private final byte[] buffer = new byte[BUFFER];

    /** The part of the line in the buffer, then bytes read beyond it. */
    private int start;

    private int length;
    private int next;
    private int end;

    private int number;
    private int mostBytes;

    /** The number of bytes of the line that have been examined. */
    private int count;

    private boolean whole;

    LineInput(InputStream source, MessagePace pace) {
        this.source = source;
        this.pace = pace;
    }

    /**
     * Waits for the next line, or the beginning of a long one. The previous line must have been read to its end.
     *
     * @return whether there is one; false if the stream ends between two lines
     * @throws ProtocolException if it has more bytes than allowed, is not valid text or lacks its end
     */
    boolean await(int most) throws IOException {
        pace.idle();
        mostBytes = most;
        count = 0;
        whole = false;
        if (next == end && !fill()) {
            return false;
        }
        pace.begun();
        number++;
        if (next >= BUFFER / 2) { // moves the beginning of the line to the front to make room
            end -= next;
            System.arraycopy(buffer, next, buffer, 0, end);
            next = 0;
        }
        while (true) {
            int from = next + count;
            count(from);
            if (next + count < end) {
                whole = true;
                break;
            }
            if (end == BUFFER) {
                break;
            }
            if (!fill()) {
                throw endedInside();
            }
        }
        start = next;
        length = count;
        next += whole ? count + 1 : count;
        checkBeginning(buffer, start, length);
        checkControls(buffer, start, length, 0);
        if (whole) {
            checkEncoding(buffer, start, length);
        }
        return true;
    }

    /** Examines the line's bytes in the buffer from an index on. */
    private void count(int from) throws ProtocolException {
        int at = from;
        int last = (int) Math.min(end, (long) from + mostBytes - count + 1);
        while (at < last && buffer[at] != '\n') {
            at++;
        }
        count += at - from;
        if (count > mostBytes) {
            throw new ProtocolException("a line must have at most " + mostBytes + " bytes (got: more)");
        }
    }

    private ProtocolException endedInside() {
        return new ProtocolException(
                "the stream ended inside a line, after " + count + " bytes of it; each message ends with a line feed");
    }

    private boolean fill() throws IOException {
        if (next == end) {
            next = 0;
            end = 0;
        }
        int got = source.read(buffer, end, BUFFER - end);
        end += Math.max(got, 0);
        return got > 0;
    }

    /** Whether all of the line is in the buffer. */
    boolean isWhole() {
        return whole;
    }

    /**
     * The characters of a line that is not completely in the buffer; must be read to the end before the next line is
     * awaited. Reading throws the same exceptions as {@link #await}.
     */
    Reader characters() {
        InputStream rest = new Rest();
        return new InputStreamReader(rest, StandardCharsets.UTF_8.newDecoder()); // reports what is malformed
    }

    /** All bytes of a line that is not completely in the buffer; only if {@link #characters} was not called. */
    byte[] gather() throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream(4 * BUFFER);
        new Rest().transferTo(all);
        byte[] bytes = all.toByteArray();
        checkEncoding(bytes, 0, bytes.length);
        return bytes;
    }

    /** The bytes of a line that is longer than the buffer: the part in the buffer, then the rest. */
    private final class Rest extends InputStream {
        private ByteArrayInputStream part = new ByteArrayInputStream(buffer, start, length);
        private boolean ended;

        @Override
        public int read() throws IOException {
            return available() > 0 || more() ? part.read() : -1;
        }

        @Override
        public int read(byte[] into, int at, int most) throws IOException {
            return available() > 0 || more() ? part.read(into, at, most) : -1;
        }

        @Override
        public int available() {
            return part.available();
        }

        /** Reads the next part of the line into the buffer. */
        private boolean more() throws IOException {
            while (!ended) {
                if (next == end && !fill()) {
                    throw endedInside();
                }
                int before = count;
                count(next);
                int got = count - before;
                int from = next;
                ended = from + got < end;
                next += ended ? got + 1 : got;
                checkControls(buffer, from, got, before);
                if (got > 0) {
                    part = new ByteArrayInputStream(buffer, from, got);
                    return true;
                }
            }
            return false;
        }
    }

    /**
     * Checks for valid UTF-8. Jackson would also accept other encodings, all of which contain zero bytes, and overlong
     * forms.
     */
    static void checkText(byte[] bytes, int start, int length) throws ProtocolException {
        checkBeginning(bytes, start, length);
        checkControls(bytes, start, length, 0);
        checkEncoding(bytes, start, length);
    }

    private static void checkBeginning(byte[] bytes, int start, int length) throws ProtocolException {
        if (length >= 3
                && bytes[start] == (byte) 0xEF
                && bytes[start + 1] == (byte) 0xBB
                && bytes[start + 2] == (byte) 0xBF) {
            throw new ProtocolException("a line must not begin with a byte order mark (got: one)");
        }
    }

    private static void checkControls(byte[] bytes, int start, int length, int before) throws ProtocolException {
        for (int k = start; k < start + length; k++) {
            byte b = bytes[k];
            if (b >= 0 && b < LEAST && b != '\t' && b != '\r') {
                throw new ProtocolException(String.format(
                        Locale.ROOT,
                        "a control character must be escaped, as in \\u0007 (got: %02X in byte %d)",
                        b,
                        before + k - start + 1));
            }
        }
    }

    private static void checkEncoding(byte[] bytes, int start, int length) throws ProtocolException {
        int plain = start;
        while (plain < start + length && bytes[plain] >= 0) {
            plain++;
        }
        if (plain == start + length) {
            return;
        }
        ByteBuffer rest = ByteBuffer.wrap(bytes, plain, start + length - plain);
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder(); // reports what is malformed
        CharBuffer chars = CharBuffer.allocate(Math.min(rest.remaining() + 1, BUFFER));
        CoderResult result = decoder.decode(rest, chars, true);
        while (result.isOverflow()) {
            chars.clear();
            result = decoder.decode(rest, chars, true);
        }
        if (result.isError()) {
            throw new ProtocolException(
                    "a line must be UTF-8 (got: other bytes at byte " + (rest.position() - start + 1) + ")");
        }
    }

    /** The buffer that contains the line; valid until the next read. */
    byte[] buffer() {
        return buffer;
    }

    /** The index in the buffer at which the line begins. */
    int start() {
        return start;
    }

    /** The number of bytes of the line in the buffer, without its line feed. */
    int length() {
        return length;
    }

    /** The number of bytes of the line read so far, without its line feed. */
    int count() {
        return count;
    }

    /** The number of this line, from 1. */
    int number() {
        return number;
    }

    /** Erases the line's contents from memory. */
    void wipe() {
        Arrays.fill(buffer, start, start + length, (byte) 0);
    }
}
