package robosim.geometry.stress;

import robosim.geometry.reference.Quantity.Doubt;
import robosim.geometry.reference.Truth;

/** The truth about cases: coarse where that is certain, else exact; every thousandth both, and they must agree. */
final class Decision {
    private static final int CHECK_EVERY = 1000;

    private long asked;
    private long doubts;
    private long checks;

    int of(Family family, Case question) {
        asked++;
        int quick;
        try {
            quick = family.truth(question, Truth.COARSE);
        } catch (Doubt doubt) {
            doubts++;
            return family.truth(question, Truth.EXACT);
        }
        if (asked % CHECK_EVERY == 0) {
            checks++;
            int exact = family.truth(question, Truth.EXACT);
            if (exact != quick) {
                throw new AssertionError("the oracle's own filter is wrong: " + family.name() + " says " + quick
                        + ", exactly " + exact + "\n" + question.paste());
            }
        }
        return quick;
    }

    /** How many were beyond the coarse numbers. */
    long doubts() {
        return doubts;
    }

    long checks() {
        return checks;
    }
}
