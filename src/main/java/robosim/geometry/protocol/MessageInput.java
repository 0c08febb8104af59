package robosim.geometry.protocol;

import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectStreamConstants;
import org.jspecify.annotations.Nullable;

/**
 * The bytes below an object stream: buffered, and counted per message, because the object stream only counts over its
 * whole life.
 */
final class MessageInput extends InputStream {
    private static final int NONE = -1;

    private final InputStream source;
    private final MessagePace pace;
    private final byte[] buffer = new byte[8192];
    private int next;
    private int end;
    private int count;

    /** Whether a reset code was read while the stream was idle, to be passed on with the next message. */
    private boolean resetFirst;

    private boolean afterReset;
    private boolean inside;
    private @Nullable IOException failure;

    MessageInput(InputStream source, MessagePace pace) {
        this.source = source;
        this.pace = pace;
    }

    /**
     * Waits for the next message.
     *
     * @return its first byte, which is not consumed, or -1 at the end of the stream
     */
    int awaitMessage() throws IOException {
        pace.idle();
        inside = false;
        int first = peek();
        while (first == ObjectStreamConstants.TC_RESET) {
            resetFirst = true; // a sender writes it after a message; the next one may come much later
            next++;
            first = peek();
        }
        if (first != NONE) {
            pace.begun();
        }
        inside = true;
        count = 0;
        afterReset = resetFirst;
        return first;
    }

    /** The failure of the stream itself; null if there was none. */
    @Nullable
    IOException failure() {
        return failure;
    }

    /** Whether the sender reset its stream before this message, which then does not refer to earlier ones. */
    boolean afterReset() {
        return afterReset;
    }

    /** Whether a message has begun. */
    boolean isInside() {
        return inside;
    }

    /** The number of bytes of the message so far. */
    int count() {
        return count;
    }

    private int peek() throws IOException {
        return next < end || fill() ? buffer[next] & 0xff : NONE;
    }

    private boolean fill() throws IOException {
        int got;
        try {
            got = source.read(buffer, 0, buffer.length);
        } catch (IOException e) {
            failure = e;
            throw e;
        }
        next = 0;
        end = Math.max(got, 0);
        return got > 0;
    }

    /** An object stream reads single type codes this way, but never the bytes of a string or an array. */
    @Override
    public int read() throws IOException {
        if (resetFirst) {
            resetFirst = false;
            return ObjectStreamConstants.TC_RESET;
        }
        int value = peek();
        if (value == ObjectStreamConstants.TC_LONGSTRING) {
            throw new ProtocolException(
                    "a string must have at most " + MessageLimits.MAX_TEXT_BYTES + " bytes (got: more)");
        }
        if (value != NONE) {
            take(1);
        }
        return value;
    }

    @Override
    public int read(byte[] into, int at, int length) throws IOException {
        if (length == 0) {
            return 0;
        }
        if (resetFirst) {
            resetFirst = false;
            into[at] = ObjectStreamConstants.TC_RESET;
            return 1;
        }
        if (peek() == NONE) {
            return NONE;
        }
        int taken = Math.min(length, end - next);
        System.arraycopy(buffer, next, into, at, taken);
        take(taken);
        return taken;
    }

    private void take(int bytes) throws IOException {
        next += bytes;
        count += bytes;
        if (count > MessageLimits.MAX_MESSAGE_BYTES) {
            throw new ProtocolException(
                    "a message must have at most " + MessageLimits.MAX_MESSAGE_BYTES + " bytes (got: more)");
        }
    }

    @Override
    public int available() {
        return end - next;
    }
}
