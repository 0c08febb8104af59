package robosim.geometry.exact;

/**
 * Every bound of a floating-point filter that stands before an exact path passes through this class. Such a bound is
 * the largest rounding error of a value of which only the sign is needed.
 *
 * <p>Normally a bound is used as its kernel derives it. For measurements and tests only, the system property {@value
 * #PROPERTY}, read once, changes all of them:
 *
 * <table>
 * <caption>The values of the property</caption>
 * <tr><th>value</th><th>meaning</th><th>answers</th></tr>
 * <tr><td>{@code on}</td><td>the bounds as derived; the default</td><td>right</td></tr>
 * <tr><td>{@code doubt}</td><td>infinite bounds: every filter is inconclusive, so the next stage decides</td>
 *     <td>right</td></tr>
 * <tr><td>{@code off}</td><td>no filter and no expansion: big integers decide</td><td>right</td></tr>
 * <tr><td>{@code tenth}</td><td>a tenth of the bounds: a test that still passes is worth nothing</td> <td>some
 *     wrong</td></tr>
 * <tr><td>{@code alone}</td><td>bounds of zero: the sign of the plain double is trusted; the time saved is the cost of
 *     exactness</td><td>some wrong</td></tr>
 * </table>
 *
 * <p>Bounds are static constants, so the choice costs nothing once the code is compiled. Bounds of certified answers,
 * which have no exact path to fall back on, do not pass through here.
 */
public final class FilterBound {
    /** The name of the system property. */
    public static final String PROPERTY = "robosim.geometry.filter";

    private enum Mode {
        ON(1),
        DOUBT(Double.POSITIVE_INFINITY),
        OFF(Double.POSITIVE_INFINITY),
        TENTH(0.1),
        ALONE(0);

        private final double factor;

        Mode(double factor) {
            this.factor = factor;
        }
    }

    private static final Mode MODE = read();

    private FilterBound() {}

    private static Mode read() {
        String chosen = System.getProperty(PROPERTY, "on");
        for (Mode mode : Mode.values()) {
            if (nameOf(mode).equals(chosen)) {
                if (mode != Mode.ON) {
                    System.getLogger(FilterBound.class.getName())
                            .log(
                                    System.Logger.Level.WARNING,
                                    "{0} is {1}: for measurements only",
                                    PROPERTY,
                                    nameOf(mode));
                }
                return mode;
            }
        }
        throw new IllegalArgumentException(PROPERTY + " must be on, doubt, off, tenth or alone (got: " + chosen + ")");
    }

    private static String nameOf(Mode mode) {
        return switch (mode) {
            case ON -> "on";
            case DOUBT -> "doubt";
            case OFF -> "off";
            case TENTH -> "tenth";
            case ALONE -> "alone";
        };
    }

    /**
     * The bound that a filter must use.
     *
     * @param derived the bound or factor, above 0, as the kernel derives it
     */
    public static double bound(double derived) {
        return derived * MODE.factor;
    }

    /**
     * Whether every filter must be inconclusive. Only filters that do not compare with a bound need to ask; for the
     * others nothing exceeds an infinite bound, or the NaN that it gives for a magnitude of zero.
     */
    public static boolean isDoubting() {
        return MODE == Mode.DOUBT || MODE == Mode.OFF;
    }

    /** Whether expansions are skipped too. */
    public static boolean isOff() {
        return MODE == Mode.OFF;
    }
}
