package robosim.geometry;

/** The rules for what a caller of a world hands in; each message names the argument and its value. */
final class Arguments {
    /** The largest coordinate. */
    private static final double LIMIT = 0x1p100;

    private Arguments() {}

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    static double worldSize(String argument, double value) {
        if (!(value > 0 && value <= 2 * LIMIT)) {
            throw new IllegalArgumentException(argument + " must be above 0 and at most 2^101 (got: " + value + ")");
        }
        return value;
    }

    static double coordinate(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value;
    }

    static double angle(String argument, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException(argument + " must be a finite angle in degrees (got: " + degrees + ")");
        }
        return degrees;
    }

    static double clearance(double value) {
        if (!(value >= 0 && value <= LIMIT)) {
            throw new IllegalArgumentException("clearance must be from 0 to 2^100 (got: " + value + ")");
        }
        return value;
    }

    static int count(int value) {
        if (value < 0) {
            throw new IllegalArgumentException("count must be at least 0 (got: " + value + ")");
        }
        return value;
    }

    /** A blind range and a range; only the latter may be infinite. */
    static void range(double min, double max) {
        if (!(min >= 0 && min <= LIMIT)) {
            throw new IllegalArgumentException("min must be from 0 to 2^100 (got: " + min + ")");
        }
        if (!(max >= min)) {
            throw new IllegalArgumentException("max must be at least min, " + min + " (got: " + max + ")");
        }
    }

    /** The opening angle of a beam. */
    static double width(double degrees) {
        if (!(degrees >= 0 && degrees < 180)) {
            throw new IllegalArgumentException(
                    "width must be from 0 up to, not including, 180 degrees (got: " + degrees + ")");
        }
        return degrees;
    }
}
