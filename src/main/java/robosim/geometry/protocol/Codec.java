package robosim.geometry.protocol;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** Reads and writes the messages of one connection in one encoding. */
interface Codec {
    /** Reads the next bundle; null if the stream ends between two messages. */
    @Nullable
    Bundle read() throws ProtocolException;

    void write(Reply reply) throws IOException;

    /** The size of the message that was read last, bytes. */
    int messageBytes();
}
