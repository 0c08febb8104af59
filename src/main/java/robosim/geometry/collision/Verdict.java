package robosim.geometry.collision;

/**
 * The result of a {@linkplain ContactQuery#decide query with a budget} about two objects.
 *
 * @param answer whether they touch or overlap
 * @param certainty {@code EXACT} if the answer is proven, which "no" always is; {@code UNCERTAIN} if nothing is decided
 *     yet or "yes" holds only to within rounding
 * @param low a lower bound of their distance, world units; 0 in contact, and if they are closer than doubles can
 *     resolve
 * @param high an upper bound of their distance: that of some two points of theirs, rounded up; {@code low <= high}
 * @param steps how many steps were taken
 */
public record Verdict(Answer answer, Certainty certainty, double low, double high, long steps) {
    /** Whether two objects touch or overlap. */
    public enum Answer {
        /** They have a point in common. */
        YES,
        /** They have none. */
        NO,
        /** The budget was spent before it was known; the bracket holds all the same. */
        UNDECIDED
    }
}
