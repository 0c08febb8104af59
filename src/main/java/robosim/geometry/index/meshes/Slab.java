package robosim.geometry.index.meshes;

/**
 * One axis of a ray against boxes: the parameters at which it enters and leaves the slab between two planes, the first
 * rounded down and the second up.
 *
 * <p>Entry and exit are {@code (plane - origin) * inverse}: three roundings of at most u = 2^-53 each, and a product that
 * underflows is off by 2^-1075 more. {@link #DOWN} and {@link #UP} cover four roundings, with their own.
 */
final class Slab {
    static final double DOWN = 1 - 0x1.8p-51;
    static final double UP = 1 + 0x1p-50;

    /** A component below this, of a direction scaled to about 1, cannot leave a slab; see {@link #SLACK}. */
    private static final double PARALLEL = 0x1p-1000;

    /**
     * More than the distance that a component below {@link #PARALLEL} covers over a parameter of 2^153, the longest way
     * through boxes up to 2^102.
     */
    private static final double SLACK = 0x1p-800;

    private double origin;
    private double inverse;
    private boolean parallel;
    private double low;
    private double high;
    private boolean backward;

    /** The power of two that scales a direction's greatest component to about 1. */
    static double scale(double greatest) {
        if (!(greatest > 0) || greatest == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "direction must be finite and not zero (got: greatest component " + greatest + ")");
        }
        return StrictMath.scalb(1.0, -Math.max(Math.getExponent(greatest), -1022));
    }

    void start(double from, double scaled, double component) {
        if (!Double.isFinite(from)) {
            throw new IllegalArgumentException("start must be finite (got: " + from + ")");
        }
        origin = from;
        backward = scaled < 0;
        parallel = Math.abs(scaled) < PARALLEL;
        inverse = parallel ? 0 : 1 / scaled;
        double slack = component == 0 ? 0 : SLACK;
        low = from - slack;
        high = from + slack;
    }

    boolean misses(double min, double max) {
        return parallel && (min > high || max < low);
    }

    double entry(double min, double max) {
        return parallel ? 0 : ((backward ? max : min) - origin) * inverse * DOWN - Double.MIN_VALUE;
    }

    // A negative exit is rounded away from zero, which does no harm: its sign is exact, and the ray ends before it.
    double exit(double min, double max) {
        return parallel
                ? Double.POSITIVE_INFINITY
                : ((backward ? min : max) - origin) * inverse * UP + Double.MIN_VALUE;
    }

    // The caller's parameter is that of the scaled direction times a power of two; only over- and underflow can round
    // it.

    /** Converts the caller's limit to a parameter of the scaled direction, rounded up. */
    static double inner(double limit, double unit) {
        return unit == 1 ? limit : limit / unit + Double.MIN_VALUE;
    }

    /** Converts a parameter of the scaled direction to the caller's, rounded down. */
    static double outer(double key, double unit) {
        double scaled = key * unit;
        return Math.min(Double.MAX_VALUE, scaled < Double.MIN_NORMAL ? Math.max(0, scaled - Double.MIN_VALUE) : scaled);
    }
}
