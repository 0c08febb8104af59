package robosim.geometry.proof;

import robosim.geometry.check.Checks;

/** A claim and what it can be checked with: {@link ProofChecker} decides whether it holds. */
public record Proof(Claim claim, Witness witness) {
    /** Refuses null. */
    public Proof {
        Checks.present("claim", claim);
        Checks.present("witness", witness);
    }
}
