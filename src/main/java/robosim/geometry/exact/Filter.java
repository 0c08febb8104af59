package robosim.geometry.exact;

/**
 * The one place through which every bound of a filter in front of an exact path passes: what a double's rounding may add
 * to a value of which only the sign is wanted.
 *
 * <p>Ordinarily a bound is what its kernel derives. For measurements and tests alone, the system property
 * {@value #PROPERTY}, read once, chooses something else for all of them:
 *
 * <table>
 * <caption>The values of the property</caption>
 * <tr><th>value</th><th>meaning</th><th>answers</th></tr>
 * <tr><td>{@code on}</td><td>the bounds as derived; the default</td><td>right</td></tr>
 * <tr><td>{@code doubt}</td><td>infinite bounds: every filter doubts, so that the next stage decides</td>
 *     <td>right</td></tr>
 * <tr><td>{@code off}</td><td>no filter and no expansion: big integers decide</td><td>right</td></tr>
 * <tr><td>{@code tenth}</td><td>a tenth of the bounds: a test that cannot tell is worth nothing</td>
 *     <td>some wrong</td></tr>
 * <tr><td>{@code alone}</td><td>bounds of zero: the sign of the plain double is believed; what exactness costs is what
 *     this saves</td><td>some wrong</td></tr>
 * </table>
 *
 * <p>Bounds are constants of their classes, so that the choice costs nothing once the code is compiled. Bounds of
 * certified answers, behind which no exact path stands, do not pass through here.
 */
public final class Filter {
    /** The system property that chooses. */
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

    private Filter() {}

    private static Mode read() {
        String chosen = System.getProperty(PROPERTY, "on");
        for (Mode mode : Mode.values()) {
            if (nameOf(mode).equals(chosen)) {
                if (mode != Mode.ON) {
                    System.getLogger(Filter.class.getName())
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
     * The bound that a filter shall use.
     *
     * @param derived a number or a factor above 0, as the kernel derives it
     */
    public static double bound(double derived) {
        return derived * MODE.factor;
    }

    /**
     * Whether every filter doubts. For filters that are no comparison with a bound; one that is needs not ask, as nothing
     * is beyond an infinite bound, nor beyond the NaN that it leaves of a magnitude of zero.
     */
    public static boolean isDoubting() {
        return MODE == Mode.DOUBT || MODE == Mode.OFF;
    }

    /** Whether expansions are left out too. */
    public static boolean isOff() {
        return MODE == Mode.OFF;
    }
}
