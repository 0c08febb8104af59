package robosim.geometry.protocol;

import java.io.IOException;
import java.io.Serial;
import org.jspecify.annotations.Nullable;

/**
 * The bytes received are not a valid message, or the stream failed within one; the message says why, in one line. The
 * connection cannot be used any more.
 */
public final class ProtocolException extends IOException {
    @Serial
    private static final long serialVersionUID = 1;

    /** An exception with a human-readable reason. */
    public ProtocolException(String reason) {
        super(reason);
    }

    /** An exception with a human-readable reason and a cause. */
    public ProtocolException(String reason, @Nullable Throwable cause) {
        super(reason, cause);
    }

    /** A message for which there is not enough memory, although it may be valid. */
    public static ProtocolException noMemory(Throwable cause) {
        return new ProtocolException(
                "a message must fit into the module's free memory (got: " + cause
                        + "); ask for less at a time, or give the module more memory (-Xmx)",
                cause);
    }
}
