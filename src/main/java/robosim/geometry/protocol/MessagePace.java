package robosim.geometry.protocol;

/** Told by a reader whether a pause of its stream would be one between two messages or one inside a message. */
public interface MessagePace {
    /** For a stream without a clock. */
    MessagePace NONE = new MessagePace() {
        @Override
        public void idle() {}

        @Override
        public void begun() {}
    };

    /** The next byte, whenever it comes, begins a message. */
    void idle();

    /** A message has begun: its other bytes are due. */
    void begun();

    /**
     * The first byte of a connection is awaited. A stream with a clock ends this wait once, when it has taken too long
     * for a peer that may itself be waiting for our stream header, by an {@link java.io.InterruptedIOException}, after
     * which it can be read on; {@link #idle} follows.
     */
    default void opening() {
        idle();
    }
}
