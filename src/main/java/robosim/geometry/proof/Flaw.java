package robosim.geometry.proof;

/** Where a proof fails. */
final class Flaw extends RuntimeException {
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
