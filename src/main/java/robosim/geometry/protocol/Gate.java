package robosim.geometry.protocol;

import org.jspecify.annotations.Nullable;

/** Decides who may speak. Of a peer that it does not admit nothing is read but its hello. */
@FunctionalInterface
public interface Gate {
    /** Admits everybody. */
    Gate OPEN = secret -> true;

    /**
     * Whether the peer may go on. Called once for a connection; takes the same time for every wrong secret.
     *
     * @param secret what the peer's hello told; null where it told none, as a peer that speaks Java serialization
     */
    boolean admits(@Nullable String secret);
}
