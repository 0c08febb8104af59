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
import robosim.geometry.protocol.Limits;
import robosim.geometry.protocol.MessagePace;
import robosim.geometry.protocol.ProtocolException;

/**
 * Lines of UTF-8, each bounded before it is believed. A line that fits into the buffer is there whole; of a longer one its
 * beginning is, and the rest is read as it comes, so that no line has to be in memory at once.
 */
final class LineInput {
    /** Bytes of a line that are there whole; more than a hello may have. */
    static final int BUFFER = 2 * Limits.MAX_HELLO_BYTES;

    private static final int LEAST = ' ';

    private final InputStream source;
    private final MessagePace pace;
    private final byte[] buffer = new byte[BUFFER];

    /** The line, as far as it is in the buffer, then what has been read beyond it. */
    private int start;

    private int length;
    private int next;
    private int end;

    private int number;
    private int mostBytes;

    /** Bytes of the line that have been looked at. */
    private int count;

    private boolean whole;

    LineInput(InputStream source, MessagePace pace) {
        this.source = source;
        this.pace = pace;
    }

    /**
     * Waits for the next line, or the beginning of a long one, of which the last must have been read to its end.
     *
     * @return whether there is one; false at the end of the stream, between two lines
     * @throws ProtocolException where it has more bytes, is no text or lacks its end
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
        if (next >= BUFFER / 2) { // what has come of the line moves to the front, where it has room
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

    /** Counts the line's bytes in the buffer, from there on. */
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
     * The characters of a line that is not whole; to be read to their end before the next line is awaited. Reading fails
     * as {@link #await} does.
     */
    Reader characters() {
        InputStream rest = new Rest();
        return new InputStreamReader(rest, StandardCharsets.UTF_8.newDecoder()); // reports what is malformed
    }

    /** All bytes of a line that is not whole, where its characters have not been asked for. */
    byte[] gather() throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream(4 * BUFFER);
        new Rest().transferTo(all);
        byte[] bytes = all.toByteArray();
        checkEncoding(bytes, 0, bytes.length);
        return bytes;
    }

    /** A line that is longer than the buffer: what of it is there, then the rest. */
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

        /** Makes the next bytes of the line the part that is there. */
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

    /** Jackson would take other encodings than UTF-8 for JSON, all of which hold zeros, and overlong forms. */
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

    /** The buffer in which the line is, to be read at once. */
    byte[] buffer() {
        return buffer;
    }

    /** Where in the buffer the line begins. */
    int start() {
        return start;
    }

    /** Bytes of the line that are in the buffer, without its line feed. */
    int length() {
        return length;
    }

    /** Bytes of the line that have come, without its line feed. */
    int count() {
        return count;
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
