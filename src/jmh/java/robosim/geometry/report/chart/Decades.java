package robosim.geometry.report.chart;

/** Powers of ten as a person writes them. */
public final class Decades {
    private static final String SUPERSCRIPTS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
    private static final String[] SMALL = {"0.01", "0.1", "1", "10", "100", "1,000", "10,000"};
    private static final String[] NANOS = {"1 ns", "1 \u00b5s", "1 ms", "1 s"};

    private Decades() {}

    /** 0.01 to 10,000 in full, all others as a power. */
    public static String plain(int exponent) {
        return exponent >= -2 && exponent <= 4 ? SMALL[exponent + 2] : power(exponent);
    }

    /** 10 to an exponent. */
    public static String power(int exponent) {
        StringBuilder out = new StringBuilder(exponent < 0 ? "10\u207b" : "10");
        for (char digit : Integer.toString(Math.abs(exponent)).toCharArray()) {
            out.append(SUPERSCRIPTS.charAt(digit - '0'));
        }
        return out.toString();
    }

    /** A power of ten of nanoseconds, in ns, us, ms or s. */
    public static String nanos(int exponent) {
        int unit = Math.min(3, Math.max(0, Math.floorDiv(exponent, 3)));
        int rest = exponent - 3 * unit;
        if (rest < 0 || rest > 2) {
            return power(exponent) + " ns";
        }
        return NANOS[unit].replaceFirst("1", "1" + "0".repeat(rest));
    }

    /** The exponent of the greatest power of ten that is at most a value above 0. */
    public static int floor(double value) {
        int exponent = (int) Math.floor(Math.log10(value));
        // A logarithm may be off by a rounding where a power of ten is meant.
        return power10(exponent + 1) <= value ? exponent + 1 : power10(exponent) > value ? exponent - 1 : exponent;
    }

    /** The exponent of the least power of ten that is at least a value above 0. */
    public static int ceil(double value) {
        int floor = floor(value);
        return power10(floor) == value ? floor : floor + 1;
    }

    private static double power10(int exponent) {
        return Double.parseDouble("1e" + exponent);
    }
}
