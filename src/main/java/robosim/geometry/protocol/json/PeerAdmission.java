package robosim.geometry.protocol.json;

import org.jspecify.annotations.Nullable;
import robosim.geometry.check.Checks;
import robosim.geometry.protocol.ProtocolException;

/** Decides which peers are admitted. From a peer that is not, only the hello is read. */
@FunctionalInterface
public interface PeerAdmission {
    /** Admits every peer. */
    PeerAdmission OPEN = secret -> true;

    /**
     * Whether the peer is admitted. Called once per connection; must take the same time for every wrong secret.
     *
     * @param secret the secret in the peer's hello; null if there is none, as always in Java serialization
     * @throws ProtocolException if the peer would be admitted, but there is no room
     */
    boolean admits(@Nullable String secret) throws ProtocolException;

    /**
     * Gives an admitted JSON peer a session that outlives its connection, or takes up one that did.
     *
     * @param token of the session; empty for a new one
     * @return null for a new session that ends with its connection, as sessions are not kept here
     * @throws ProtocolException if no session is kept for that token
     */
    default @Nullable Resumption resume(String token) throws ProtocolException {
        if (token.isEmpty()) {
            return null;
        }
        throw new ProtocolException(
                "this module keeps no sessions, so there is none to resume; start it with --resume, or"
                        + " begin a new one");
    }

    /**
     * What a peer learns of a session that can be resumed.
     *
     * @param token  identifies it, and is as good as a secret
     * @param lastId the id of the last request that was carried out; null for a new session, or if the request had none
     */
    record Resumption(String token, @Nullable Object lastId) {
        /** Refuses a token that is null. */
        public Resumption {
            Checks.present("token", token);
        }

        @Override
        public String toString() {
            return "resumption"; // the token appears nowhere
        }
    }
}
