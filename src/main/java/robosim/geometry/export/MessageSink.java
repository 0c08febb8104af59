package robosim.geometry.export;

import java.io.IOException;
import java.util.List;

/** Receives messages of ROS 2 in the order of their times. */
interface MessageSink {
    /**
     * Adds a message.
     *
     * @param type  of the topic's first message
     * @param nanos when, not before the message before
     * @param value as {@link RosTypes} defines it
     */
    void write(String topic, String type, long nanos, List<?> value) throws IOException;

    /** Writes what belongs at the end of the file; the stream stays open. */
    void finish() throws IOException;
}
