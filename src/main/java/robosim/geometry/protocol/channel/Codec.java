package robosim.geometry.protocol.channel;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;

/** One encoding over one connection. */
interface Codec {
    /** The next bundle; null at the end of the stream, between two messages. */
    @Nullable
    Bundle read() throws ProtocolException;

    void write(Reply reply) throws IOException;

    /** Bytes of the message that was read last. */
    int messageBytes();
}
