package robosim.geometry.proof;

import robosim.geometry.check.Checks;

/**
 * A claim and what it can be checked with: {@link ProofChecker} decides whether it holds, and so can a program in another language,
 * which reads {@link #json}.
 */
public final class Proof {
    private final Claim claim;
    private final Witness witness;

    Proof(Claim claim, Witness witness) {
        this.claim = Checks.present("claim", claim);
        this.witness = Checks.present("witness", witness);
    }

    /** What is proved. */
    public Claim claim() {
        return claim;
    }

    Witness witness() {
        return witness;
    }

    /** The proof as JSON; it is about a scene that is given elsewhere. */
    public String json() {
        return ProofJson.of(this);
    }

    /** A scene as JSON, for proofs that are given elsewhere. */
    public static String jsonOf(Scene scene) {
        return ProofJson.of(scene);
    }

    /** The proof and the scene that it is about as one object of JSON, for programs in other languages; see {@code docs/proofs.md}. */
    public String json(Scene scene) {
        return ProofJson.of(this, scene);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Proof that && claim.equals(that.claim) && witness.equals(that.witness);
    }

    @Override
    public int hashCode() {
        return 31 * claim.hashCode() + witness.hashCode();
    }

    @Override
    public String toString() {
        return "Proof[claim=" + claim + ", witness=" + witness + "]";
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
