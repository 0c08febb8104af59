package robosim.geometry.proof;

import robosim.geometry.check.Checks;

/** A claim and what it can be checked with: {@link ProofChecker} decides whether it holds. */
public record Proof(Claim claim, Witness witness) {
    /** Refuses null. */
    public Proof {
        Checks.present("claim", claim);
        Checks.present("witness", witness);
    }

    /** Where a proof fails. */
    static final class Flaw extends RuntimeException {
        private static final long serialVersionUID = 1;

        Flaw(String reason) {
            super(reason, null, false, false);
        }

        static void unless(boolean holds, String reason) {
            if (!holds) {
                throw new Flaw(reason);
            }
        }
    }
}
