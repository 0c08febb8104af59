package robosim.geometry.protocol;

import java.io.IOException;
import java.io.Serial;
import org.jspecify.annotations.Nullable;

/** Bytes that are no message, or no longer one: what is wrong, in one line. The connection that they came by is lost. */
public final class ProtocolException extends IOException {
    @Serial
    private static final long serialVersionUID = 1;

    /** With a reason for people. */
    public ProtocolException(String reason) {
        super(reason);
    }

    /** With a reason for people and what led to it. */
    public ProtocolException(String reason, @Nullable Throwable cause) {
        super(reason, cause);
    }
}
