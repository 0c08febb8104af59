package robosim.geometry.net;

import org.jspecify.annotations.Nullable;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;

/** Calls two listeners, one after the other. */
record TwoListeners(SessionListener first, SessionListener second) implements SessionListener {
    TwoListeners {
        Checks.present("first", first);
        Checks.present("second", second);
    }

    @Override
    public void opened(Session session) {
        first.opened(session);
        second.opened(session);
    }

    @Override
    public void requested(Bundle request) {
        first.requested(request);
        second.requested(request);
    }

    @Override
    public void tried(MoveRequest request, MoveResult result) {
        first.tried(request, result);
        second.tried(request, result);
    }

    @Override
    public void replied(Bundle request, @Nullable Reply reply, long nanoseconds) {
        first.replied(request, reply, nanoseconds);
        second.replied(request, reply, nanoseconds);
    }

    @Override
    public void ended() {
        try {
            first.ended();
        } finally {
            second.ended();
        }
    }
}
