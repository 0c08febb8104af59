package robosim.geometry.net;

import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;

/**
 * Sees what a session does, on the thread that does it, before the answer is sent. What a listener throws ends the
 * session's connection.
 */
public interface SessionListener {
    /** Sees nothing. */
    SessionListener NONE = new SessionListener() {};

    /**
     * The session begins. Its world may be asked from the other methods, on their thread.
     */
    default void opened(Session session) {}

    /** A request came and is about to be carried out. */
    default void asked(Bundle request) {}

    /** A move of a moveable object was tried; {@code result} tells what blocked it. */
    default void tried(MoveRequest request, MoveResult result) {}

    /**
     * A request was carried out.
     *
     * @param request     what came
     * @param answer      what will be sent; null after an InitBundle
     * @param nanoseconds the time between, without reading and writing
     */
    default void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {}

    /**
     * A request was carried out; tells {@link #answered} unless it is overridden.
     *
     * @param request     what came
     * @param reply       what will be sent, with what was refused and why; null after an InitBundle
     * @param nanoseconds the time between, without reading and writing
     */
    default void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
        answered(request, reply == null ? null : reply.bundle(), nanoseconds);
    }

    /** The connection is over; nothing more will be told. */
    default void ended() {}

    /** This listener and then another one. */
    default SessionListener and(SessionListener other) {
        return new TwoListeners(this, other);
    }
}
