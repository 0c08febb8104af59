package robosim.geometry.protocol.channel;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;

/** Reads and writes the messages of one connection in one encoding. */
interface Codec {
    /** Reads the next bundle; null if the stream ends between two messages. */
    @Nullable
    Bundle read() throws ProtocolException;

    void write(Reply reply) throws IOException;

    /** Answers the last message with an error, if the encoding has one after which the conversation goes on; returns whether. */
    boolean refuse(String reason) throws IOException;

    /** The id of the last message that was read; null for a message without an id, as in Java serialization. */
    default @Nullable Object id() {
        return null;
    }

    /** The number of the message that is awaited or was read last, as the peer counts them, from 1. */
    long messageNumber();

    /** The size in bytes of the last message read. */
    int messageBytes();
}
