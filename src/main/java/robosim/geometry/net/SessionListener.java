package robosim.geometry.net;

import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;

/**
 * Observes what a session does, on the session's thread, before the answer is sent. An exception from a listener ends
 * the session's connection.
 */
public interface SessionListener {
    /** A listener that does nothing. */
    SessionListener NONE = new SessionListener() {};

    /**
     * Called when the session begins. Its world may be queried in the other methods, on their thread.
     */
    default void opened(Session session) {}

    /** Called when a request has come, before it is carried out. */
    default void requested(Bundle request) {}

    /**
     * Called when a move of a moveable object has been tried, in a bundle or as a {@code WorldRequest.Go}; {@code result} says
     * what blocked it, if anything. Moves to a contact and along it are told by {@link #replied} alone.
     */
    default void tried(MoveRequest request, MoveResult result) {}

    /**
     * A request was carried out.
     *
     * @param request     the request
     * @param answer      the answer that will be sent; null after an InitBundle
     * @param nanoseconds the time between, without reading and writing
     */
    default void answered(Bundle request, @Nullable Bundle answer, long nanoseconds) {}

    /**
     * A request was carried out; tells {@link #answered} unless it is overridden.
     *
     * @param request     the request
     * @param reply       the answer that will be sent, with what was refused and why; null after an InitBundle
     * @param nanoseconds the time between, without reading and writing
     */
    default void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
        answered(request, reply == null ? null : reply.bundle(), nanoseconds);
    }

    /** Called when the connection is over; no further calls follow. */
    default void ended() {}

    /** A listener that calls this one and then another. */
    default SessionListener and(SessionListener other) {
        return new TwoListeners(this, other);
    }
}
