package robosim.geometry;

/**
 * How many random cases a test asks. The numbers in the tests are those of a full run, {@code
 * -Dtest.effort=1}; an ordinary build asks an eighth, as the pom says, and {@code .ci/run} a quarter on the newest JDK.
 */
public final class Effort {
    private static final double TIMES = Double.parseDouble(System.getProperty("test.effort", "1"));

    private Effort() {}

    /** So many cases in a full run. */
    public static int cases(int full) {
        return Math.max(1, (int) Math.round(full * TIMES));
    }

    /** So many cases in a full run, and never fewer than what a test needs in order to say anything. */
    public static int cases(int full, int least) {
        return Math.max(least, cases(full));
    }

    /** So many cases in a full run of those that take long, and the square of the share in others: a 64th in an ordinary build. */
    public static int costly(int full, int least) {
        return Math.max(least, (int) Math.round(full * TIMES * Math.min(1, TIMES)));
    }

    /** The step through the numbers below a count: 1 in a full run, else odd, so that evens and odds are both asked. */
    public static int stride(int full) {
        return TIMES >= 1 ? 1 : Math.min(full, (int) Math.round(1 / TIMES) | 1);
    }
}
