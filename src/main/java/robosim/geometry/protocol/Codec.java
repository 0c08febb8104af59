package robosim.geometry.protocol;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** One encoding over one connection. */
interface Codec {
    /** The next bundle; null at the end of the stream, between two messages. */
    @Nullable
    Bundle read() throws ProtocolException;

    void write(Reply reply) throws IOException;

    /** Bytes of the message that was read last. */
    int messageBytes();
}
