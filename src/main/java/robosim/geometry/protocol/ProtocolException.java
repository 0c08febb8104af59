package robosim.geometry.protocol;

import java.io.IOException;
import java.io.Serial;
import org.jspecify.annotations.Nullable;

/**
 * The bytes received are not a valid message, or the stream failed within one; the message says why, in one line. The
 * connection cannot be used any more, unless only {@linkplain #isAboutRequest the request} is wrong.
 */
public final class ProtocolException extends IOException {
    @Serial
    private static final long serialVersionUID = 1;

    private final boolean aboutRequest;

    /** An exception with a human-readable reason. */
    public ProtocolException(String reason) {
        this(reason, null);
    }

    /** An exception with a human-readable reason and a cause. */
    public ProtocolException(String reason, @Nullable Throwable cause) {
        this(reason, cause, false);
    }

    private ProtocolException(String reason, @Nullable Throwable cause, boolean aboutRequest) {
        super(reason, cause);
        this.aboutRequest = aboutRequest;
    }

    /** A message that could be parsed but is wrong, as by a value out of its range: an answer to it can say so. */
    public static ProtocolException ofRequest(String reason, @Nullable Throwable cause) {
        return new ProtocolException(reason, cause, true);
    }

    /** Whether the bytes can be parsed and only what they request is wrong, so that the next message can be read. */
    public boolean isAboutRequest() {
        return aboutRequest;
    }

    /** A message for which there is not enough memory, although it may be valid. */
    public static ProtocolException noMemory(Throwable cause) {
        return new ProtocolException(
                "a message must fit into the module's free memory (got: " + cause
                        + "); ask for less at a time, or give the module more memory (-Xmx)",
                cause);
    }
}
