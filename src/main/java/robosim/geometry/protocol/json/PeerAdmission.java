package robosim.geometry.protocol.json;

import org.jspecify.annotations.Nullable;
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
}
