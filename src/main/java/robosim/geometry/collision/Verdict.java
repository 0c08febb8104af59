package robosim.geometry.collision;

/**
 * What a {@linkplain ContactQuery#ask limited question} found out about two objects.
 *
 * @param answer whether they touch or overlap
 * @param certainty {@code EXACT} where the answer is proven, which "no" always is; {@code UNCERTAIN} where nothing is
 *     decided yet or "yes" is to within rounding only
 * @param low they are at least so far apart, world units; 0 in contact, and where they are apart by less than doubles tell
 * @param high they are at most so far apart: no more than two points of theirs, rounded up; {@code low <= high}
 * @param steps how many steps were taken
 */
public record Verdict(Answer answer, Certainty certainty, double low, double high, long steps) {
    /** Whether two objects touch or overlap. */
    public enum Answer {
        /** They have a point in common. */
        YES,
        /** They have none. */
        NO,
        /** The budget was spent before it was known; the bracket is true all the same. */
        UNDECIDED
    }
}
