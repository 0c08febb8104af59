package robosim.geometry;

/**
 * How many random cases a test asks. The numbers in the tests are those of an ordinary build; {@code -Dtest.effort=4} asks four
 * times as many everywhere.
 */
public final class Effort {
    private static final double TIMES = Double.parseDouble(System.getProperty("test.effort", "1"));

    private Effort() {}

    /** So many cases in an ordinary build. */
    public static int cases(int ordinary) {
        return Math.max(1, (int) Math.round(ordinary * TIMES));
    }
}
