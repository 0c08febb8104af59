package robosim.geometry.junit;

/**
 * How far a robot is from a goal.
 *
 * @param stages number of parts of the goal that are still ahead; 0 where it is reached
 * @param amount what is missing of the present part, in its own unit
 * @param words  how the amount is read: {@code "%s short of it"}
 */
record Shortfall(int stages, double amount, String words) {
    static final Shortfall NONE = new Shortfall(0, 0, "%s short of it");

    boolean isNone() {
        return stages == 0;
    }

    boolean isLessThan(Shortfall other) {
        return stages < other.stages || (stages == other.stages && amount < other.amount);
    }

    /** This with more of the goal ahead. */
    Shortfall before(int more) {
        return new Shortfall(stages + more, amount, words);
    }

    @Override
    public String toString() {
        return words.formatted(Words.found(amount));
    }
}
