package robosim.geometry.proof;

import org.jspecify.annotations.Nullable;

/**
 * What came of an attempt to prove a claim. A claim that is not proved may hold all the same.
 *
 * @param claim  what was to be proved
 * @param proof  the proof, for a {@link ProofChecker} to decide; null if none was found
 * @param reason why none was found; empty if one was
 */
public record Attempt(Claim claim, @Nullable Proof proof, String reason) {
    static Attempt of(Claim claim, Witness witness) {
        return new Attempt(claim, new Proof(claim, witness), "");
    }

    static Attempt failed(Claim claim, String reason) {
        return new Attempt(claim, null, reason);
    }

    /** Whether a proof was found. */
    public boolean isProved() {
        return proof != null;
    }
}
