package robosim.geometry;

/**
 * How many random cases a test asks. The numbers in the tests are those of a full run, which {@code .ci/run} makes on its last
 * JDK; one build asks half as many, as the pom says, and {@code -Dtest.effort=4} four times as many everywhere.
 */
public final class Effort {
    private static final double TIMES = Double.parseDouble(System.getProperty("test.effort", "1"));

    private Effort() {}

    /** So many cases in a full run. */
    public static int cases(int full) {
        return Math.max(1, (int) Math.round(full * TIMES));
    }
}
