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

    /** A message for which there is no memory: no fault of the module, nor of the message's form. */
    public static ProtocolException noMemory(Throwable cause) {
        return new ProtocolException(
                "a message must fit into the memory that the module has left (got: " + cause
                        + "); ask for less at a time, or give the module more memory (-Xmx)",
                cause);
    }
}
