package robosim.geometry.protocol.pace;

/** Learns from a reader whether a pause of its stream would be between two messages or inside a message. */
public interface MessagePace {
    /** Does nothing: for a stream without timeouts. */
    MessagePace NONE = new MessagePace() {
        @Override
        public void idle() {}

        @Override
        public void begun() {}
    };

    /** The next byte begins a message and may come at any time. */
    void idle();

    /** A message has begun: the rest of it is due. */
    void begun();

    /**
     * The first byte of a connection is awaited. If the peer may itself be waiting for our stream header, a stream with
     * timeouts ends this wait once, by an {@link java.io.InterruptedIOException}, after which reading may continue;
     * {@link #idle} follows.
     */
    default void opening() {
        idle();
    }
}
